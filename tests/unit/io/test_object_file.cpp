// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <rtob/io/object_file.h>
#include <signal.h>
#include <sys/resource.h>

#include <filesystem>

#include "drive_log.h"
#include "error_message.h"
#include "log_files.h"
#include "temporary_folder.h"

namespace rtob::test
{
namespace
{
/// Files of this process may grow to so much, as on a disk that is nearly full.
class FileSizeLimit
{
 public:
    explicit FileSizeLimit(rlim_t bytes) : old_handler_(signal(SIGXFSZ, SIG_IGN))
    {
        getrlimit(RLIMIT_FSIZE, &old_);
        const rlimit limit{bytes, old_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit()
    {
        setrlimit(RLIMIT_FSIZE, &old_);
        signal(SIGXFSZ, old_handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
    rlimit old_{};
    void (*old_handler_)(int);
};

TEST(ObjectFile, IsReadByMrptObjectByObject)
{
    const TemporaryFolder folder;
    ObjectFile file(folder.file("a.rawlog"));
    for (int k = 0; k < 3; ++k) file.write(*odometry_on_circle(k));
    EXPECT_FALSE(std::filesystem::exists(folder.file("a.rawlog")));
    file.commit();

    mrpt::io::CFileGZInputStream in(folder.file("a.rawlog"));
    auto archive = mrpt::serialization::archiveFrom(in);
    for (int k = 0; k < 3; ++k)
    {
        const auto odometry =
            std::dynamic_pointer_cast<mrpt::obs::CObservationOdometry>(archive.ReadObject());
        ASSERT_TRUE(odometry);
        EXPECT_EQ(odometry->odometry.x(), odometry_on_circle(k)->odometry.x());
    }
}

TEST(ObjectFile, LeavesNothingBehindWithoutCommit)
{
    const TemporaryFolder folder;
    {
        ObjectFile file(folder.file("a.rawlog"));
        file.write(*odometry_on_circle(0));
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

/// Boost's packer would ask the full disk for ever.
TEST(ObjectFile, TellsThatTheDiskIsFull)
{
    const TemporaryFolder folder;
    const auto scan = scan_on_circle(0);
    const auto message = error_message(
        [&]
        {
            const FileSizeLimit limit(10'000);
            ObjectFile file(folder.file("a.rawlog"));
            for (int k = 0; k < 1000; ++k) file.write(*scan_on_circle(k));
            file.commit();
        });
    EXPECT_THAT(message, testing::HasSubstr("a.rawlog: cannot be written"));
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}
}  // namespace
}  // namespace rtob::test
