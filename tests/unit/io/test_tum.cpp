// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <rtob/io/log_reader.h>
#include <rtob/io/tum.h>

#include <cmath>
#include <sstream>

#include "error_message.h"
#include "temporary_file.h"

namespace rtob::test
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;

std::string error_of(const std::string& text)
{
    const TemporaryFile file(".tum", text);
    return error_message<LogError>([&] { static_cast<void>(read_tum(file.path())); });
}

TEST(Tum, WritesTheTextByTheRule)
{
    std::ostringstream out;
    // A third of a turn: half of it is 60 deg, sin 0.866025403784, cos 0.5.
    write_tum(out, {{976052857.337530, {1.25, -2, 0}}, {5, {0, 0.0000014, 2.0943951023931953}}});
    EXPECT_EQ(
        out.str(),
        "976052857.337530 1.250000 -2.000000 0 0 0 0.000000000 1.000000000\n"
        "5.000000 0.000000 0.000001 0 0 0 0.866025404 0.500000000\n");
}

TEST(Tum, IsNotChangedByTheStreamsOwnFormat)
{
    std::ostringstream plain, odd;
    const std::vector<StampedPose2> poses{{1031745838.717, {123456.789, 1e-7, -3}}};
    odd.precision(2);
    odd.setf(std::ios::scientific);
    write_tum(plain, poses);
    write_tum(odd, poses);
    EXPECT_EQ(odd.str(), plain.str());
}

TEST(Tum, ComesBackFromAFile)
{
    std::vector<StampedPose2> poses;
    for (int k = 0; k < 100; ++k)
        poses.push_back({1e9 + 0.1 * k, {k * 0.37 - 20, 40 - k * 0.91, wrap_angle(0.7 * k)}});
    poses.push_back({1e9 - 5, {0, 0, -3.14159265358979}});  // stamps may step back
    const TemporaryFile file(".tum");
    write_tum(file.path(), poses);
    const auto back = read_tum(file.path());
    ASSERT_EQ(back.size(), poses.size());
    for (std::size_t i = 0; i < poses.size(); ++i)
    {
        EXPECT_NEAR(back[i].time_s, poses[i].time_s, 0.6e-6);  // half the last decimal
        EXPECT_NEAR(back[i].pose.x, poses[i].pose.x, 0.6e-6);
        EXPECT_NEAR(back[i].pose.y, poses[i].pose.y, 0.6e-6);
        EXPECT_NEAR(wrap_angle(back[i].pose.yaw - poses[i].pose.yaw), 0, 3e-9);
    }
}

TEST(Tum, ReadsCommentsBlanksAndAllQuaternionsFromAbove)
{
    const TemporaryFile file(
        ".tum",
        "# time x y z q\n\n"
        "1 2 3 4 0 0 -0.70710678 -0.70710678\n"
        "  2\t0 0 0 0.5 0.5 0.5 0.5\r\n");
    const auto poses = read_tum(file.path());
    ASSERT_EQ(poses.size(), 2U);
    EXPECT_EQ(poses[0].time_s, 1);
    EXPECT_EQ(poses[0].pose.x, 2);
    EXPECT_EQ(poses[0].pose.y, 3);
    EXPECT_NEAR(poses[0].pose.yaw, std::acos(0.0), 1e-9);  // q and -q are one turn
    // (w,x,y,z) = 0.5 each takes x to y to z to x: the vehicle's x axis points along map's y.
    EXPECT_NEAR(poses[1].pose.yaw, std::acos(0.0), 1e-9);
}

TEST(Tum, NamesLineAndFault)
{
    const std::string good = "1 0 0 0 0 0 0 1\n";
    EXPECT_THAT(error_of(good + "2 0 0 0 0 0 1\n"), AllOf(HasSubstr("line 2"), HasSubstr("qw")));
    EXPECT_THAT(error_of("#\n2 0 0 0 0 0 0 1 9\n"), AllOf(HasSubstr("line 2"), HasSubstr("eight")));
    EXPECT_THAT(error_of("2 0 0 0 0 0 0 2\n"), AllOf(HasSubstr("line 1"), HasSubstr("quaternion")));
    EXPECT_THAT(error_of("2 0 0 0 0 0 0 0\n"), HasSubstr("quaternion"));
    EXPECT_THAT(error_of("2 nan 0 0 0 0 0 1\n"), HasSubstr("x is not a finite number"));
    EXPECT_THAT(error_of("2 0,5 0 0 0 0 0 1\n"), HasSubstr("'0,5'"));
    EXPECT_THAT(error_of(""), HasSubstr("empty"));
    EXPECT_THAT(
        error_message<LogError>([] { static_cast<void>(read_tum("/nowhere/a.tum")); }),
        HasSubstr("/nowhere/a.tum"));
}
}  // namespace
}  // namespace rtob::test
