// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/serialization/CArchive.h>
#include <rtob/io/capture_file.h>
#include <rtob/io/log_reader.h>

#include "temporary_folder.h"

namespace rtob
{
namespace
{
mrpt::obs::CObservationOdometry odometry(int number)
{
    mrpt::obs::CObservationOdometry odometry;
    odometry.odometry = {static_cast<double>(number), 0, 0};
    return odometry;
}

/// The numbers that a file gives, and -1 where it is damaged after them.
std::vector<int> numbers_in(const std::string& file)
{
    std::vector<int> numbers;
    const auto log = open_log(file);
    try
    {
        while (const auto entry = log->next())
            numbers.push_back(static_cast<int>(
                dynamic_cast<const mrpt::obs::CObservationOdometry&>(*entry->observation)
                    .odometry.x()));
    }
    catch (const LogError&)
    {
        numbers.push_back(-1);
    }
    return numbers;
}

class CaptureFileTest : public testing::Test
{
 protected:
    [[nodiscard]] std::string name() const { return folder_.file("log.rawlog"); }
    test::TemporaryFolder folder_;
};

TEST_F(CaptureFileTest, HoldsWhatWasFlushed)
{
    CaptureFile file(name());
    for (int i = 0; i < 6; ++i)
    {
        file.write(odometry(i));
        if (i == 2 || i == 4) file.flush();
    }
    EXPECT_EQ(std::vector<int>({0, 1, 2, 3, 4}), numbers_in(name())) << "still open";
    EXPECT_EQ(std::filesystem::file_size(name()), file.bytes());
}

TEST_F(CaptureFileTest, IsReadByMrptThroughTheJoints)
{
    {
        CaptureFile file(name());
        for (int i = 0; i < 3; ++i)
        {
            file.write(odometry(i));
            file.flush();
        }
    }
    mrpt::io::CFileGZInputStream in(name());
    auto archive = mrpt::serialization::archiveFrom(in);
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(i, archive.ReadObject<mrpt::obs::CObservationOdometry>()->odometry.x());
}

TEST_F(CaptureFileTest, KeepsAllBeforeATornEnd)
{
    std::uintmax_t whole = 0;
    {
        CaptureFile file(name());
        for (int i = 0; i < 5; ++i) file.write(odometry(i));
        file.flush();
        whole = file.bytes();
        for (int i = 5; i < 9; ++i) file.write(odometry(i));
        file.flush();
    }
    const auto torn = std::filesystem::file_size(name()) - 1;
    for (std::uintmax_t size = whole + 1; size <= torn; ++size)
    {
        const std::string copy = folder_.file("torn" + std::to_string(size));
        std::filesystem::copy_file(name(), copy);
        std::filesystem::resize_file(copy, size);
        const auto numbers = numbers_in(copy);
        ASSERT_GE(numbers.size(), 5u) << size;
        for (int i = 0; i < 5; ++i) EXPECT_EQ(i, numbers[static_cast<std::size_t>(i)]) << size;
    }
}

TEST_F(CaptureFileTest, NeverWritesOverAnotherOne)
{
    const CaptureFile file(name());
    EXPECT_THROW(CaptureFile{name()}, std::runtime_error);
    EXPECT_THROW(CaptureFile{folder_.file("none/log.rawlog")}, std::runtime_error);
}

TEST_F(CaptureFileTest, WritesNothingForAnEmptyFlush)
{
    CaptureFile file(name());
    file.flush();
    EXPECT_EQ(0u, std::filesystem::file_size(name()));
}
}  // namespace
}  // namespace rtob
