// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/scan_table.h>
#include <rtob/core/time_density.h>

#include <cmath>

namespace rtob::test
{
/// p(t) as sec. 2.3.2 and 2.3.3 print it (the Gaussian's bracket as meant), over all scans and
/// without constant factors: slow and exact.
inline double density_formula(
    const DensityOptions& options, const ScanTable& scans, const Moment& now, double time_s)
{
    double p = 1;
    const double age_s = now.time_s - time_s;
    if (options.density == Density::Interval)
        p = time_s >= options.interval_begin_s && time_s <= options.interval_end_s;
    if (options.density == Density::Window) p = age_s <= options.window_s;
    if (options.density == Density::Revisit)
    {
        p = 0;
        const double half_width =
            options.vicinity_m > 0 ? options.vicinity_m : options.laser_range_m / std::sqrt(2.0);
        for (std::size_t k = 0; k < scans.size(); ++k)
        {
            if (std::abs(scans.x(k) - now.x) > half_width) continue;
            if (std::abs(scans.y(k) - now.y) > half_width) continue;
            const double z = (time_s - scans.time(k)) / (std::sqrt(2.0) * options.sigma_s);
            p += std::exp(-z * z);
        }
    }
    if (options.forgetting_s > 0) p *= std::exp(-age_s / options.forgetting_s);
    return p;
}
}  // namespace rtob::test
