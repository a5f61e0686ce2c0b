// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/io/atomic_file.h>
#include <rtob/io/map_server.h>

#include <array>
#include <charconv>
#include <filesystem>
#include <stdexcept>

namespace rtob
{
namespace
{
std::string shortest(double value)
{
    std::array<char, 32> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end.ptr};
}

void write_pgm(const std::string& file, const OccupancyImage& image)
{
    AtomicFile out(file);
    const std::string header =
        "P5\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n255\n";
    out.stream() << header;
    out.stream().write(
        reinterpret_cast<const char*>(image.pixels.data()),
        static_cast<std::streamsize>(image.pixels.size()));
    out.commit();
}

void write_yaml(const std::string& file, const std::string& image_name, const OccupancyImage& image)
{
    const Pose2& origin = image.origin;
    AtomicFile out(file);
    out.stream() << "image: " << image_name << "\n"
                 << "mode: trinary\n"
                 << "resolution: " << shortest(image.resolution_m) << "\n"
                 << "origin: [" << shortest(origin.x) << ", " << shortest(origin.y) << ", "
                 << shortest(origin.yaw) << "]\n"
                 << "negate: 0\n"
                 << "occupied_thresh: 0.65\n"
                 << "free_thresh: 0.196\n";
    out.commit();
}
}  // namespace

void write_map_server(const std::string& stem, const OccupancyImage& image)
{
    if (image.width == 0 || image.height == 0 ||
        image.pixels.size() != image.width * image.height || !(image.resolution_m > 0))
        throw std::invalid_argument(
            stem +
            ": an occupancy image needs width x height pixels, at least one, and a "
            "resolution above zero");
    // The picture first: who finds the .yaml finds what it names.
    write_pgm(stem + ".pgm", image);
    write_yaml(stem + ".yaml", std::filesystem::path(stem).filename().string() + ".pgm", image);
}
}  // namespace rtob
