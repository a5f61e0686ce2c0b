// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/points.h>

#include <optional>
#include <string>
#include <vector>

namespace rtob
{
/// One line of a plot; places that are not finite break it.
struct PlotLine
{
    std::string name;    ///< in the legend; empty: not there
    std::string colour;  ///< as in CSS
    std::vector<double> x, y;
    bool is_faint = false;
};

struct PlotLook
{
    std::string x_label, y_label;
    bool log_x = false, log_y = false;
    bool same_scale = false;  ///< a metre is as long in x as in y: for maps
    std::optional<Box> view;  ///< what is shown; none: everything
    int width_px = 960, height_px = 420;
};

/// A plot with axes, grid and legend as an <svg> element. The first line lies on top; all are
/// thinned to what can be seen.
[[nodiscard]] std::string draw_svg_plot(const std::vector<PlotLine>& lines, const PlotLook& look);

/// The text with the characters replaced that mean something in HTML and SVG.
[[nodiscard]] std::string escaped(const std::string& text);
}  // namespace rtob
