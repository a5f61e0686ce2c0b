// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mrpt/obs/CObservationRawDAQ.h>
#include <rtob/io/log_reader.h>

#include <filesystem>
#include <random>

#include "capture.h"
#include "temporary_folder.h"

namespace rtob
{
namespace
{
/// Half a megabyte that no packing makes smaller, with a number.
mrpt::obs::CObservationRawDAQ::Ptr large_object(int number)
{
    auto daq = mrpt::obs::CObservationRawDAQ::Create();
    daq->sensorLabel = std::to_string(number);
    std::mt19937_64 random(static_cast<unsigned>(number));
    for (int i = 0; i < 65536; ++i) daq->AIN_double.push_back(static_cast<double>(random()) * 1e-3);
    return daq;
}

std::vector<std::string> labels_in(const std::string& file)
{
    std::vector<std::string> labels;
    const auto log = open_log(file);
    while (const auto entry = log->next()) labels.push_back(entry->observation->sensorLabel);
    return labels;
}

TEST(Capture, ALargeFileIsFollowedByAnother)
{
    const test::TemporaryFolder folder;
    CaptureOptions options;
    options.flush_s = 0.05;
    options.rotate_mb = 1;
    Capture capture(options, folder.path());
    for (int i = 0; i < 6; ++i)
    {
        capture.add(large_object(i));
        // Each is written before the next one comes.
        while (capture.state().objects <= static_cast<std::uint64_t>(i))
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    capture.finish();
    const auto state = capture.state();
    EXPECT_EQ(6u, state.objects);
    EXPECT_EQ("", state.problem);
    ASSERT_GE(state.files, 3u);
    std::vector<std::string> labels;
    std::uint64_t bytes = 0;
    for (std::size_t i = 0; i < state.files; ++i)
    {
        const auto file = folder.file("capture_00" + std::to_string(i) + ".rawlog");
        const auto size = std::filesystem::file_size(file);
        bytes += size;
        EXPECT_LT(size, 2'000'000u);
        if (size == 0) continue;  // the last one, where nothing came any more
        for (const auto& label : labels_in(file)) labels.push_back(label);
    }
    EXPECT_EQ(bytes, state.bytes);
    EXPECT_EQ((std::vector<std::string>{"0", "1", "2", "3", "4", "5"}), labels);
}

TEST(Capture, WhereItIsSwitchedOffNothingIsWritten)
{
    const test::TemporaryFolder folder;
    CaptureOptions options;
    options.enabled = false;
    Capture capture(options, folder.path());
    capture.add(large_object(0));
    capture.finish();
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    EXPECT_EQ(0u, capture.state().left_out);
}

TEST(Capture, RefusesAFolderThatIsNotThere)
{
    EXPECT_THROW(Capture(CaptureOptions(), "/not/there"), std::runtime_error);
}
}  // namespace
}  // namespace rtob
