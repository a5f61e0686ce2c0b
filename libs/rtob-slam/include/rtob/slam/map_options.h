// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

#include <optional>
#include <string>

namespace rtob
{
/// The map that a run begins with, and how large it may get.
struct MapOptions
{
    std::string file;
    bool localize = false;
    std::string initial_pose;
    int max_points = 0;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("file", s.file, "a map.rtob to go on in; empty: begin a new map");
        visit(
            "localize", s.localize, "only say where the vehicle is: the file's map stays as it is");
        visit(
            "initial_pose", s.initial_pose,
            "where in the file's map the vehicle is, as x,y,yaw in m and degrees; empty: look for "
            "it everywhere");
        visit(
            "max_points", s.max_points,
            "points that the map may hold at most: old scans are thinned where they are many; 0: "
            "as many as come, else >= 10000");
    }
    /// @throws std::invalid_argument
    void validate() const;

    /// In map; nothing where the text is empty. @throws std::invalid_argument for another form
    [[nodiscard]] std::optional<Pose2> initialPose() const;
};
}  // namespace rtob
