// SPDX-License-Identifier: BSD-3-Clause
#include "run/guard_replay.h"

#include <rtob/core/enum_names.h>
#include <rtob/core/processor_time.h>
#include <rtob/map/option_text.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "usage_error.h"

namespace rtob
{
namespace
{
constexpr double kDegree = 180 / 3.14159265358979323846;

/// A gap in the log is not time that a pilot wished for.
constexpr double kLongestStep_s = 1;

double number_of(const std::string& text)
{
    double value = 0;
    parse_option(text, value);
    if (!std::isfinite(value)) throw std::invalid_argument("no number");
    return value;
}
}  // namespace

GuardWish parse_guard_wish(const std::string& text)
{
    if (text == "driven") return {};
    GuardWish wish;
    wish.as_driven = false;
    const auto comma = text.find(',');
    try
    {
        if (comma == std::string::npos) throw std::invalid_argument("no comma");
        wish.velocity_vehicle = {
            number_of(text.substr(0, comma)), number_of(text.substr(comma + 1))};
    }
    catch (const std::invalid_argument&)
    {
        throw UsageError(
            "--wish " + text +
            ": write driven, or metres a second ahead and left, e.g. --wish 0.5,0");
    }
    return wish;
}

GuardReplay::GuardReplay(const RunConfig& config, const GuardWish& wish)
    : wish_(wish), feed_(config.slam), guard_(config.vehicle, config.guard)
{
}

GuardReplay::~GuardReplay() = default;

void GuardReplay::open(const OutputFolder& folder)
{
    file_ = std::make_unique<AtomicFile>(folder.file("guard.csv"));
    file_->stream() << "stamp_s,wish_ahead_mps,wish_left_mps,command_ahead_mps,command_left_mps,"
                       "reason,limiting_bearing_deg,limiting_distance_m\n";
}

void GuardReplay::add(const mrpt::obs::CObservation2DRangeScan& scan, const ScanReport& report)
{
    const double stamp_s = std::isfinite(report.stamp_s) ? report.stamp_s : 0;
    const MapPose pose = GuardFeed::poseOf(report, stamp_s);
    feed_.add(pose);
    const auto motion = feed_.motion(stamp_s);
    const Eigen::Vector2d driven =
        motion ? motion->velocity_vehicle : Eigen::Vector2d(Eigen::Vector2d::Zero());
    const Eigen::Vector2d wish = wish_.as_driven ? driven : wish_.velocity_vehicle;
    VehicleMotion unknown;
    unknown.yaw_rate_radps = std::numeric_limits<double>::quiet_NaN();
    const double began_s = thread_processor_time_s();
    guard_.observe(feed_.scanOf(scan, 0), pose);
    const GuardDecision decision = guard_.decide(stamp_s, wish, motion.value_or(unknown));
    counts_.slowest_decision_ms =
        std::max(counts_.slowest_decision_ms, 1e3 * (thread_processor_time_s() - began_s));
    count(stamp_s, wish, decision);
    write(stamp_s, wish, decision);
}

void GuardReplay::count(double stamp_s, const Eigen::Vector2d& wish, const GuardDecision& decision)
{
    const double step_s = stamp_s - last_s_;
    last_s_ = stamp_s;
    ++counts_.reasons[static_cast<std::size_t>(decision.reason)];
    if (++counts_.decisions == 1 || step_s < 0 || step_s > kLongestStep_s) return;
    counts_.wished_m += step_s * wish.norm();
    counts_.commanded_m += step_s * decision.velocity_vehicle.norm();
}

void GuardReplay::write(double stamp_s, const Eigen::Vector2d& wish, const GuardDecision& decision)
{
    file_->stream() << fixed_text(stamp_s, 6) << ',' << fixed_text(wish.x(), 3) << ','
                    << fixed_text(wish.y(), 3) << ','
                    << fixed_text(decision.velocity_vehicle.x(), 3) << ','
                    << fixed_text(decision.velocity_vehicle.y(), 3) << ','
                    << name_of(decision.reason) << ','
                    << fixed_text(kDegree * decision.limiting_bearing_rad, 1) << ','
                    << fixed_text(decision.limiting_distance_m, 3) << '\n';
}

void GuardReplay::commit()
{
    file_->commit();
}
}  // namespace rtob
