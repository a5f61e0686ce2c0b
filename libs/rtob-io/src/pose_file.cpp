// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/io/log_reader.h>
#include <rtob/io/pose_file.h>
#include <rtob/io/tum.h>

#include <cmath>
#include <filesystem>
#include <optional>

#include "data_lines.h"
#include "log_kind.h"
#include "rawlog_poses.h"

namespace rtob
{
namespace
{
constexpr const char* known_kinds =
    "Name a TUM file (time_s x y z qx qy qz qw), relations (t1 t2 x y z roll pitch yaw), planar "
    "poses (time_s x y yaw) or a rawlog with poses";
constexpr std::size_t tum_words = 8, planar_words = 4;

/// The numbers of a line; throws FieldError where one is none.
std::vector<double> numbers_of(std::string_view line)
{
    std::vector<double> numbers;
    for (TextFields words(line), fields(line); !words.next_word().empty();)
        numbers.push_back(fields.number("of a pose"));
    return numbers;
}

/// What a line of eight numbers may be: one of them, both, or neither.
struct LineFit
{
    bool tum = false, relation = false;
};

LineFit fit_of_eight(const std::vector<double>& n)
{
    for (const double number : n)
        if (!std::isfinite(number)) return {};
    constexpr double norm_tolerance = 0.01;  // as in reading TUM
    const double norm = std::sqrt(n[4] * n[4] + n[5] * n[5] + n[6] * n[6] + n[7] * n[7]);
    return {std::abs(norm - 1) <= norm_tolerance, n[4] == 0 && n[5] == 0 && n[6] == 0};
}

PoseFileKind text_kind(const std::string& file)
{
    std::optional<PoseFileKind> kind;
    bool has_lines = false, may_be_tum = false;
    const auto take_eight = [&](const std::vector<double>& numbers)
    {
        const auto fit = fit_of_eight(numbers);
        may_be_tum = may_be_tum || fit.tum;
        if (fit.tum != fit.relation) kind = fit.tum ? PoseFileKind::Tum : PoseFileKind::Relations;
    };
    for_each_data_line(
        file, known_kinds,
        [&](std::string_view line)
        {
            const auto numbers = numbers_of(line);
            has_lines = true;
            if (numbers.size() == planar_words)
                kind = PoseFileKind::Planar;
            else if (numbers.size() == tum_words)
                take_eight(numbers);
            else
                throw FieldError("a line of " + std::to_string(numbers.size()) + " numbers");
            return !kind;
        });
    if (!has_lines) throw LogError(file, "", "the file holds no poses", known_kinds);
    if (kind) return *kind;
    if (may_be_tum) return PoseFileKind::Tum;  // a vehicle that never turns
    throw LogError(
        file, "",
        "its lines of eight numbers are neither TUM (a unit quaternion at the end) nor relations "
        "in the plane (z, roll and pitch 0)",
        known_kinds);
}

StampedPose2 parse_planar(std::string_view line)
{
    TextFields fields(line);
    StampedPose2 stamped;
    stamped.time_s = fields.finite_number("time");
    stamped.pose.x = fields.finite_number("x");
    stamped.pose.y = fields.finite_number("y");
    stamped.pose.yaw = wrap_angle(fields.finite_number("yaw"));
    if (!fields.next_word().empty()) throw FieldError("the line goes on after its four numbers");
    return stamped;
}

std::vector<StampedPose2> read_planar(const std::string& file)
{
    std::vector<StampedPose2> poses;
    for_each_data_line(
        file, "A line of planar poses is: time_s x y yaw",
        [&](std::string_view line)
        {
            poses.push_back(parse_planar(line));
            return true;
        });
    return poses;
}

std::vector<StampedPose2> read_poses_of_rawlog(const std::string& file)
{
    auto poses = read_rawlog_poses(file);
    if (!poses.empty()) return poses;
    const std::string beside = file + ".GT.txt";
    if (std::filesystem::exists(beside)) return read_planar(beside);
    throw LogError(
        file, "", "the rawlog holds no poses (CObservationRobotPose)",
        "Name one that does, or put lines of time_s x y yaw into " + beside);
}
}  // namespace

PoseFileKind pose_file_kind(const std::string& file)
{
    constexpr std::size_t looked_at_bytes = 256;
    try
    {
        ByteSource bytes(file);
        const auto beginning = bytes.peek().substr(0, looked_at_bytes);
        if (beginning.empty()) throw ByteSourceError("the packed file holds nothing", known_kinds);
        const auto kind = log_kind_of(beginning);
        if (kind == LogKind::Rawlog) return PoseFileKind::Rawlog;
        if (kind == LogKind::Unknown)
            throw ByteSourceError("this holds neither text nor MRPT objects", known_kinds);
    }
    catch (const ByteSourceError& error)
    {
        throw LogError(file, "", error.what(), error.fix());
    }
    return text_kind(file);
}

std::vector<StampedPose2> read_poses(const std::string& file)
{
    switch (pose_file_kind(file))
    {
        case PoseFileKind::Rawlog:
            return read_poses_of_rawlog(file);
        case PoseFileKind::Tum:
            return read_tum(file);
        case PoseFileKind::Planar:
            return read_planar(file);
        case PoseFileKind::Relations:
            break;
    }
    throw LogError(file, "", "relations stand where poses are needed", "Name a trajectory");
}
}  // namespace rtob
