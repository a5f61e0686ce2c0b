// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/drivers/rplidar_beam.h>

#include <cstddef>
#include <vector>

namespace rtob
{
/// Ranges at even steps of the bearing: step i stands for (i + 0.5) * 360 / size degrees. They are
/// in the order in which the head passed them.
struct GriddedRevolution
{
    std::vector<float> ranges_m;  ///< 0: nothing seen, or no beam
    [[nodiscard]] double stepDeg() const { return 360.0 / static_cast<double>(ranges_m.size()); }
};

/// Puts beams at uneven angles into even steps, as scan messages want them. Steps are never wider
/// than the mean distance between two beams, so no beam moves by more than half of that.
class BeamGrid
{
 public:
    /// @param beams steps of the circle; 0: as many as the device takes
    explicit BeamGrid(std::size_t beams = 0) : wanted_(beams) {}

    [[nodiscard]] GriddedRevolution grid(const RplidarRevolution& revolution);

 private:
    void chooseSize(std::size_t beams);

    std::size_t wanted_;
    std::size_t size_ = 0;
    int much_smaller_in_a_row_ = 0;
};
}  // namespace rtob
