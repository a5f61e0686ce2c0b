// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "picture_canvas.h"

/// What a picture of a map is made of.
namespace rtob
{
/// The card that the map lies on, with a faint grid of round metres.
void draw_ground(Canvas& canvas);
void draw_path(Canvas& canvas, const std::vector<Pose2>& path);
/// A disc at the start, an arrowhead along the vehicle's heading at the end.
void draw_start_and_end(Canvas& canvas, const std::vector<Pose2>& path);
/// The height at which the things below the map are, px.
[[nodiscard]] double footer_middle(const Canvas& canvas);
/// Below the map, on the left.
void draw_scale_bar(Canvas& canvas);
/// Below the map, up to `right`: what the marks of start and end mean.
void draw_mark_names(Canvas& canvas, double right);
/// Below the map, on the right: the colours of the path from start to end.
void draw_time_legend(Canvas& canvas);
}  // namespace rtob
