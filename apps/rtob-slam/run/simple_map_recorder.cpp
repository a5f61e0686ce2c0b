// SPDX-License-Identifier: BSD-3-Clause
#include "run/simple_map_recorder.h"

#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <rtob/map/conversions.h>

namespace rtob
{
void SimpleMapRecorder::add(
    const mrpt::obs::CObservation2DRangeScan& scan, const mrpt::poses::CPose3D& pose_vehicle_laser,
    const ScanReport& report)
{
    const auto copy = mrpt::obs::CObservation2DRangeScan::Create(scan);
    copy->sensorPose = pose_vehicle_laser;
    const auto frame = mrpt::obs::CSensoryFrame::Create();
    frame->insert(copy);
    const auto pose = mrpt::poses::CPosePDFGaussian::Create(
        to_cpose2d(report.pose_map_vehicle), mrpt::math::CMatrixDouble33(report.covariance));
    map_.insert(pose, frame);
}
}  // namespace rtob
