// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace rtob
{
/// Sectors of bearings, written as "170..190, -10..5" in degrees.
class AngleMask
{
 public:
    AngleMask() = default;
    /// @throws std::invalid_argument that quotes what is not a sector.
    explicit AngleMask(const std::string& sectors_deg);

    [[nodiscard]] bool contains(double bearing_rad) const;

 private:
    struct Sector
    {
        double begin_rad, width_rad;
    };
    std::vector<Sector> sectors_;
};
}  // namespace rtob
