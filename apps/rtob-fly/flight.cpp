// SPDX-License-Identifier: BSD-3-Clause
#include "flight.h"

#include <rtob/core/processor_time.h>
#include <rtob/sim/simulation.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <stdexcept>

namespace rtob::fly
{
namespace
{
using Eigen::Vector2d;

constexpr double kStep_s = 0.01;
constexpr double kHeight_m = 1;
constexpr double kSlow_mps = 0.1;
constexpr double kRoomToStart_m = 0.1;  // beyond radius and margin
// A laser that does not see all around is turned around once, on the spot, before it flies.
constexpr double kLookAround_radps = 1.5;
constexpr double kLookAround_s = 2 * M_PI / kLookAround_radps;

Vector2d turned(const Vector2d& vector, double angle_rad)
{
    const double c = std::cos(angle_rad), s = std::sin(angle_rad);
    return {c * vector.x() - s * vector.y(), s * vector.x() + c * vector.y()};
}

/// A place that the vehicle may start from, with some room around it.
Pose2 drawn_start(const FlyWorld& world, const VehicleLimits& limits, Random& random)
{
    const sim::Scene scene(world.world);
    for (int attempt = 0; attempt < 10000; ++attempt)
    {
        const Box& area = world.area;
        const Pose2 start{
            area.min_x + random.uniform() * (area.max_x - area.min_x),
            area.min_y + random.uniform() * (area.max_y - area.min_y),
            (random.uniform() - 0.5) * 6};
        // Places outside of the walls are free, too: look for walls on all sides.
        bool is_inside = true;
        for (int k = 0; k < 4; ++k)
        {
            sim::Beam beam;
            beam.origin_map = {start.x, start.y};
            beam.z_m = kHeight_m;
            beam.direction_map = {std::cos(k * M_PI / 2), std::sin(k * M_PI / 2)};
            is_inside = is_inside && scene.cast(beam).met();
        }
        if (is_inside &&
            scene.clearance_m({start.x, start.y}, kHeight_m) > limits.clearance() + kRoomToStart_m)
            return start;
    }
    throw std::invalid_argument("no place to start from in the world " + world.name);
}

sim::SimulationOptions simulation_options(const FlightSetup& setup, const Pose2& start_map)
{
    const Hardship& hard = setup.hardship;
    sim::SimulationOptions options;
    options.seed = setup.seed;
    options.start_map = {start_map.x, start_map.y, kHeight_m, 0, 0, start_map.yaw};
    options.laser.noise_m = hard.range_noise_m;
    options.laser.dropout = hard.dropout;
    options.laser.field_of_view_deg = hard.field_of_view_deg;
    options.laser.beams = static_cast<int>(hard.field_of_view_deg);  // one a degree
    options.vehicle.radius_m = setup.limits.radius_m;
    options.vehicle.velocity_lag_s = setup.limits.response_s;
    options.vehicle.max_speed_mps = 1.5 * setup.limits.max_speed_mps;
    options.vehicle.max_acceleration_mps2 =
        hard.acceleration_share * setup.limits.acceleration_mps2;
    options.vehicle.turbulence_mps2 = hard.turbulence_mps2;
    return options;
}

/// The link to the vehicle: commands arrive late, but in order. They hold in axes that stand still.
class Link
{
 public:
    Link(double latency_s, bool always_latest, std::uint64_t seed)
        : latency_s_(latency_s), always_latest_(always_latest), random_(seed)
    {
    }

    void send(double time_s, const Vector2d& command_map)
    {
        const double share = always_latest_ ? 1 : random_.uniform();
        const double arrival_s = time_s + share * latency_s_;
        const double last_s = waiting_.empty() ? arrival_s : waiting_.back().arrival_s;
        waiting_.push_back({std::max(arrival_s, last_s), command_map});
    }
    [[nodiscard]] const Vector2d& active(double time_s)
    {
        for (; !waiting_.empty() && waiting_.front().arrival_s <= time_s; waiting_.pop_front())
            active_map_ = waiting_.front().command_map;
        return active_map_;
    }

