// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/io/atomic_file.h>
#include <rtob/slam/scan_report.h>

#include <string>

#include "run/output_folder.h"

namespace rtob
{
/// Fixed decimals, the same bytes in any locale.
[[nodiscard]] std::string fixed_text(double value, int decimals);

/// The files with a line for every scan, in the log's order: trajectory.tum, poses.csv, timing.csv.
/// Written as the run goes on, there under their names after commit(). A scan whose stamp is no
/// number has the stamp 0 in them.
class ScanFiles
{
 public:
    explicit ScanFiles(const OutputFolder& folder);

    void add(const ScanReport& report);
    void commit();

 private:
    AtomicFile trajectory_, poses_, timing_;
};
}  // namespace rtob
