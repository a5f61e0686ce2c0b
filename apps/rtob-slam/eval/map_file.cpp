// SPDX-License-Identifier: BSD-3-Clause
#include "eval/map_file.h"

#include <array>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace rtob
{
namespace
{
/// The lines of a PLY file. MRPT's reader is not used: a header that is cut off crashes it.
class PlyLines
{
 public:
    explicit PlyLines(const std::string& file) : file_(file), in_(file, std::ios::binary)
    {
        if (!in_) throw std::runtime_error(file + " cannot be read");
    }

    std::string next()
    {
        std::string line;
        if (!std::getline(in_, line)) refuse("the file ends here");
        ++number_;
        if (!line.empty() && line.back() == '\r') line.pop_back();
        return line;
    }
    [[noreturn]] void refuse(const std::string& what) const
    {
        throw std::runtime_error(
            file_ + ", line " + std::to_string(number_) + ": " + what +
            ". Name the map.ply that rtob-slam run wrote, or another PLY file in ASCII whose "
            "vertices begin with x and y.");
    }

 private:
    std::string file_;
    std::ifstream in_;
    std::size_t number_ = 0;
};

/// Reads up to the header's end. @return the number of points
std::size_t read_header(PlyLines& lines)
{
    bool is_ascii = false;
    std::size_t points = 0, elements = 0;
    std::string names;  // of the vertices' properties
    for (auto line = lines.next(); line != "end_header"; line = lines.next())
    {
        std::istringstream words(line);
        std::string key, first, second;
        words >> key >> first >> second;
        if (key == "format") is_ascii = first == "ascii";
        if (key == "element" && elements++ == 0 && first == "vertex")
            std::istringstream(second) >> points;
        if (key == "property" && elements == 1) names += second + " ";
    }
    if (!is_ascii) lines.refuse("this PLY file is not in ASCII");
    if (points == 0) lines.refuse("the map holds no points");
    if (names.rfind("x y ", 0) != 0) lines.refuse("its vertices do not begin with x and y");
    return points;
}
}  // namespace

bool is_ply_file(const std::string& file)
{
    constexpr std::string_view mark = "ply";
    std::array<char, mark.size()> beginning{};
    std::ifstream in(file, std::ios::binary);
    return in.read(beginning.data(), beginning.size()) &&
           std::string_view(beginning.data(), beginning.size()) == mark;
}

Points read_ply_points(const std::string& file)
{
    PlyLines lines(file);
    const std::size_t count = read_header(lines);
    Points points;
    for (std::size_t i = 0; i < count; ++i)
    {
        std::istringstream numbers(lines.next());
        float x = 0, y = 0;
        if (!(numbers >> x >> y)) lines.refuse("no x and y");
        points.add(x, y);
    }
    return points;
}
}  // namespace rtob
