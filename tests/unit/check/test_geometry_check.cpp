// SPDX-License-Identifier: BSD-3-Clause
#include <check_drive.h>
#include <gmock/gmock.h>
#include <rtob/check/geometry_check.h>

namespace rtob::test
{
namespace
{
using mrpt::obs::CObservation2DRangeScan;
using mrpt::poses::CPose3D;
using testing::HasSubstr;

constexpr double degree = 3.14159265358979323846 / 180;

/// 20 scans of so many beams over this field, each range different; the last five are spoilt.
template <class Spoil>
CheckReport check_scans(std::size_t beams, double field_deg, const CPose3D& mount, Spoil&& spoil)
{
    GeometryCheck check;
    for (int k = 0; k < 20; ++k)
    {
        const auto scan = scan_of(beams, 1 + 0.01F * static_cast<float>(k), true, 0.1 * k);
        scan->aperture = static_cast<float>(field_deg * degree);
        scan->sensorPose = mount;
        if (k >= 15) spoil(*scan);
        check.add(*scan);
    }
    CheckReport report;
    check.report(report);
    return report;
}

CheckReport check_scans(std::size_t beams, double field_deg, const CPose3D& mount = {})
{
    return check_scans(beams, field_deg, mount, [](auto&) {});
}

TEST(GeometryCheck, SaysBeamsFieldAndMount)
{
    const auto report = check_scans(180, 179, CPose3D(-0.04, 0.1, 0, -0.5 * degree, 0, 0));
    EXPECT_EQ(troubles(report), "");
    EXPECT_EQ(
        report.find("laser.beams")->text,
        "20 scans of 180 beams, from -90.0 to 89.0 deg of the vehicle, 1.000 deg apart");
    EXPECT_THAT(
        report.find("laser.mount")->text,
        HasSubstr("0.040 m behind and 0.100 m left of the vehicle's origin"));
    EXPECT_NEAR(figure(report, "laser.mount", "x_m"), -0.04, 1e-9);
    EXPECT_THAT(
        check_scans(180, 179).find("laser.mount")->text, HasSubstr("at the vehicle's origin"));
}

TEST(GeometryCheck, AnApertureThatAnImporterHalvedFails)
{
    EXPECT_EQ(troubles(check_scans(180, 90)), "FAIL laser.beams");
    EXPECT_EQ(troubles(check_scans(181, 90)), "FAIL laser.beams");
    EXPECT_EQ(troubles(check_scans(181, 180)), "");
    EXPECT_EQ(troubles(check_scans(361, 90)), "") << "0.25 deg apart is a mode of such scanners";
}

TEST(GeometryCheck, AGeometryThatChangesWarns)
{
    EXPECT_EQ(
        troubles(check_scans(181, 180, {}, [](auto& scan) { scan.aperture = 2; })),
        "WARN laser.beams");
    EXPECT_EQ(
        troubles(check_scans(181, 180, {}, [](auto& scan) { scan.sensorPose.x(0.5); })),
        "WARN laser.beams");
    EXPECT_EQ(
        troubles(check_scans(181, 180, {}, [](auto& scan) { scan.resizeScan(0); })),
        "WARN laser.beams");
}

TEST(GeometryCheck, FewBeamsWarnAndNoneFail)
{
    EXPECT_EQ(troubles(check_scans(30, 180)), "WARN laser.beams");
    EXPECT_EQ(troubles(check_scans(0, 180)), "FAIL laser.beams");
}

TEST(GeometryCheck, ATiltWarnsHangingDoesNot)
{
    EXPECT_EQ(
        troubles(check_scans(181, 180, CPose3D(0, 0, 0, 0, 5 * degree, 0))), "WARN laser.mount");
    EXPECT_EQ(
        troubles(check_scans(181, 180, CPose3D(0, 0, 0, 0, 0, 5 * degree))), "WARN laser.mount");
    const auto hanging = check_scans(181, 180, CPose3D(0, 0, 0, 0, 0, 180 * degree));
    EXPECT_EQ(troubles(hanging), "");
    EXPECT_THAT(hanging.find("laser.mount")->text, HasSubstr("upside down"));
}

TEST(GeometryCheck, ScansGivenOutTwiceWarn)
{
    const auto repeated = [](auto& scan)
    {
        for (std::size_t i = 0; i < scan.getScanSize(); ++i) scan.setScanRange(i, 3);
    };
    const auto report = check_scans(181, 180, {}, repeated);
    EXPECT_EQ(troubles(report), "WARN laser.repeats");
    EXPECT_EQ(figure(report, "laser.repeats", "repeated_scans"), 4);
}
}  // namespace
}  // namespace rtob::test
