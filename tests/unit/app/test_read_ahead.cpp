// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mrpt/obs/CObservationOdometry.h>

#include "run/read_ahead.h"

namespace rtob::test
{
namespace
{
/// Gives out so many observations, the k-th with x = k, and then ends or throws.
class CountingReader : public LogReader
{
 public:
    CountingReader(int entries, bool is_cut) : entries_(entries), is_cut_(is_cut) {}

    std::optional<LogEntry> next() override
    {
        if (given_ == entries_ && is_cut_) throw LogError("f.log", "entry 7", "is cut", "");
        if (given_ == entries_) return std::nullopt;
        auto odometry = mrpt::obs::CObservationOdometry::Create();
        odometry->odometry.x(given_++);
        return LogEntry{odometry, nullptr};
    }
    double progress() const override { return given_ / static_cast<double>(entries_); }
    LogLosses losses() const override { return {{"lines of no use", 3}}; }

 private:
    int entries_;
    bool is_cut_;
    int given_ = 0;
};

/// How many entries come, each in its turn.
int read_in_order(ReadAhead& reader)
{
    int count = 0;
    while (const auto entry = reader.next())
    {
        const auto& odometry =
            dynamic_cast<const mrpt::obs::CObservationOdometry&>(*entry->observation);
        EXPECT_EQ(odometry.odometry.x(), count);
        ++count;
    }
    return count;
}
}  // namespace

TEST(ReadAhead, GivesOutEachEntryInItsOrder)
{
    ReadAhead reader(std::make_unique<CountingReader>(5000, false));
    EXPECT_EQ(read_in_order(reader), 5000);
    EXPECT_FALSE(reader.next().has_value()) << "it stays at its end";
    EXPECT_EQ(reader.progress(), 1);
    EXPECT_EQ(reader.losses().at("lines of no use"), 3U);
}

TEST(ReadAhead, ThrowsTheReadersErrorAfterAllEntriesBeforeIt)
{
    ReadAhead reader(std::make_unique<CountingReader>(700, true));
    int count = 0;
    EXPECT_THROW(while (reader.next())++ count, LogError);
    EXPECT_EQ(count, 700);
}

TEST(ReadAhead, EndsThoughNobodyReadsOn)
{
    ReadAhead reader(std::make_unique<CountingReader>(1000000, false));
    EXPECT_TRUE(reader.next().has_value());
}
}  // namespace rtob::test
