// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/slam/slam.h>

#include "compare/variant.h"

namespace rtob
{
/// RTOB-SLAM itself, as `rtob-slam run` runs it.
class RtobVariant : public Variant
{
 public:
    /// Which lasers, and their mount, were settled when the steps were made.
    explicit RtobVariant(const SlamOptions& options);

    Pose2 process(const ScanStep& step) override;
    [[nodiscard]] VariantMap map() const override;
    [[nodiscard]] std::optional<std::uint64_t> lostScans() const override { return lost_scans_; }

 private:
    Slam slam_;
    std::uint64_t lost_scans_ = 0;
};

/// No SLAM at all: what the wheels say. Logs of actions have none before their first scan.
class OdometryVariant : public Variant
{
 public:
    Pose2 process(const ScanStep& step) override;
    [[nodiscard]] VariantMap map() const override { return {}; }

 private:
    Pose2 pose_odom_vehicle_;
};
}  // namespace rtob