 private:
    struct Message
    {
        double arrival_s;
        Vector2d command_map;
    };
    double latency_s_;
    bool always_latest_;
    Random random_;
    std::deque<Message> waiting_;
    Vector2d active_map_ = Vector2d::Zero();
};

class Flight
{
 public:
    Flight(const FlyWorld& world, const FlightSetup& setup, const Pose2& start_map)
        : setup_(setup),
          simulation_(world.world, simulation_options(setup, start_map)),
          avoider_(make_avoider(setup.avoider, setup.limits, setup.options)),
          pilot_(setup.pilot, world.route_map, setup.seed + 7),
          link_(setup.limits.latency_s, setup.hardship.always_latest, setup.seed + 13),
          noise_(setup.seed, 101)
    {
    }

    FlightResult run(double frame_every_s)
    {
        double next_frame_s = 0;
        while (simulation_.time_s() < look_around_s_ + setup_.duration_s)
        {
            move();
            deliverScan();
            if (simulation_.time_s() >= next_decision_s_) decide();
            if (frame_every_s <= 0 || simulation_.time_s() < next_frame_s) continue;
            next_frame_s += frame_every_s;
            result_.frames.push_back(frame());
        }
        result_.end_map = pose();
        return result_;
    }

 private:
    [[nodiscard]] Pose2 pose() const { return simulation_.state().pose_map_vehicle.from_above(); }
    [[nodiscard]] Vector2d velocity_map() const
    {
        return {simulation_.state().vx_map_mps, simulation_.state().vy_map_mps};
    }

    void move()
    {
        const Vector2d command = turned(autopilotCommand(), -pose().yaw);
        simulation_.step(kStep_s, {command.x(), command.y(), input_.yaw_rate_radps, 0});
        result_.flown_m += kStep_s * velocity_map().norm();
        const double wished_mps = input_.wish_map.norm();
        if (wished_mps > 0)
        {
            result_.wished_m += kStep_s * std::min(wished_mps, setup_.limits.max_speed_mps);
            result_.along_wish_m += kStep_s * velocity_map().dot(input_.wish_map) / wished_mps;
        }
        const double gap_m = simulation_.clearance_m() - setup_.limits.radius_m;
        result_.least_gap_m = std::min(result_.least_gap_m, gap_m);
        if (gap_m < 0 && !is_touching_) ++result_.contacts;
        is_touching_ = gap_m < 0;
    }

    /// What the link says; told to stand still, the vehicle holds its place, as autopilots do in
    /// all modes that take velocities.
    [[nodiscard]] Vector2d autopilotCommand()
    {
        const Vector2d& active_map = link_.active(simulation_.time_s());
        if (!active_map.isZero() || velocity_map().norm() > kSlow_mps) hold_map_.reset();
        if (!active_map.isZero() || !setup_.hardship.holds_place) return active_map;
        const Vector2d place_map(pose().x, pose().y);
        if (!hold_map_ && velocity_map().norm() <= kSlow_mps) hold_map_ = place_map;
        return hold_map_ ? Vector2d(*hold_map_ - place_map) : active_map;
    }

    void deliverScan()
    {
        if (auto scan = simulation_.takeScan())
        {
            waiting_scan_ = std::move(*scan);
            delivery_s_ = simulation_.time_s() + setup_.hardship.scan_delay_s;
        }
        if (!waiting_scan_ || simulation_.time_s() < delivery_s_) return;
        newest_scan_ = std::move(*waiting_scan_);
        waiting_scan_.reset();
        GuardScan scan;
        scan.stamp_s = newest_scan_.first_beam_s;
        scan.sweep_s =
            newest_scan_.beam_interval_s * static_cast<double>(newest_scan_.ranges_m.size() - 1);
        scan.first_bearing_rad = newest_scan_.first_bearing_rad;
        scan.step_rad = newest_scan_.step_rad;
        scan.ranges_m = newest_scan_.ranges_m.data();
        scan.beams = newest_scan_.ranges_m.size();
        MapPose found;
        found.stamp_s = newest_scan_.time_s;
        found.pose_map_vehicle = newest_scan_.pose_map_vehicle.from_above();
        found.pose_map_vehicle.x += noise_.gaussian(setup_.hardship.pose_noise_m);
        found.pose_map_vehicle.y += noise_.gaussian(setup_.hardship.pose_noise_m);
        found.sigma_m = setup_.hardship.pose_noise_m;
        found.is_lost = false;
        const double began_s = thread_processor_time_s();
        avoider_->observe(scan, found);
        result_.decision_s += thread_processor_time_s() - began_s;
    }

