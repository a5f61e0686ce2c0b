// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/map/map_export.h>
#include <rtob/map/option_text.h>
#include <rtob/map/rtob_map.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace rtob
{
namespace
{
[[noreturn]] void fail(const std::string& file, const std::string& why)
{
    throw std::runtime_error("cannot write " + file + (why.empty() ? "" : ": " + why));
}

std::ofstream opened(const std::string& file)
{
    std::ofstream out(file, std::ios::binary);
    if (!out) fail(file, std::strerror(errno));
    return out;
}

void close(std::ofstream& out, const std::string& file)
{
    out.close();
    if (!out) fail(file, std::strerror(errno));
}

/// option_text: the shortest decimals that read back as the same number, in every locale.
void write_points(std::ostream& out, const mrpt::maps::CPointsMap& points_map)
{
    for (std::size_t i = 0; i < points_map.size(); ++i)
    {
        float x = 0, y = 0, z = 0;
        points_map.getPointFast(i, x, y, z);
        out << option_text(x) << ' ' << option_text(y) << ' ' << option_text(z) << '\n';
    }
}
}  // namespace

void save_ply(const mrpt::maps::CPointsMap& points_map, const std::string& file)
{
    std::ofstream out = opened(file);
    out << "ply\nformat ascii 1.0\nelement vertex " << points_map.size()
        << "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
    write_points(out, points_map);
    close(out, file);
}

void save_pcd(const mrpt::maps::CPointsMap& points_map, const std::string& file)
{
    std::ofstream out = opened(file);
    out << "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH "
        << points_map.size() << "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " << points_map.size()
        << "\nDATA ascii\n";
    write_points(out, points_map);
    close(out, file);
}

void save_points_text(const mrpt::maps::CPointsMap& points_map, const std::string& file)
{
    std::ofstream out = opened(file);
    write_points(out, points_map);
    close(out, file);
}

void save_scans_text(const ScanTable& scans, const std::string& file)
{
    std::ofstream out = opened(file);
    out << "# time_s x_m y_m yaw_rad points\n";
    for (std::size_t k = 0; k < scans.size(); ++k)
    {
        const Pose2 pose = scans.pose(k);
        out << option_text(scans.time(k)) << ' ' << option_text(pose.x) << ' '
            << option_text(pose.y) << ' ' << option_text(pose.yaw) << ' '
            << scans.firstPoint(k + 1) - scans.firstPoint(k) << '\n';
    }
    close(out, file);
}

void RtobMap::saveMetricMapRepresentationToFile(const std::string& prefix) const
{
    save_points_text(*this, prefix + ".txt");
    save_ply(*this, prefix + ".ply");
    save_scans_text(scans(), prefix + "_scans.txt");
}
}  // namespace rtob
