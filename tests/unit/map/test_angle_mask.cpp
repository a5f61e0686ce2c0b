// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>
#include <rtob/map/angle_mask.h>

#include <stdexcept>
#include <string>

#include "error_message.h"

using mrpt::DEG2RAD;
using rtob::AngleMask;

TEST(AngleMask, IsEmptyByDefault)
{
    for (const char* none : {"", " "})
        for (int deg = -180; deg <= 180; deg += 10)
            EXPECT_FALSE(AngleMask(none).contains(DEG2RAD(deg * 1.0))) << deg;
    EXPECT_FALSE(AngleMask().contains(0));
}

TEST(AngleMask, HoldsTheBearingsOfEachSector)
{
    const AngleMask mask("-10..5, 90..100");
    for (const double deg : {-9.99, 0.0, 4.99, 90.01, 99.99})
        EXPECT_TRUE(mask.contains(DEG2RAD(deg))) << deg;
    for (const double deg : {-10.01, 5.01, 89.99, 100.01, 180.0, -95.0})
        EXPECT_FALSE(mask.contains(DEG2RAD(deg))) << deg;
}

TEST(AngleMask, WrapsAroundTheBack)
{
    const AngleMask mask("170..190");
    for (const double deg : {170.01, 179.0, 180.0, -180.0, -171.0, 189.0, 530.0})
        EXPECT_TRUE(mask.contains(DEG2RAD(deg))) << deg;
    for (const double deg : {169.0, 191.0, -169.0, 0.0})
        EXPECT_FALSE(mask.contains(DEG2RAD(deg))) << deg;
}

TEST(AngleMask, MayBeWiderThanHalfATurn)
{
    const AngleMask mask("-150..150");  // all but 60 degrees at the back
    for (int deg = -179; deg <= 180; ++deg)
    {
        if (std::abs(deg) == 150) continue;  // on the border
        EXPECT_EQ(mask.contains(DEG2RAD(deg * 1.0)), std::abs(deg) < 150) << deg;
    }
}

TEST(AngleMask, OfAFullTurnHoldsEverything)
{
    for (const char* all : {"0..360", "-180..180", "90..450"})
        for (int deg = -180; deg <= 180; ++deg)
            EXPECT_TRUE(AngleMask(all).contains(DEG2RAD(deg * 1.0))) << all << " " << deg;
}

TEST(AngleMask, QuotesWhatIsNoSector)
{
    for (const char* wrong : {"10", "10-20", "a..b", "10..", "..20", "20..10", "0..361", "1..nan"})
        EXPECT_THROW(AngleMask{wrong}, std::invalid_argument) << wrong;
    try
    {
        const AngleMask mask("0..5, 20..10");
        FAIL();
    }
    catch (const std::invalid_argument& e)
    {
        EXPECT_NE(std::string(e.what()).find("20..10"), std::string::npos) << e.what();
        EXPECT_NE(std::string(e.what()).find("mask_deg"), std::string::npos) << e.what();
    }
}
