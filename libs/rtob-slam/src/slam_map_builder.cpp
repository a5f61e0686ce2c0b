// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <rtob/map/conversions.h>
#include <rtob/slam/points_image.h>
#include <rtob/slam/slam_map_builder.h>

#include <stdexcept>

namespace rtob
{
SlamMapBuilder::SlamMapBuilder(const SlamOptions& slam_options) : slam_(slam_options)
{
    // MRPT's list holds shared pointers. This one owns nothing: the map stays Slam's, and the list
    // is handed out as const only.
    auto* map = const_cast<RtobMap*>(&slam_.map());
    metric_map_.maps.emplace_back(std::shared_ptr<void>(), map);
}

void SlamMapBuilder::initialize(
    const mrpt::maps::CSimpleMap& initial_map, const mrpt::poses::CPosePDF* x0)
{
    if (!initial_map.empty())
        throw std::invalid_argument(
            "SlamMapBuilder begins with an empty map: an initial map of " +
            std::to_string(initial_map.size()) + " frames cannot be taken; give an empty one");
    slam_ = Slam(slam_.options());
    covariance_.setZero();
    scans_.clear();
    if (x0 != nullptr) slam_.reset(to_pose2(x0->getMeanVal()));
}

void SlamMapBuilder::processActionObservation(
    mrpt::obs::CActionCollection& action, mrpt::obs::CSensoryFrame& observations)
{
    if (const auto motion = action.getBestMovementEstimation()) slam_.observe(*motion);
    for (const auto& observation : observations) processObservation(observation);
}

void SlamMapBuilder::processObservation(const mrpt::obs::CObservation::Ptr& observation)
{
    if (!observation) throw std::invalid_argument("SlamMapBuilder: the observation is null");
    const ScanReport* report = slam_.observe(*observation);
    if (report == nullptr) return;
    covariance_ = report->covariance;
    scans_.add(observation, *report);
}

mrpt::poses::CPose3DPDF::Ptr SlamMapBuilder::getCurrentPoseEstimation() const
{
    const auto pose = mrpt::poses::CPose3DPDFGaussian::Create();
    pose->copyFrom(to_pdf(slam_.pose(), covariance_));
    return pose;
}

void SlamMapBuilder::getCurrentlyBuiltMap(mrpt::maps::CSimpleMap& out_map) const
{
    out_map = scans_.in(slam_.map().scans());
}

unsigned int SlamMapBuilder::getCurrentlyBuiltMapSize()
{
    return static_cast<unsigned int>(slam_.map().scans().size());
}

const mrpt::maps::CMultiMetricMap* SlamMapBuilder::getCurrentlyBuiltMetricMap() const
{
    return &metric_map_;
}

void SlamMapBuilder::saveCurrentEstimationToImage(const std::string& file, bool)
{
    const auto image = points_image(slam_.map().points(), slam_.map().scans());
    const auto failed = [&](const std::string& why)
    { return std::runtime_error(file + ": cannot write the picture" + why); };
    bool is_written = false;
    try
    {
        is_written = image.saveToFile(file);
    }
    catch (const std::exception&)  // OpenCV's, for an ending that it does not know
    {
        throw failed("; name it .png or .bmp");
    }
    if (!is_written) throw failed("; does its folder exist?");
}
}  // namespace rtob
