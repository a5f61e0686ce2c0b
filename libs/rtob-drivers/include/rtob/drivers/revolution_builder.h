// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/drivers/rplidar_beam.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace rtob
{
/// Gathers beams into whole revolutions. A revolution with a hole wider than this is partial and
/// never given out: consumers take a missing sector for free space.
class RevolutionBuilder
{
 public:
    explicit RevolutionBuilder(double max_gap_deg = 10) : max_gap_deg_(max_gap_deg) {}

    /// @return the revolution that this beam ended
    [[nodiscard]] std::optional<RplidarRevolution> add(const RplidarBeam& beam);

    /// The device was restarted or silent: what was gathered is no part of a revolution.
    void forget();

    [[nodiscard]] std::uint64_t revolutions() const { return revolutions_; }
    [[nodiscard]] std::uint64_t partial() const { return partial_; }
    /// Beams at an angle that the head cannot have, as a damaged byte makes them.
    [[nodiscard]] std::uint64_t strayBeams() const { return stray_beams_; }

 private:
    [[nodiscard]] bool isStray(const RplidarBeam& beam) const;
    void setAside(const RplidarBeam& beam);
    [[nodiscard]] bool isWhole() const;
    void begin(const RplidarBeam& beam);
    void keep(const RplidarBeam& beam);

    double max_gap_deg_;
    RplidarRevolution now_;
    bool is_gathering_ = false;  ///< since a first beam
    double turned_deg_ = 0;      ///< since the first beam, as the beams tell it
    double last_shaft_deg_ = 0;
    std::vector<RplidarBeam> strays_;  ///< the last beams, none of which fits
    std::uint64_t revolutions_ = 0, partial_ = 0, stray_beams_ = 0;
};
}  // namespace rtob
