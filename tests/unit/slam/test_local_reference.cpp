// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/slam/local_reference.h>

#include <stdexcept>

using namespace rtob;

namespace
{
constexpr Box kNeeded{-1, -1, 1, 1};

/// Four points at the corners of a square of 1 m around (10, 20).
void draw_square(const Box&, Reference& reference)
{
    reference = {};
    reference.origin_x = 10;
    reference.origin_y = 20;
    for (const float x : {-0.5f, 0.5f})
        for (const float y : {-0.5f, 0.5f})
        {
            reference.indices.push_back(reference.points.size());
            reference.points.add(x, y);
        }
}

LocalReference drawn(const ReferenceOptions& options = {})
{
    LocalReference local(options);
    local.renew(Icp(), 5.0, {}, kNeeded, draw_square);
    return local;
}

IcpResult fit_of(double paired_share)
{
    IcpResult fit;
    fit.paired_share = paired_share;
    return fit;
}
}  // namespace

TEST(LocalReference, ServesNothingBeforeItIsDrawn)
{
    EXPECT_FALSE(LocalReference().serves(0, {}, kNeeded));
}

TEST(LocalReference, ServesWhileTheVehicleIsNearTimeIsShortAndTheScanLiesWithin)
{
    const ReferenceOptions options{0.25, 2, 0.02};
    const LocalReference local = drawn(options);
    EXPECT_TRUE(local.serves(5.1, {0.2, 0.1, 3}, kNeeded));
    EXPECT_FALSE(local.serves(5.1, {0.2, 0.2, 0}, kNeeded));  // 0.28 m away
    EXPECT_FALSE(local.serves(7.1, {}, kNeeded));
    EXPECT_TRUE(local.serves(5.1, {}, kNeeded.grown(0.24)));
    EXPECT_FALSE(local.serves(5.1, {}, kNeeded.grown(0.26)));
}

TEST(LocalReference, DrawsFartherThanTheScanNeeds)
{
    LocalReference local(ReferenceOptions{0.25, 2, 0.02});
    Box asked;
    local.renew(
        Icp(), 0, {}, kNeeded,
        [&](const Box& box_map, Reference& reference)
        {
            asked = box_map;
            draw_square(box_map, reference);
        });
    EXPECT_EQ(asked.max_x, 1.25);
    EXPECT_EQ(asked.min_y, -1.25);
}

TEST(LocalReference, OneDrawAScanWhereThatIsAsked)
{
    EXPECT_FALSE(drawn({0, 2, 0.02}).serves(5, {}, kNeeded));
}

TEST(LocalReference, ServesNoMoreAfterADrop)
{
    LocalReference local = drawn();
    ASSERT_TRUE(local.serves(5, {}, kNeeded));
    local.drop();
    EXPECT_FALSE(local.serves(5, {}, kNeeded));
}

TEST(LocalReference, AlignsAScanWhereverItWasDrawnFrom)
{
    // The vehicle stands 0.2 m beside the origin of the sample; its guess is 5 cm off.
    LocalReference local = drawn();
    Points scan;
    for (const float x : {-0.5f, 0.5f})
        for (const float y : {-0.5f, 0.5f}) scan.add(x - 0.2f, y);
    Icp icp;
    const IcpResult fit = local.align(icp, scan.view(), {10.2 + 0.05, 20, 0});
    EXPECT_NEAR(fit.correction.x, -0.05, 1e-4);
    EXPECT_NEAR(fit.correction.y, 0, 1e-4);
    EXPECT_EQ(fit.pairs, 4u);
}

TEST(LocalReference, IsWorseWhenItExplainsLessThanOfTheFirstScan)
{
    LocalReference local = drawn({0.25, 2, 0.1});
    EXPECT_FALSE(local.isWorse(fit_of(0)));  // there is no first yet
    Points scan;
    for (const float x : {-0.5f, 0.5f})
        for (const float y : {-0.5f, 0.5f}) scan.add(x, y);
    Icp icp;
    ASSERT_EQ(local.align(icp, scan.view(), {10, 20, 0}).paired_share, 1.0);
    EXPECT_FALSE(local.isWorse(fit_of(0.95)));
    EXPECT_TRUE(local.isWorse(fit_of(0.85)));
    local.renew(icp, 6, {}, kNeeded, draw_square);
    EXPECT_FALSE(local.isWorse(fit_of(0.5)));
}

TEST(ReferenceOptions, RefusesWhatIsOutOfRange)
{
    EXPECT_THROW(LocalReference({-0.1, 2, 0.02}), std::invalid_argument);
    EXPECT_THROW(LocalReference({0.1, -1, 0.02}), std::invalid_argument);
    EXPECT_THROW(LocalReference({0.1, 2, 1.5}), std::invalid_argument);
}