    void decide()
    {
        const double now_s = simulation_.time_s();
        // Twice as often as promised, now and then late.
        next_decision_s_ = now_s + setup_.limits.period_s * (noise_.happens(0.1) ? 1 : 0.5);
        input_ = now_s < look_around_s_ ? StickInput{Vector2d::Zero(), kLookAround_radps}
                                        : pilot_.fly(now_s, simulation_);
        const double yaw = pose().yaw;
        VehicleMotion motion;
        motion.velocity_vehicle = turned(velocity_map(), -yaw);
        motion.velocity_vehicle.x() += noise_.gaussian(setup_.hardship.velocity_noise_mps);
        motion.velocity_vehicle.y() += noise_.gaussian(setup_.hardship.velocity_noise_mps);
        motion.yaw_rate_radps = simulation_.state().yaw_rate_radps;
        const double began_s = thread_processor_time_s();
        decision_ = avoider_->decide(now_s, turned(input_.wish_map, -yaw), motion);
        result_.decision_s += thread_processor_time_s() - began_s;
        ++result_.decisions;
        ++result_.reasons[static_cast<std::size_t>(decision_.reason)];
        countSides(decision_.bend_rad);
        command_map_ = turned(decision_.velocity_vehicle, yaw);
        link_.send(now_s, command_map_);
    }

    void countSides(double bend_rad)
    {
        const int side = bend_rad > 0 ? 1 : bend_rad < 0 ? -1 : 0;
        if (side == 0) return;
        if (side_ != 0 && side != side_) ++result_.side_changes;
        side_ = side;
    }

    [[nodiscard]] FlightFrame frame() const
    {
        FlightFrame frame{simulation_.time_s(), pose(),           input_.wish_map,
                          command_map_,         decision_.reason, {}};
        const Pose2 seen_from = newest_scan_.pose_map_vehicle.from_above();
        for (std::size_t beam = 0; beam < newest_scan_.ranges_m.size(); ++beam)
        {
            const double range_m = newest_scan_.ranges_m[beam];
            if (range_m <= 0) continue;
            const double bearing_rad = seen_from.yaw + newest_scan_.bearing_rad(beam);
            frame.hits_map.add(
                static_cast<float>(seen_from.x + range_m * std::cos(bearing_rad)),
                static_cast<float>(seen_from.y + range_m * std::sin(bearing_rad)));
        }
        return frame;
    }

    const FlightSetup& setup_;
    const double look_around_s_ = setup_.hardship.field_of_view_deg < 360 ? kLookAround_s : 0;
    sim::Simulation simulation_;
    std::unique_ptr<Avoider> avoider_;
    Pilot pilot_;
    Link link_;
    sim::Noise noise_;
    StickInput input_;
    GuardDecision decision_;
    Vector2d command_map_ = Vector2d::Zero();
    std::optional<Vector2d> hold_map_;
    std::optional<sim::LaserScan> waiting_scan_;
    sim::LaserScan newest_scan_;
    double delivery_s_ = 0, next_decision_s_ = 0;
    bool is_touching_ = false;
    int side_ = 0;
    FlightResult result_;
};
}  // namespace

VehicleLimits fly_limits()
{
    VehicleLimits limits;
    limits.radius_m = 0.3;
    return limits;
}

GuardOptions fly_options()
{
    GuardOptions options;
    options.no_return_is_free = true;  // nothing in these worlds swallows beams
    return options;
}

FlightResult fly(const FlyWorld& world, const FlightSetup& setup, double frame_every_s)
{
    Random random(setup.seed);
    const Pose2 start_map =
        setup.start_map ? *setup.start_map : drawn_start(world, setup.limits, random);
    return Flight(world, setup, start_map).run(frame_every_s);
}
}  // namespace rtob::fly
