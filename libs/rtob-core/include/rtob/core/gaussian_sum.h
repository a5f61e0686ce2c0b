// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/points.h>
#include <rtob/core/scan_table.h>

namespace rtob
{
/// Sum of exp(-((t - t*) / (sqrt(2) sigma))^2) over the scans of `range` that were taken inside
/// `near`, sec. 2.3.3. At most 4 sigma from t; relative error below 1e-4.
[[nodiscard]] double gaussian_sum(
    const ScanTable& table, const ScanRange& range, double time_s, double sigma_s, const Box& near);
}  // namespace rtob
