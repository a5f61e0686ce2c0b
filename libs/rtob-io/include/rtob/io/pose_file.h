// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

#include <string>
#include <vector>

namespace rtob
{
/// The files that poses come in; plain or packed by gzip or bzip2.
enum class PoseFileKind
{
    Rawlog,    ///< of MRPT
    Tum,       ///< lines `time_s x y z qx qy qz qw`
    Planar,    ///< lines `time_s x y yaw` (m, rad), as in the .GT.txt files of MRPT's data sets
    Relations  ///< lines `t1 t2 x y z roll pitch yaw`
};

/// Tells by the content. TUM and relations both have eight numbers a line: the first line that is
/// just one of the two decides (a unit quaternion; or z, roll and pitch that are 0). Throws
/// LogError for a missing or empty file and for one that is none of these.
[[nodiscard]] PoseFileKind pose_file_kind(const std::string& file);

/// The poses of a TUM or planar file, or of a rawlog: its observations of class
/// CObservationRobotPose, else the file NAME.rawlog.GT.txt beside it. In file order, at least one.
/// Throws LogError: damaged or foreign data, relations, no poses, poses of several sensors.
[[nodiscard]] std::vector<StampedPose2> read_poses(const std::string& file);
}  // namespace rtob
