// SPDX-License-Identifier: BSD-3-Clause
// Random situations against a plain simulation of what the vehicle may do with the answer. The
// number of situations is RTOB_SITUATIONS, counted from RTOB_FIRST_SITUATION; `./dev soak` asks for
// a million.
#include <gtest/gtest.h>
#include <guard_situation.h>
#include <stopping_oracle.h>

#include <cstdlib>

using namespace rtob;
using namespace rtob::test;

namespace
{
std::uint64_t number_from(const char* variable, std::uint64_t otherwise)
{
    const char* wanted = std::getenv(variable);
    return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : otherwise;
}
}  // namespace

TEST(GuardProperty, TheVehicleCanAlwaysStop)
{
    std::uint64_t moving = 0, bent = 0, limited = 0;
    const std::uint64_t all = number_from("RTOB_SITUATIONS", 2000);
    const std::uint64_t first = number_from("RTOB_FIRST_SITUATION", 1);
    for (std::uint64_t seed = first; seed < first + all; ++seed)
    {
        const GuardSituation situation = SituationDraw(seed).draw();
        const GuardAnswer answer = answer_to(situation);
        const std::string wrong = complaint(situation, answer, seed);
        if (!wrong.empty())
        {
            const auto fails = [&](const GuardSituation& s) { return !complaint(s, seed).empty(); };
            const GuardSituation smallest = shrunk(situation, fails);
            FAIL() << "seed " << seed << ": " << wrong << "\nsmallest:\n"
                   << text_of(smallest) << complaint(smallest, seed);
        }
        const GuardDecision& decision = answer.decision;
        moving += decision.velocity_vehicle.norm() > 0 ? 1 : 0;
        bent += decision.reason == GuardReason::Guided ? 1 : 0;
        limited += decision.velocity_vehicle != situation.wish ? 1 : 0;
    }
    // The situations are neither all harmless nor all hopeless.
    EXPECT_GT(moving, all / 3);
    EXPECT_GT(bent, all / 50);
    EXPECT_GT(limited, all / 3);
    std::printf(
        "%llu situations: %llu moving, %llu bent, %llu limited\n",
        static_cast<unsigned long long>(all), static_cast<unsigned long long>(moving),
        static_cast<unsigned long long>(bent), static_cast<unsigned long long>(limited));
}

// An oracle that accepts everything would prove nothing: a guard with a wrong idea of its vehicle
// is found out.
TEST(GuardProperty, TheOracleFindsAGuardThatCountsOnTooMuch)
{
    std::uint64_t found = 0;
    for (std::uint64_t seed = 1; seed <= 600; ++seed)
    {
        GuardSituation situation = SituationDraw(seed).draw();
        GuardAnswer answer = answer_to(situation);
        answer.decision.velocity_vehicle =
            situation.wish.norm() < 50 ? situation.wish : Eigen::Vector2d(2, 0);
        VehicleBehaviour late;
        late.acceleration_mps2 = situation.limits.braking();
        late.response_s = situation.limits.response_s;
        late.next_decision_s = situation.limits.period_s;
        late.latencies_s.assign(answer.earlier_commands.size() + 2, situation.limits.latency_s);
        for (const auto& place :
             stopping_path(situation, answer, answer.decision.velocity_vehicle, late))
            if (std::any_of(
                    answer.obstacles.begin(), answer.obstacles.end(),
                    [&](const auto& obstacle)
                    { return (obstacle - place).norm() < situation.limits.radius_m; }))
            {
                ++found;
                break;
            }
    }
    EXPECT_GT(found, 30u);
}

TEST(GuardProperty, AWishIsGrantedUnchangedWhereNothingIsNear)
{
    for (std::uint64_t seed = 1; seed <= 500; ++seed)
    {
        GuardSituation situation = SituationDraw(seed).draw();
        for (auto* beams : {&situation.seen, &situation.remembered})
            for (auto& beam : *beams) beam.range_m += 30;  // beyond any stopping distance here
        if (situation.seen.empty()) continue;
        if (situation.wish.norm() > situation.limits.max_speed_mps) situation.wish *= 0.01;
        const GuardDecision decision = answer_to(situation).decision;
        EXPECT_EQ(decision.velocity_vehicle, situation.wish) << "seed " << seed;
        EXPECT_EQ(decision.reason, GuardReason::Free) << "seed " << seed;
    }
}

TEST(GuardProperty, NoWishIsNoMotion)
{
    for (std::uint64_t seed = 1; seed <= 500; ++seed)
    {
        GuardSituation situation = SituationDraw(seed).draw();
        situation.wish.setZero();
        EXPECT_TRUE(answer_to(situation).decision.velocity_vehicle.isZero()) << "seed " << seed;
    }
}

TEST(GuardProperty, AShrunkSituationIsSmallAndStillFails)
{
    GuardSituation situation = SituationDraw(7).draw();
    situation.seen = {{10, 1.0F}, {20, 2.0F}, {30, 3.0F}, {40, 4.0F}, {50, 5.0F}};
    const auto fails = [](const GuardSituation& s)
    {
        return std::any_of(
            s.seen.begin(), s.seen.end(), [](const auto& beam) { return beam.degree == 30; });
    };
    const GuardSituation smallest = shrunk(situation, fails);
    ASSERT_EQ(smallest.seen.size(), 1u);
    EXPECT_EQ(smallest.seen[0].degree, 30);
    EXPECT_TRUE(smallest.remembered.empty());
    EXPECT_NE(text_of(smallest).find("s.seen = {{30, 3F}, };"), std::string::npos);
}
