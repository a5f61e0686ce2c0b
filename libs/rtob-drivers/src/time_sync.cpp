// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/drivers/time_sync.h>

#include <cmath>

namespace rtob
{
namespace
{
/// A slow answer tells little: its way there and back were not equally long.
constexpr double kSlowerThanBest = 3;
constexpr std::int64_t kSlack_ns = 2'000'000, kSlowest_ns = 100'000'000;
/// The autopilot was restarted, or a clock was set.
constexpr double kSurprise_ns = 20e6;
constexpr int kSurprisesUntilBelieved = 5;
constexpr double kSmoothing = 0.1;
}  // namespace

void TimeSync::answered(std::int64_t asked_ns, std::int64_t other_ns, std::int64_t now_ns)
{
    const std::int64_t trip_ns = now_ns - asked_ns;
    const bool is_slow =
        samples_ > 0 && static_cast<double>(trip_ns) >
                            kSlowerThanBest * static_cast<double>(best_trip_ns_ + kSlack_ns);
    if (trip_ns < 0 || trip_ns > kSlowest_ns || is_slow)
    {
        ++refused_;
        return;
    }
    const double offset_ns =
        static_cast<double>(other_ns - asked_ns) - 0.5 * static_cast<double>(trip_ns);
    const bool is_surprise = samples_ > 0 && std::abs(offset_ns - offset_ns_) > kSurprise_ns;
    surprises_in_a_row_ = is_surprise ? surprises_in_a_row_ + 1 : 0;
    if (is_surprise && surprises_in_a_row_ < kSurprisesUntilBelieved) return;
    if (is_surprise) samples_ = 0;
    surprises_in_a_row_ = 0;
    offset_ns_ = samples_ == 0 ? offset_ns : offset_ns_ + kSmoothing * (offset_ns - offset_ns_);
    best_trip_ns_ = samples_ == 0 || trip_ns < best_trip_ns_ ? trip_ns : best_trip_ns_;
    ++samples_;
}

std::optional<double> TimeSync::toOurs(std::int64_t other_ns) const
{
    if (!isSynchronised()) return std::nullopt;
    return 1e-9 * (static_cast<double>(other_ns) - offset_ns_);
}
}  // namespace rtob
