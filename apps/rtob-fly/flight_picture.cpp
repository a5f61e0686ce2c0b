// SPDX-License-Identifier: BSD-3-Clause
#include "flight_picture.h"

#include <rtob/core/enum_names.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <variant>

namespace rtob::fly
{
namespace
{
const cv::Scalar white_bgr(255, 255, 255), wall_bgr(60, 60, 60), text_bgr(60, 50, 40);
const cv::Scalar hit_bgr(200, 120, 40), wish_bgr(150, 150, 150), body_bgr(235, 225, 205);
constexpr int kTextHeight_px = 22;

cv::Scalar colour_of(GuardReason reason)
{
    switch (reason)
    {
        case GuardReason::Free:
            return {90, 160, 60};
        case GuardReason::Guided:
            return {210, 120, 30};
        case GuardReason::Slowed:
            return {40, 170, 240};
        case GuardReason::Blocked:
            return {50, 50, 210};
        default:
            return {170, 70, 150};
    }
}

/// Metres of the map to pixels, y upwards.
class View
{
 public:
    View(const FlyWorld& world, int width_px) : area_(world.area.grown(0.2))
    {
        scale_ = width_px / (area_.max_x - area_.min_x);
        size_ = {width_px, static_cast<int>(std::ceil(scale_ * (area_.max_y - area_.min_y)))};
    }
    [[nodiscard]] cv::Size size() const { return size_; }
    [[nodiscard]] int length(double metres) const
    {
        return static_cast<int>(scale_ * metres + 0.5);
    }
    [[nodiscard]] cv::Point at(double x_map, double y_map) const
    {
        return {
            static_cast<int>(scale_ * (x_map - area_.min_x)),
            static_cast<int>(scale_ * (area_.max_y - y_map))};
    }
    [[nodiscard]] cv::Point at(const Pose2& pose) const { return at(pose.x, pose.y); }

