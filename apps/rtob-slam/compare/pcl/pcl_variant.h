// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/map/rtob_map.h>
#include <rtob/slam/prealignment.h>
#include <rtob/slam/scan_filter.h>
#include <rtob/slam/slam_options.h>

#include <memory>

#include "compare/variant.h"

namespace rtob
{
/// The paper's recipe with the paper's aligner: each scan, started from odometry where it arrives
/// and from the last pose else, is aligned by the Point Cloud Library's ICP with points drawn from
/// the map, and joins it where the mean squared distance of its pairs is small enough. Of the
/// options it uses Prealign, Density, Draw, the Icp's iterations and pair distance, and FitGate.
class PclVariant : public Variant
{
 public:
    explicit PclVariant(const SlamOptions& options);

    Pose2 process(const ScanStep& step) override;
    [[nodiscard]] VariantMap map() const override;

 private:
    struct Fit
    {
        Pose2 correction;  ///< about the guess, along the map's axes: eq. 4
        bool is_good = false;
    };

    [[nodiscard]] Fit align(const Points& scan_turned);

    SlamOptions options_;
    RtobMap map_;
    ScanFilter filter_;
    Prealignment prealignment_;
    Points points_vehicle_, points_turned_;
    Reference reference_;
};
}  // namespace rtob
