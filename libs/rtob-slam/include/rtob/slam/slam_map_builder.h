// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/slam/CMetricMapBuilder.h>
#include <rtob/slam/slam.h>
#include <rtob/slam/written_scans.h>

#include <string>

namespace rtob
{
/// Slam behind MRPT's interface of map builders, for programs written for CMetricMapBuilderICP.
/// Beside the point map it keeps each scan that was written, as MRPT's simple maps want: memory
/// grows with the drive. One thread.
///
/// Of the base's `options` only the verbosity counts: which scans are written is decided by
/// SlamOptions::insertion and by the state.
class SlamMapBuilder : public mrpt::slam::CMetricMapBuilder
{
 public:
    /// @throws std::invalid_argument naming a key out of its range
    explicit SlamMapBuilder(const SlamOptions& slam_options = {});

    /// Begins an empty map.
    /// @param x0 the vehicle in it; null: the origin.
    /// @throws std::invalid_argument for an initial map that is not empty: its poses come from
    /// another program, and this one writes a scan only where it matched it itself
    void initialize(
        const mrpt::maps::CSimpleMap& initial_map = {},
        const mrpt::poses::CPosePDF* x0 = nullptr) override;

    /// The action's odometry, then each observation.
    void processActionObservation(
        mrpt::obs::CActionCollection& action, mrpt::obs::CSensoryFrame& observations) override;

    /// One observation of any kind: odometry and scans are used, others are passed over.
    /// @throws std::invalid_argument for null
    void processObservation(const mrpt::obs::CObservation::Ptr& observation);

    /// Mean and covariance of pose_map_vehicle; a mrpt::poses::CPose3DPDFGaussian.
    [[nodiscard]] mrpt::poses::CPose3DPDF::Ptr getCurrentPoseEstimation() const override;

    /// The scans of the map, one a frame, where they are now: closing a loop moves them.
    void getCurrentlyBuiltMap(mrpt::maps::CSimpleMap& out_map) const override;
    unsigned int getCurrentlyBuiltMapSize() override;

    /// One map in it: the RtobMap of slam(). Valid while the builder lives.
    [[nodiscard]] const mrpt::maps::CMultiMetricMap* getCurrentlyBuiltMetricMap() const override;

    /// Draws points and path. The file's ending decides the format (png, bmp, jpg ...), whatever
    /// the flag: EMF is a Windows format.
    /// @throws std::runtime_error naming the file when it cannot be written
    void saveCurrentEstimationToImage(const std::string& file, bool formatEMF_BMP = true) override;

    [[nodiscard]] const Slam& slam() const { return slam_; }

 private:
    Slam slam_;
    Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();  ///< of the last scan: x, y, yaw
    mrpt::maps::CMultiMetricMap metric_map_;                ///< refers to slam_'s map
    WrittenScans scans_;
};
}  // namespace rtob
