// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/sim/world.h>

#include <algorithm>

namespace rtob::sim
{
bool Object::isPresent(double time_s) const
{
    return present.empty() ||
           std::any_of(
               present.begin(), present.end(),
               [&](const Interval& i) { return i.from_s <= time_s && time_s < i.to_s; });
}

Pose2 Object::pose_map_object(double time_s) const
{
    if (placements.empty()) return {};
    const auto next = std::upper_bound(
        placements.begin(), placements.end(), time_s,
        [](double t, const Placement& p) { return t < p.time_s; });
    if (next == placements.begin()) return next->pose_map_object;
    if (next == placements.end()) return placements.back().pose_map_object;
    const Placement& before = *std::prev(next);
    const double share = (time_s - before.time_s) / (next->time_s - before.time_s);
    const Pose2 &a = before.pose_map_object, &b = next->pose_map_object;
    return {
        a.x + share * (b.x - a.x), a.y + share * (b.y - a.y),
        wrap_angle(a.yaw + share * wrap_angle(b.yaw - a.yaw))};
}

Object walking_person(const Walk& walk)
{
    Object person;
    person.name = "person";
    person.shapes_object = {Arc{{0, 0}, walk.body_radius_m}};
    person.is_solid = true;
    person.z_max_m = walk.height_m;
    std::vector<Point2> path = walk.path_map;
    double time_s = walk.start_s;
    person.placements.push_back({time_s, {path.front().x, path.front().y, 0}});
    do
    {
        for (std::size_t i = 1; i < path.size(); ++i)
        {
            const Point2 step = path[i] - path[i - 1];
            time_s += length(step) / walk.speed_mps;
            person.placements.push_back(
                {time_s, {path[i].x, path[i].y, std::atan2(step.y, step.x)}});
        }
        std::reverse(path.begin(), path.end());
    } while (walk.there_and_back && time_s < walk.end_s && path.size() > 1);
    person.present = {{walk.start_s, std::min(time_s, walk.end_s)}};
    return person;
}
}  // namespace rtob::sim
