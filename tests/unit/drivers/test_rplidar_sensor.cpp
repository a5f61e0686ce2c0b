// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <rtob/devices/rplidar_on_terminal.h>
#include <rtob/drivers/rplidar_sensor.h>
#include <rtob/io/scan_timing.h>

#include <chrono>
#include <cmath>

#include "temporary_folder.h"

namespace rtob
{
namespace
{
using devices::LineFault;
using devices::RplidarOnTerminal;
using mrpt::obs::CObservation2DRangeScan;
using testing::HasSubstr;
using Clock = std::chrono::steady_clock;

double round_room(double, double)
{
    return 3;
}

/// A post 2 m away in this direction of the device, 10 degrees wide; nothing else.
devices::RangeSource post_at(double bearing_deg)
{
    return [=](double bearing_rad, double)
    {
        const double off = std::remainder(bearing_rad * 180 / M_PI - bearing_deg, 360);
        return std::abs(off) < 5 ? 2.0 : 0.0;
    };
}

class RplidarSensorTest : public testing::Test
{
 protected:
    [[nodiscard]] std::string port() const { return folder_.file("ttyRplidar"); }

    void configure(RtobRplidar& sensor, const std::string& keys = "") const
    {
        sensor.logging_enable_console_output = false;
        const mrpt::config::CConfigFileMemory config(
            "[LIDAR]\ndriver = RtobRplidar\nprocess_rate = 100\nsensorLabel = LASER\nCOM_port_LIN "
            "= " +
            port() + "\n" + keys);
        sensor.loadConfig(config, "LIDAR");
    }

    /// The scans until there are `count`, or those of `patience_s`.
    static std::vector<CObservation2DRangeScan::Ptr> scans(
        RtobRplidar& sensor, std::size_t count, double patience_s = 10)
    {
        std::vector<CObservation2DRangeScan::Ptr> scans;
        const auto end = Clock::now() + std::chrono::duration<double>(patience_s);
        while (scans.size() < count && Clock::now() < end)
        {
            sensor.doProcess();
            for (const auto& [stamp, object] : sensor.getObservations())
                if (auto scan = std::dynamic_pointer_cast<CObservation2DRangeScan>(object))
                    scans.push_back(scan);
        }
        return scans;
    }

    /// Where the middle of the post is seen from the vehicle.
    static mrpt::math::TPoint3D post_in(const CObservation2DRangeScan& scan)
    {
        mrpt::math::TPoint3D sum;
        double count = 0;
        for (std::size_t i = 0; i < scan.getScanSize(); ++i)
        {
            if (!scan.getScanRangeValidity(i)) continue;
            const double angle = scan.getScanAngle(i);
            sum += scan.sensorPose.composePoint(
                {scan.getScanRange(i) * std::cos(angle), scan.getScanRange(i) * std::sin(angle),
                 0});
            ++count;
        }
        return sum * (1 / count);
    }

