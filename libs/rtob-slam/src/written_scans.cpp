// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <rtob/map/conversions.h>
#include <rtob/slam/written_scans.h>

#include "scan_cursor.h"

namespace rtob
{
void WrittenScans::add(const mrpt::obs::CObservation::Ptr& scan, const ScanReport& report)
{
    if (report.inserted) written_.push_back({report.map_time_s, scan, report.covariance});
}

mrpt::maps::CSimpleMap WrittenScans::in(const ScanTable& scans) const
{
    mrpt::maps::CSimpleMap map;
    ScanCursor in_map(scans);
    for (const Written& written : written_)
    {
        const auto scan = in_map.find(written.map_time_s);
        if (!scan) continue;  // forgotten, or taken back
        const auto frame = mrpt::obs::CSensoryFrame::Create();
        frame->insert(written.scan);
        const auto pose = mrpt::poses::CPose3DPDFGaussian::Create();
        pose->copyFrom(to_pdf(scans.pose(*scan), written.covariance));
        map.insert(pose, frame);
    }
    return map;
}
}  // namespace rtob
