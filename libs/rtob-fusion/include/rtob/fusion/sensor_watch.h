// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/fusion/measurement.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace rtob
{
/// What became of a reading.
enum class ReadingFate
{
    Used,
    NotFused,       ///< the filter does not run: the guess is made without it
    Gated,          ///< it contradicts the rest: beyond the NIS gate
    NotFinite,      ///< NaN or infinite, value or stamp
    BadCovariance,  ///< not positive definite
    StampBack,      ///< older than one that came before
    StampRepeated,  ///< as old as the one before
    StampAhead,     ///< far ahead of all other sensors
    TooLate,        ///< older than what the filter keeps
    Implausible,    ///< out of the sensor's range, or a jump that no vehicle makes
    Stuck           ///< the same value for too long
};

constexpr auto enum_names(ReadingFate)
{
    return std::array<std::pair<ReadingFate, std::string_view>, 11>{
        {{ReadingFate::Used, "used"},
         {ReadingFate::NotFused, "not_fused"},
         {ReadingFate::Gated, "gated"},
         {ReadingFate::NotFinite, "not_finite"},
         {ReadingFate::BadCovariance, "bad_covariance"},
         {ReadingFate::StampBack, "stamp_back"},
         {ReadingFate::StampRepeated, "stamp_repeated"},
         {ReadingFate::StampAhead, "stamp_ahead"},
         {ReadingFate::TooLate, "too_late"},
         {ReadingFate::Implausible, "implausible"},
         {ReadingFate::Stuck, "stuck"}}};
}

/// Keeps an eye on one sensor: refuses what cannot be true before it reaches the filter, counts,
/// and says in words what is wrong with it.
class SensorWatch
{
 public:
    /// Stamp and value of a reading, before the filter sees it.
    /// @param newest_s of all sensors' stamps; NaN while there is none
    /// @return Used, or why it is refused; what is refused is counted already
    ReadingFate admit(const Measurement& reading, double newest_s);

    /// What the filter made of an admitted reading.
    void took(const Innovation& innovation);
    /// Why an admitted reading was refused after all.
    void refused(ReadingFate why) { ++fates_[static_cast<std::size_t>(why)]; }

    /// The clock of all sensors was set: stamps start anew.
    void restartClock() { last_s_ = first_s_ = std::numeric_limits<double>::quiet_NaN(); }

    [[nodiscard]] std::uint64_t with(ReadingFate fate) const
    {
        return fates_[static_cast<std::size_t>(fate)];
    }
    [[nodiscard]] std::uint64_t readings() const;  ///< of any fate
    [[nodiscard]] double lastStamp() const { return last_s_; }
    [[nodiscard]] double meanLag() const;  ///< of arrival, behind the newest stamp [s]
    [[nodiscard]] double longestGap() const { return longest_gap_s_; }
    /// Mean NIS by degree of freedom: 1 where the sensor's noise is what the filter was told.
    [[nodiscard]] double meanNis() const;
    /// Whether it gave readings, and gives none any more.
    [[nodiscard]] bool isSilent(double now_s) const;

    /// What is wrong, for people; empty: nothing. E.g. "silent for 12.0 s, late by 0.30 s".
    [[nodiscard]] std::string complaint(double now_s) const;

 private:
    [[nodiscard]] ReadingFate judge(const Measurement& reading, double newest_s);
    [[nodiscard]] double silenceToName() const;

    std::array<std::uint64_t, enum_names(ReadingFate{}).size()> fates_{};
    double first_s_ = std::numeric_limits<double>::quiet_NaN();
    double last_s_ = std::numeric_limits<double>::quiet_NaN();
    std::uint64_t admitted_ = 0;  ///< since first_s_
    double lag_sum_s_ = 0, longest_gap_s_ = 0, nis_sum_ = 0;
    std::uint64_t lags_ = 0, freedom_sum_ = 0;
    Eigen::Vector3d last_value_ = Eigen::Vector3d::Zero();
    int same_in_a_row_ = 0;
};
}  // namespace rtob
