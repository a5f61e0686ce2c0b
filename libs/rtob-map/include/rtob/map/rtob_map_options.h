// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/reference_draw.h>
#include <rtob/core/time_density.h>

#include <cstdint>

namespace rtob
{
/// What a map is created with: which of its points are drawn for a scan, and how.
struct RtobMapOptions
{
    DensityOptions density;
    DrawOptions draw;
    std::uint64_t seed = 1;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        DensityOptions::fields(s.density, visit);
        DrawOptions::fields(s.draw, visit);
        visit("seed", s.seed, "same log, same options, same seed: same result");
    }
    void validate() const
    {
        density.validate();
        draw.validate();
    }
};
}  // namespace rtob
