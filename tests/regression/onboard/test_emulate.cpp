// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/io/capture_file.h>

#include "onboard_capture.h"

namespace rtob::test
{
namespace
{
using testing::HasSubstr;

/// Some seconds of a vehicle that stands in the house.
std::string house_log(const TemporaryFolder& folder)
{
    CaptureFile log(folder.file("house.rawlog"));
    for (int scan = 0; scan < 60; ++scan) log.write(scan_in_house_at(0, 1000 + 0.1 * scan));
    log.flush();
    return log.name();
}

TEST_F(Onboard, FliesWithALaserThatAnotherProgramEmulates)
{
    RunningProgram emulator(
        RTOB_PROGRAM, {"emulate", "rplidar-a2", house_log(folder_), "--port", laserPort()});
    for (const double end = unix_time_s() + 60;
         !std::filesystem::exists(laserPort()) && unix_time_s() < end;)
        wait_s(0.05);
    ASSERT_NE("", fly(write(), 15));
    EXPECT_EQ("TRACKING", states_.states().back()["state"].get<std::string>());
    emulator.send(SIGTERM);
    EXPECT_EQ(0, emulator.wait().exit_code);
    EXPECT_FALSE(std::filesystem::exists(laserPort())) << "it takes its port with it";
}

TEST_F(Onboard, EmulateSaysHowToReachItAndWhatIsWrong)
{
    const auto emulate = [](const std::vector<std::string>& arguments)
    {
        std::vector<std::string> all{"emulate"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        return run_program(RTOB_PROGRAM, all);
    };
    EXPECT_EQ(2, emulate({"rplidar-x9", "any.rawlog"}).exit_code);
    EXPECT_EQ(1, emulate({"hokuyo", "/not/there.rawlog"}).exit_code);
    const auto good = emulate({"hokuyo", house_log(folder_), "--seconds", "0.1"});
    EXPECT_EQ(0, good.exit_code) << good.err;
    EXPECT_THAT(good.out, HasSubstr("driver = CHokuyoURG, IP_DIR = 127.0.0.1, PORT_DIR = "));
    std::filesystem::remove(folder_.file("house.rawlog"));
    const auto port = emulate({"hokuyo", house_log(folder_), "--port", "any"});
    EXPECT_EQ(1, port.exit_code);
    EXPECT_THAT(port.err, HasSubstr("--port any: must be a TCP port"));
    // A file of the user's is no port.
    const auto file = folder_.write("notes.txt", "mine");
    EXPECT_EQ(1, emulate({"rplidar-a2", folder_.file("house.rawlog"), "--port", file}).exit_code);
    EXPECT_EQ("mine", file_content(file));
}
}  // namespace
}  // namespace rtob::test
