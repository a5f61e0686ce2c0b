// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/eval/svg_plot.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "plot_axis.h"

namespace rtob
{
namespace
{
constexpr double left_px = 76, right_px = 16, top_px = 14, bottom_px = 52;
constexpr double legend_line_px = 22;
constexpr int letters_px = 8;  // about the width of one at the legend's size

/// Pixels with one decimal.
std::string px(double value)
{
    char text[64];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

/// What the lines cover, or what was asked for.
Box shown_box(const std::vector<PlotLine>& lines, const PlotLook& look)
{
    if (look.view) return *look.view;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Box box{infinite, infinite, -infinite, -infinite};
    for (const auto& line : lines)
        for (std::size_t i = 0; i < line.x.size(); ++i)
        {
            if (!std::isfinite(line.x[i]) || !std::isfinite(line.y[i])) continue;
            box.min_x = std::min(box.min_x, line.x[i]);
            box.max_x = std::max(box.max_x, line.x[i]);
            box.min_y = std::min(box.min_y, line.y[i]);
            box.max_y = std::max(box.max_y, line.y[i]);
        }
    return box.min_x > box.max_x ? Box{0, 0, 1, 1} : box;
}

class Plot
{
 public:
    Plot(const std::vector<PlotLine>& lines, const PlotLook& look)
        : lines_(lines),
          look_(look),
          plot_width_px_(look.width_px - left_px - right_px),
          plot_height_px_(look.height_px - top_px - bottom_px)
    {
        Box box = shown_box(lines, look);
        if (look.same_scale) widen(box);
        x_axis_ = PlotAxis(box.min_x, box.max_x, look.log_x);
        y_axis_ = PlotAxis(box.min_y, box.max_y, look.log_y);
    }

    [[nodiscard]] std::string draw()
    {
        const std::string legend = drawLegend();
        const std::string height = px(look_.height_px + legend_height_px_);
        out_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + px(look_.width_px) +
               " " + height + "\" font-family=\"sans-serif\" font-size=\"14\" fill=\"#444\">\n";
        drawGrid();
        drawLabels();
        for (auto line = lines_.rbegin(); line != lines_.rend(); ++line) drawLine(*line);
        return out_ + legend + "</svg>\n";
    }

 private:
    /// Makes a metre as long in x as in y.
    void widen(Box& box) const
    {
        const double width_m = std::max(box.max_x - box.min_x, 1e-6);
        const double height_m = std::max(box.max_y - box.min_y, 1e-6);
        const double m_per_px = std::max(width_m / plot_width_px_, height_m / plot_height_px_);
        const double more_x = (m_per_px * plot_width_px_ - width_m) / 2;
        const double more_y = (m_per_px * plot_height_px_ - height_m) / 2;
        box = {box.min_x - more_x, box.min_y - more_y, box.max_x + more_x, box.max_y + more_y};
    }

    [[nodiscard]] double xPx(double x) const { return left_px + plot_width_px_ * x_axis_.place(x); }
    [[nodiscard]] double yPx(double y) const
    {
        return top_px + plot_height_px_ * (1 - y_axis_.place(y));
    }

    void drawGrid()
    {
        const double right = left_px + plot_width_px_, bottom = top_px + plot_height_px_;
        for (const double tick : x_axis_.ticks(8))
            out_ += "<path d=\"M" + px(xPx(tick)) + " " + px(top_px) + "V" + px(bottom) +
                    "\" stroke=\"#e4e7ea\"/><text x=\"" + px(xPx(tick)) + "\" y=\"" +
                    px(bottom + 18) + "\" text-anchor=\"middle\">" + short_number(tick) +
                    "</text>\n";
        for (const double tick : y_axis_.ticks(6))
            out_ += "<path d=\"M" + px(left_px) + " " + px(yPx(tick)) + "H" + px(right) +
                    "\" stroke=\"#e4e7ea\"/><text x=\"" + px(left_px - 8) + "\" y=\"" +
                    px(yPx(tick) + 5) + "\" text-anchor=\"end\">" + short_number(tick) +
                    "</text>\n";
        frame_ = "x=\"" + px(left_px) + "\" y=\"" + px(top_px) + "\" width=\"" +
                 px(plot_width_px_) + "\" height=\"" + px(plot_height_px_) + "\"";
        // A nested <svg> cuts off what leaves the frame, with no names that could clash in a page.
        out_ += "<rect " + frame_ + " fill=\"none\" stroke=\"#b8bec4\"/>\n";
    }

    void drawLabels()
    {
        const double middle_y = top_px + plot_height_px_ / 2;
        out_ += "<text x=\"" + px(left_px + plot_width_px_ / 2) + "\" y=\"" +
                px(look_.height_px - 12) + "\" text-anchor=\"middle\">" + escaped(look_.x_label) +
                "</text>\n<text transform=\"translate(18 " + px(middle_y) +
                ") rotate(-90)\" text-anchor=\"middle\">" + escaped(look_.y_label) + "</text>\n";
    }

    /// Points nearer than half a pixel to the last one drawn cannot be seen.
    void drawLine(const PlotLine& line)
    {
        std::string path;
        double last_x = -1e9, last_y = -1e9;
        bool is_broken = true;
        for (std::size_t i = 0; i < line.x.size(); ++i)
        {
            if (!std::isfinite(line.x[i]) || !std::isfinite(line.y[i]))
            {
                is_broken = true;
                continue;
            }
            const double x = std::clamp(xPx(line.x[i]), -1e4, 1e4);
            const double y = std::clamp(yPx(line.y[i]), -1e4, 1e4);
            const bool is_last = i + 1 == line.x.size();
            if (!is_broken && !is_last && std::hypot(x - last_x, y - last_y) < 0.5) continue;
            path += (is_broken ? "M" : "L") + px(x) + " " + px(y);
            is_broken = false;
            last_x = x;
            last_y = y;
        }
        if (path.empty()) return;
        out_ += "<svg " + frame_ + " viewBox=\"" + px(left_px) + " " + px(top_px) + " " +
                px(plot_width_px_) + " " + px(plot_height_px_) + "\"><path d=\"" + path +
                "\" fill=\"none\" stroke=\"" + line.colour + "\" stroke-width=\"" +
                (line.is_faint ? "1\" stroke-opacity=\"0.35" : "2") +
                "\" stroke-linejoin=\"round\"/></svg>\n";
    }

    [[nodiscard]] std::string drawLegend()
    {
        std::string legend;
        double x = left_px, y = look_.height_px + 8;
        for (const auto& line : lines_)
        {
            if (line.name.empty()) continue;
            const double width = 40 + letters_px * static_cast<double>(line.name.size());
            if (x > left_px && x + width > look_.width_px)
            {
                x = left_px;
                y += legend_line_px;
            }
            legend += "<path d=\"M" + px(x) + " " + px(y) + "h22\" stroke=\"" + line.colour +
                      "\" stroke-width=\"4\"/><text x=\"" + px(x + 28) + "\" y=\"" + px(y + 5) +
                      "\">" + escaped(line.name) + "</text>\n";
            x += width;
            legend_height_px_ = y + legend_line_px - look_.height_px;
        }
        return legend;
    }

    const std::vector<PlotLine>& lines_;
    const PlotLook& look_;
    double plot_width_px_, plot_height_px_;
    double legend_height_px_ = 0;
    PlotAxis x_axis_{0, 1, false}, y_axis_{0, 1, false};
    std::string frame_, out_;
};
}  // namespace

std::string draw_svg_plot(const std::vector<PlotLine>& lines, const PlotLook& look)
{
    return Plot(lines, look).draw();
}

std::string escaped(const std::string& text)
{
    std::string safe;
    for (const char letter : text) switch (letter)
        {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '"':
                safe += "&quot;";
                break;
            default:
                safe += letter;
        }
    return safe;
}
}  // namespace rtob
