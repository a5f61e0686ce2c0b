// SPDX-License-Identifier: BSD-3-Clause
#include "observation_queue.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>

#include <vector>

namespace rtob
{
namespace
{
constexpr std::chrono::milliseconds no_wait{0};

template <class Observation>
mrpt::obs::CObservation::Ptr numbered(int number)
{
    auto observation = Observation::Create();
    observation->timestamp = mrpt::Clock::fromDouble(number);
    return observation;
}
mrpt::obs::CObservation::Ptr scan(int number)
{
    return numbered<mrpt::obs::CObservation2DRangeScan>(number);
}
mrpt::obs::CObservation::Ptr odometry(int number)
{
    return numbered<mrpt::obs::CObservationOdometry>(number);
}

/// Numbers in order; negative where dropped.
std::vector<int> all_of(ObservationQueue& queue)
{
    std::vector<int> numbers;
    while (const auto item = queue.pop(no_wait))
    {
        const int number =
            static_cast<int>(mrpt::Clock::toDouble(item->observation->timestamp) + 0.5);
        numbers.push_back(item->is_dropped ? -number : number);
    }
    return numbers;
}

TEST(ObservationQueue, KeepsTheOrderOfArrival)
{
    ObservationQueue queue(3, 100, [](const auto&) { FAIL(); });
    for (int i = 1; i <= 3; ++i)
    {
        queue.push(odometry(10 * i));
        queue.push(scan(i));
    }
    EXPECT_EQ(std::vector<int>({10, 1, 20, 2, 30, 3}), all_of(queue));
    EXPECT_EQ(0u, queue.droppedScans());
}

TEST(ObservationQueue, DropsTheOldestScanInItsPlace)
{
    ObservationQueue queue(2, 100, [](const auto&) { FAIL(); });
    queue.push(odometry(10));
    for (int i = 1; i <= 4; ++i) queue.push(scan(i));
    queue.push(odometry(20));
    EXPECT_EQ(std::vector<int>({10, -1, -2, 3, 4, 20}), all_of(queue));
    EXPECT_EQ(2u, queue.droppedScans());
}

TEST(ObservationQueue, AScanThatWasTakenMakesRoom)
{
    ObservationQueue queue(1, 100, [](const auto&) { FAIL(); });
    for (int i = 1; i <= 5; ++i)
    {
        queue.push(scan(i));
        EXPECT_EQ(std::vector<int>({i}), all_of(queue));
    }
}

TEST(ObservationQueue, NeverGrowsWithoutBound)
{
    std::vector<int> left;
    ObservationQueue queue(
        3, 10,
        [&](const QueuedObservation& item)
        {
            EXPECT_TRUE(item.is_dropped);
            left.push_back(
                static_cast<int>(mrpt::Clock::toDouble(item.observation->timestamp) + 0.5));
        });
    for (int i = 1; i <= 100; ++i) queue.push(i % 2 == 0 ? odometry(i) : scan(i));
    const auto rest = all_of(queue);
    EXPECT_EQ(10u, rest.size());
    EXPECT_EQ(90u, left.size());
    EXPECT_EQ(1, left.front());
    EXPECT_EQ(100, rest.back());
    EXPECT_EQ(47u, queue.droppedScans());  // of 50, the newest 3 wait
}

TEST(ObservationQueue, WaitsInVainOnlyForAWhile)
{
    ObservationQueue queue(1, 10, [](const auto&) {});
    EXPECT_FALSE(queue.pop(std::chrono::milliseconds(5)));
}
}  // namespace
}  // namespace rtob