    test::TemporaryFolder folder_;
};

struct Mount
{
    const char* name;
    double post_deg;  ///< seen from the device, counter-clockwise
    const char* keys;
    double x, y;  ///< where the vehicle has it
};

class Mounts : public RplidarSensorTest, public testing::WithParamInterface<Mount>
{
};

INSTANTIATE_TEST_SUITE_P(
    RplidarSensor, Mounts,
    testing::Values(
        Mount{"Ahead", 0, "", 2, 0}, Mount{"Left", 90, "", 0, 2}, Mount{"Behind", 180, "", -2, 0},
        Mount{"TurnedLeft", 0, "pose_yaw = 90\n", 0, 2},
        Mount{"TurnedRightPostLeft", 90, "pose_yaw = -90\n", 2, 0},
        Mount{"HangingPostAhead", 0, "upside_down = true\n", 2, 0},
        Mount{"HangingPostLeft", 90, "upside_down = true\n", 0, -2},
        Mount{"HangingTurned", 90, "upside_down = true\npose_yaw = 90\n", 2, 0},
        Mount{"CounterClockwise", 90, "clockwise = false\n", 0, -2},
        Mount{"Shifted", 0, "pose_x = 0.5\npose_y = -0.25\n", 2.5, -0.25}),
    [](const auto& param) { return std::string(param.param.name); });

TEST_P(Mounts, PutTheWorldWhereItIs)
{
    const RplidarOnTerminal device(port(), devices::model_s2(), post_at(GetParam().post_deg));
    RtobRplidar sensor;
    configure(
        sensor, std::string("scan_mode = denseboost\nCOM_baudRate = 1000000\n") + GetParam().keys);
    sensor.initialize();
    const auto seen = scans(sensor, 1);
    ASSERT_EQ(1u, seen.size());
    const auto post = post_in(*seen[0]);
    EXPECT_NEAR(GetParam().x, post.x, 0.01);  // the post's arc is 2 m * (1 - cos 2.5 deg) deep
    EXPECT_NEAR(GetParam().y, post.y, 0.01);
}

TEST_F(RplidarSensorTest, FindsTheSpeedAndTakesTheTypicalMode)
{
    const RplidarOnTerminal device(port(), devices::model_a3(), round_room);
    RtobRplidar sensor;
    configure(sensor);
    sensor.initialize();
    EXPECT_THAT(sensor.status().device, HasSubstr("RPLidar A3M1"));
    EXPECT_THAT(sensor.status().device, HasSubstr("mode Sensitivity, 256000 baud"));
    const auto seen = scans(sensor, 2);
    ASSERT_EQ(2u, seen.size());
    const auto& scan = *seen[1];
    EXPECT_EQ("LASER", scan.sensorLabel);
    EXPECT_FALSE(scan.rightToLeft);
    EXPECT_FLOAT_EQ(25.0f, scan.maxRange);
    EXPECT_GE(scan.getScanSize(), 1587u);  // 10 Hz, 63 us
    EXPECT_NEAR(3.0, scan.getScanRange(100), 0.005);
}

TEST_F(RplidarSensorTest, StampsAScanWithItsFirstBeamAndTellsItsSweep)
{
    const RplidarOnTerminal device(port(), devices::model_a2(), round_room);
    RtobRplidar sensor;
    configure(sensor, "COM_baudRate = 115200\n");
    sensor.initialize();
    std::vector<mrpt::serialization::CSerializable::Ptr> objects;
    while (objects.size() < 10)
    {
        sensor.doProcess();
        for (const auto& [stamp, object] : sensor.getObservations()) objects.push_back(object);
    }
    for (std::size_t i = 0; i < 10; i += 2)
    {
        const auto& record = dynamic_cast<const mrpt::obs::CObservation&>(*objects[i]);
        const auto& scan = dynamic_cast<const CObservation2DRangeScan&>(*objects[i + 1]);
        const auto timing = read_timing_record(record);
        ASSERT_TRUE(timing);
        EXPECT_NEAR(0.1, timing->sweep_s, 0.02);  // a busy machine may read late
        const double turns = device.shaftDeg(mrpt::Clock::toDouble(scan.timestamp)) / 360;
        EXPECT_NEAR(std::round(turns), turns, 0.2);
    }
}

TEST_F(RplidarSensorTest, MasksTheVehiclesOwnBody)
{
    const RplidarOnTerminal device(port(), devices::model_a1(), round_room);
    RtobRplidar sensor;
    configure(sensor, "mask_deg = 80..100\n");  // the device counts clockwise: its right
    sensor.initialize();
    const auto seen = scans(sensor, 1);
    ASSERT_EQ(1u, seen.size());
    std::size_t others = 0, seen_by_others = 0;
    for (std::size_t i = 0; i < seen[0]->getScanSize(); ++i)
    {
        const double angle = seen[0]->getScanAngle(i) + seen[0]->sensorPose.yaw();
        const double left_deg = std::remainder(angle * 180 / M_PI, 360);
        const bool is_valid = seen[0]->getScanRangeValidity(i);
        EXPECT_FALSE(is_valid && std::abs(left_deg + 90) < 9) << left_deg;
        if (std::abs(left_deg + 90) < 11) continue;
        ++others;
        seen_by_others += is_valid;
    }
    EXPECT_GT(seen_by_others, others * 9 / 10);  // some steps have no beam of their own
}

TEST_F(RplidarSensorTest, ComesBackAfterEachFault)
{
    RplidarOnTerminal device(port(), devices::model_a2(), round_room);
    RtobRplidar sensor;
    configure(sensor, "COM_baudRate = 115200\n");
    sensor.initialize();
    ASSERT_EQ(1u, scans(sensor, 1).size());
    for (const LineFault fault : devices::all_line_faults)
    {
        device.inject(fault, 0.3);
        static_cast<void>(scans(sensor, 1000, 0.35));
        EXPECT_EQ(2u, scans(sensor, 2, 8).size()) << "fault " << static_cast<int>(fault);
    }
    EXPECT_TRUE(sensor.status().is_connected);
    EXPECT_EQ("", sensor.status().problem);
    EXPECT_GE(sensor.status().reconnects, 3u);  // unplug, restart, error state
}

std::string message_of(RtobRplidar& sensor)
{
    try
    {
        sensor.initialize();
    }
    catch (const PortError& error)
    {
        return error.what();
    }
    return "no error";
}

TEST_F(RplidarSensorTest, SaysWhichPortIsMissing)
{
    RtobRplidar sensor;
    configure(sensor);
    EXPECT_THAT(message_of(sensor), HasSubstr(port() + " cannot be opened: No such file"));
}

TEST_F(RplidarSensorTest, SaysThatTheSpeedIsWrong)
{
    const RplidarOnTerminal device(port(), devices::model_a1(), round_room);
    RtobRplidar sensor;
    configure(sensor, "COM_baudRate = 256000\n");
    EXPECT_THAT(message_of(sensor), HasSubstr("does not answer at 256000 baud"));
}

TEST_F(RplidarSensorTest, SaysWhichModesThereAre)
{
    const RplidarOnTerminal device(port(), devices::model_a1(), round_room);
    RtobRplidar sensor;
    configure(sensor, "scan_mode = boost\n");
    EXPECT_THAT(
        message_of(sensor), HasSubstr("has no scan mode 'boost'. It has: Standard, Express."));
}

TEST_F(RplidarSensorTest, RefusesKeysThatNobodyReads)
{
    RtobRplidar sensor;
    try
    {
        configure(sensor, "upside_dwn = true\n");
        FAIL();
    }
    catch (const std::exception& error)
    {
        EXPECT_THAT(
            error.what(),
            HasSubstr("section LIDAR, unknown key 'upside_dwn'; did you mean 'upside_down'?"));
    }
}

TEST_F(RplidarSensorTest, LeavesTheDeviceAtRest)
{
    const RplidarOnTerminal device(port(), devices::model_a1(), round_room);
    {
        RtobRplidar sensor;
        configure(sensor);
        sensor.initialize();
        EXPECT_TRUE(device.isScanning());
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_FALSE(device.isScanning());
}
}  // namespace
}  // namespace rtob