 private:
    Box area_;
    double scale_ = 1;
    cv::Size size_;
};

void draw_walls(cv::Mat& image, const View& view, const sim::World& world)
{
    for (const sim::Object& object : world.objects)
        for (const sim::Shape& shape : object.shapes_object)
            if (const auto* segment = std::get_if<sim::Segment>(&shape))
                cv::line(
                    image, view.at(segment->from.x, segment->from.y),
                    view.at(segment->to.x, segment->to.y), wall_bgr, 2, cv::LINE_AA);
            else if (const auto* arc = std::get_if<sim::Arc>(&shape))
                cv::circle(
                    image, view.at(arc->centre.x, arc->centre.y),
                    std::max(2, view.length(arc->radius_m)), wall_bgr, cv::FILLED, cv::LINE_AA);
}

void write_text(cv::Mat& image, const std::string& text, cv::Point at, const cv::Scalar& bgr)
{
    cv::putText(image, text, at, cv::FONT_HERSHEY_SIMPLEX, 0.45, bgr, 1, cv::LINE_AA);
}

void draw_vehicle(
    cv::Mat& image, const View& view, const FlightFrame& frame, const VehicleLimits& limits)
{
    const cv::Point middle = view.at(frame.pose_map_vehicle);
    cv::circle(image, middle, view.length(limits.clearance()), body_bgr, 1, cv::LINE_AA);
    cv::circle(image, middle, view.length(limits.radius_m), body_bgr, cv::FILLED, cv::LINE_AA);
    cv::circle(
        image, middle, view.length(limits.radius_m), colour_of(frame.reason), 2, cv::LINE_AA);
    const auto arrow = [&](const Eigen::Vector2d& velocity, const cv::Scalar& bgr)
    {
        const double speed_mps = velocity.norm();
        if (speed_mps < 0.02) return;
        // A metre a second is a metre long; absurd wishes are cut.
        const Eigen::Vector2d way = velocity * std::min(1.0, 2 / speed_mps);
        const Pose2& pose = frame.pose_map_vehicle;
        cv::arrowedLine(
            image, middle, view.at(pose.x + way.x(), pose.y + way.y()), bgr, 2, cv::LINE_AA, 0,
            0.25);
    };
    arrow(frame.wish_map, wish_bgr);
    arrow(frame.command_map, colour_of(frame.reason));
}

std::string caption(const FlyWorld& world, const FlightSetup& setup, const FlightResult& result)
{
    char figures[160];
    std::snprintf(
        figures, sizeof(figures), ", %.0f m in %.0f s, least gap %.0f cm, contacts %d",
        result.flown_m, setup.duration_s, 100 * result.least_gap_m, result.contacts);
    return world.name + ", " + std::string(name_of(setup.pilot)) + " pilot, " + setup.avoider +
           figures;
}

void draw_legend(cv::Mat& image, int y)
{
    int x = 8;
    for (const GuardReason reason :
         {GuardReason::Free, GuardReason::Guided, GuardReason::Slowed, GuardReason::Blocked,
          GuardReason::NoData})
    {
        const std::string name(name_of(reason));
        cv::line(image, {x, y - 4}, {x + 16, y - 4}, colour_of(reason), 3, cv::LINE_AA);
        write_text(image, name, {x + 22, y}, text_bgr);
        x += 40 + 9 * static_cast<int>(name.size());
    }
    cv::arrowedLine(image, {x, y - 4}, {x + 22, y - 4}, wish_bgr, 2, cv::LINE_AA, 0, 0.3);
    write_text(image, "wish", {x + 28, y}, text_bgr);
}

void write_png(const std::string& file, const cv::Mat& image)
{
    bool is_written = false;
    try
    {
        is_written = cv::imwrite(file, image);
    }
    catch (const cv::Exception&)
    {
    }
    if (!is_written)
        throw std::runtime_error(file + ": cannot be written; is its folder there and writable?");
}
}  // namespace

void write_flight_picture(
    const std::string& file, const FlyWorld& world, const FlightSetup& setup,
    const FlightResult& result)
{
    const View view(world, 1000);
    cv::Mat image(view.size().height + 2 * kTextHeight_px, view.size().width, CV_8UC3, white_bgr);
    draw_walls(image, view, world.world);
    for (std::size_t i = 1; i < result.frames.size(); ++i)
        cv::line(
            image, view.at(result.frames[i - 1].pose_map_vehicle),
            view.at(result.frames[i].pose_map_vehicle), colour_of(result.frames[i].reason), 2,
            cv::LINE_AA);
    if (!result.frames.empty()) draw_vehicle(image, view, result.frames.back(), setup.limits);
    write_text(
        image, caption(world, setup, result), {8, view.size().height + kTextHeight_px - 6},
        text_bgr);
    draw_legend(image, view.size().height + 2 * kTextHeight_px - 8);
    write_png(file, image);
}

void write_flight_strip(
    const std::string& file, const FlyWorld& world, const FlightSetup& setup,
    const FlightResult& result, std::size_t frames)
{
    constexpr int kColumns = 4;
    frames = std::min(frames, result.frames.size());
    if (frames == 0) throw std::invalid_argument("a strip of no frames");
    const View view(world, 420);
    const int height_px = view.size().height + kTextHeight_px;
    const int rows = (static_cast<int>(frames) + kColumns - 1) / kColumns;
    cv::Mat strip(
        rows * height_px + kTextHeight_px, kColumns * view.size().width, CV_8UC3, white_bgr);
    for (std::size_t i = 0; i < frames; ++i)
    {
        const FlightFrame& frame =
            result.frames[i * (result.frames.size() - 1) / std::max<std::size_t>(frames - 1, 1)];
        const int column = static_cast<int>(i) % kColumns, row = static_cast<int>(i) / kColumns;
        cv::Mat image = strip(
            cv::Rect(column * view.size().width, row * height_px, view.size().width, height_px));
        draw_walls(image, view, world.world);
        for (std::size_t k = 0; k < frame.hits_map.size(); ++k)
            cv::circle(
                image, view.at(frame.hits_map.x[k], frame.hits_map.y[k]), 1, hit_bgr, cv::FILLED);
        draw_vehicle(image, view, frame, setup.limits);
        char text[64];
        std::snprintf(
            text, sizeof(text), "%.1f s  %s", frame.time_s,
            std::string(name_of(frame.reason)).c_str());
        write_text(image, text, {8, height_px - 7}, colour_of(frame.reason));
    }
    write_text(
        strip, caption(world, setup, result), {8, rows * height_px + kTextHeight_px - 7}, text_bgr);
    write_png(file, strip);
}
}  // namespace rtob::fly
