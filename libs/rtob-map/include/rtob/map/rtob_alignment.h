// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/slam/CMetricMapsAlignmentAlgorithm.h>
#include <rtob/core/icp.h>
#include <rtob/core/points.h>

namespace rtob
{
struct RtobAlignmentResult : mrpt::slam::TMetricMapAlignmentResult
{
    int iterations = 0;
    std::size_t pairs = 0;
    double paired_share = 0;        ///< [0, 1] of m2's points
    double mean_squared_error = 0;  ///< m^2, over the pairs
};

/// The core's ICP as an MRPT alignment algorithm. Keeps buffers between calls: one thread an
/// object.
class RtobAlignment : public mrpt::slam::CMetricMapsAlignmentAlgorithm
{
 public:
    explicit RtobAlignment(const IcpOptions& options = {}) : icp_(options) {}

    /// The pose of m2 seen from m1, by eq. 4. With fewer than 3 pairs it is the guess, and `pairs`
    /// says so.
    /// @param m1 an RtobMap, of which a sample is drawn; or a point map, or a multi-metric map with
    /// exactly one, of which all points are used.
    /// @param m2 a point map: the scan, seen from the vehicle.
    /// @throws std::invalid_argument for maps of other kinds
    mrpt::poses::CPosePDF::Ptr AlignPDF(
        const mrpt::maps::CMetricMap* m1, const mrpt::maps::CMetricMap* m2,
        const mrpt::poses::CPosePDFGaussian& guess,
        mrpt::optional_ref<mrpt::slam::TMetricMapAlignmentResult> result = std::nullopt) override;

    /// AlignPDF() for a guess in the plane: z, pitch and roll stay as they are.
    /// @throws std::invalid_argument for a tilted guess
    mrpt::poses::CPose3DPDF::Ptr Align3DPDF(
        const mrpt::maps::CMetricMap* m1, const mrpt::maps::CMetricMap* m2,
        const mrpt::poses::CPose3DPDFGaussian& guess,
        mrpt::optional_ref<mrpt::slam::TMetricMapAlignmentResult> result = std::nullopt) override;

 private:
    Icp icp_;
    Points scan_, reference_;  ///< map axes, seen from the guess
};
}  // namespace rtob
