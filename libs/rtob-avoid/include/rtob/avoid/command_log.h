// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace rtob
{
/// The commands that may still act on the vehicle, in axes that do not turn with it.
class CommandLog
{
 public:
    /// @param latency_s longest time from a command until the vehicle begins to act on it
    explicit CommandLog(double latency_s) : latency_s_(latency_s) {}

    void add(double time_s, const Eigen::Vector2d& velocity_odom);
    void clear() { size_ = 0; }

    static constexpr std::size_t kMaxActing = 16;

    /// Velocities whose mixtures are all that the commands may still ask for: the commands of the
    /// last latency and the one before, or the corners of a box around them where they are many.
    /// @return how many were written
    std::size_t acting(
        double now_s, std::array<Eigen::Vector2d, kMaxActing>& velocities_odom) const;

 private:
    static constexpr std::size_t kCapacity = 256;
    struct Command
    {
        double time_s = 0;
        Eigen::Vector2d velocity_odom = Eigen::Vector2d::Zero();
    };
    /// @param back 0 is the newest
    [[nodiscard]] const Command& command(std::size_t back) const
    {
        return commands_[(next_ + kCapacity - 1 - back) % kCapacity];
    }

    double latency_s_;
    std::array<Command, kCapacity> commands_;
    std::size_t next_ = 0, size_ = 0;
};
}  // namespace rtob
