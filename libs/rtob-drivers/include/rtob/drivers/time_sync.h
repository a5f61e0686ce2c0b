// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <optional>

namespace rtob
{
/// Keeps the offset between the autopilot's clock and ours, by MAVLink's TIMESYNC.
class TimeSync
{
 public:
    /// An answer to our question: when we asked, what the other clock showed, when it came [ns].
    void answered(std::int64_t asked_ns, std::int64_t other_ns, std::int64_t now_ns);

    [[nodiscard]] bool isSynchronised() const { return samples_ >= kSamplesUntilSynchronised; }
    /// A time of the autopilot as our UNIX time; nothing while the clocks are not known well.
    [[nodiscard]] std::optional<double> toOurs(std::int64_t other_ns) const;
    [[nodiscard]] std::uint64_t refused() const { return refused_; }
    [[nodiscard]] double roundTrip_s() const { return 1e-9 * static_cast<double>(best_trip_ns_); }

 private:
    static constexpr int kSamplesUntilSynchronised = 5;

    double offset_ns_ = 0;  ///< other - ours
    std::int64_t best_trip_ns_ = 0;
    int samples_ = 0;
    int surprises_in_a_row_ = 0;
    std::uint64_t refused_ = 0;
};
}  // namespace rtob
