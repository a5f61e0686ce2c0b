// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>

#include <optional>

#include "onboard_flight.h"

/// The vehicle that rtob-onboard flies under the guard: an emulated autopilot that carries out the
/// velocities that it is sent, and a pilot's joystick beside it.
namespace rtob::test
{
/// On a UDP port. It never gives a command up by itself: if it stops, it was told to.
class GuidedVehicle
{
 public:
    /// @param north_rad what its compass shows along the map's x axis
    GuidedVehicle(const Pose2& start_map, double north_rad)
        : north_rad_(north_rad),
          pose_map_(start_map),
          port_(free_udp_port()),
          link_(open_link("udpin:127.0.0.1:" + std::to_string(port_), 0)),
          thread_([this] { live(); })
    {
    }
    ~GuidedVehicle()
    {
        ends_ = true;
        thread_.join();
    }
    GuidedVehicle(const GuidedVehicle&) = delete;
    GuidedVehicle& operator=(const GuidedVehicle&) = delete;

    [[nodiscard]] int port() const { return port_; }
    /// -1 to 1, ahead and to the right; held until dropStick().
    void push(double ahead, double right)
    {
        const std::lock_guard lock(mutex_);
        stick_ = mavlink::ManualControl();
        stick_->x = static_cast<std::int16_t>(std::lround(1000 * ahead));
        stick_->y = static_cast<std::int16_t>(std::lround(1000 * right));
    }
    /// No more messages of the joystick.
    void dropStick()
    {
        const std::lock_guard lock(mutex_);
        stick_.reset();
    }
    [[nodiscard]] Pose2 pose() const
    {
        const std::lock_guard lock(mutex_);
        return pose_map_;
    }
    [[nodiscard]] double speed() const
    {
        const std::lock_guard lock(mutex_);
        return velocity_map_.norm();
    }
    [[nodiscard]] double commandedSpeed() const
    {
        const std::lock_guard lock(mutex_);
        return std::hypot(target_.vx, target_.vy);
    }
    [[nodiscard]] mavlink::SetPositionTargetLocalNed target() const
    {
        const std::lock_guard lock(mutex_);
        return target_;
    }
    [[nodiscard]] std::uint64_t targets() const { return targets_; }
    [[nodiscard]] std::uint64_t obstacleMessages() const { return obstacle_messages_; }
    [[nodiscard]] mavlink::ObstacleDistance obstacles() const
    {
        const std::lock_guard lock(mutex_);
        return obstacles_;
    }
    [[nodiscard]] bool hasRead(const std::string& part) const
    {
        const std::lock_guard lock(mutex_);
        return std::any_of(
            texts_.begin(), texts_.end(),
            [&](const std::string& text) { return text.find(part) != std::string::npos; });
    }

    /// What the laser sees; it sits in the vehicle's middle.
    [[nodiscard]] devices::RangeSource laserIn(Room world) const
    {
        return [this, world = std::move(world)](double bearing_rad, double)
        {
            const Pose2 now = pose();
            return world.range(now.x, now.y, now.yaw + bearing_rad);
        };
    }

 private:
    static constexpr double kStep_s = 0.01, kResponse_s = 0.2, kAcceleration_mps2 = 1.6;

    void live()
    {
        MavlinkReader reader;
        double next_s = unix_time_s();
        for (int step = 0; !ends_; ++step)
        {
            reader.push(link_->read(std::chrono::milliseconds(2)));
            while (const auto frame = reader.take()) take(*frame);
            for (; next_s <= unix_time_s(); next_s += kStep_s)
            {
                move();
                if (step++ % 2 == 0) tell();
            }
        }
    }
    void take(const MavlinkFrame& frame)
    {
        const std::lock_guard lock(mutex_);
        if (const auto target = mavlink::message_of<mavlink::SetPositionTargetLocalNed>(frame))
        {
            target_ = *target;
            ++targets_;
        }
        if (const auto seen = mavlink::message_of<mavlink::ObstacleDistance>(frame))
        {
            obstacles_ = *seen;
            ++obstacle_messages_;
        }
        if (const auto text = mavlink::message_of<mavlink::Statustext>(frame))
            texts_.emplace_back(text->text.data(), strnlen(text->text.data(), 50));
        const auto sync = mavlink::message_of<mavlink::Timesync>(frame);
        if (sync && sync->tc1 == 0)
            link_->write(sender_.encode(mavlink::Timesync{bootTime_ns(), sync->ts1, 0, 0}));
    }
    void move()
    {
        const std::lock_guard lock(mutex_);
        // North and east of the autopilot to x and y of the map, y to the left.
        const double c = std::cos(north_rad_), s = std::sin(north_rad_);
        const Eigen::Vector2d wanted(
            c * target_.vx + s * target_.vy, s * target_.vx - c * target_.vy);
        Eigen::Vector2d change = (wanted - velocity_map_) * (kStep_s / kResponse_s);
        const double most = kAcceleration_mps2 * kStep_s;
        if (change.norm() > most) change *= most / change.norm();
        velocity_map_ += change;
        pose_map_.x += kStep_s * velocity_map_.x();
        pose_map_.y += kStep_s * velocity_map_.y();
        pose_map_.yaw = wrap_angle(pose_map_.yaw - kStep_s * target_.yaw_rate);
    }
    void tell()
    {
        const std::lock_guard lock(mutex_);
        const auto boot_ms = static_cast<std::uint32_t>(bootTime_ns() / 1'000'000);
        mavlink::Attitude attitude;
        attitude.time_boot_ms = boot_ms;
        attitude.yaw = static_cast<float>(wrap_angle(north_rad_ - pose_map_.yaw));
        attitude.yawspeed = target_.yaw_rate;
        mavlink::LocalPositionNed position;
        position.time_boot_ms = boot_ms;
        const double c = std::cos(north_rad_), s = std::sin(north_rad_);
        position.vx = static_cast<float>(c * velocity_map_.x() + s * velocity_map_.y());
        position.vy = static_cast<float>(s * velocity_map_.x() - c * velocity_map_.y());
        link_->write(sender_.encode(mavlink::Heartbeat()));
        link_->write(sender_.encode(attitude));
        link_->write(sender_.encode(position));
        if (stick_) link_->write(sender_.encode(*stick_));
    }
    [[nodiscard]] std::int64_t bootTime_ns() const
    {
        return std::llround(1e9 * (unix_time_s() - boot_s_));
    }

    const double boot_s_ = unix_time_s() - 1000, north_rad_;
    mutable std::mutex mutex_;  ///< guards what follows, up to the texts
    Pose2 pose_map_;
    Eigen::Vector2d velocity_map_ = Eigen::Vector2d::Zero();
    std::optional<mavlink::ManualControl> stick_;
    mavlink::SetPositionTargetLocalNed target_;
    mavlink::ObstacleDistance obstacles_;
    std::vector<std::string> texts_;
    std::atomic<std::uint64_t> targets_{0}, obstacle_messages_{0};
    mavlink::Sender sender_{1, 1, 0};
    int port_;
    std::unique_ptr<ByteLink> link_;
    std::atomic<bool> ends_{false};
    std::thread thread_;
};
}  // namespace rtob::test
