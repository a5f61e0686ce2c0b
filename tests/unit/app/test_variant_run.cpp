// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "compare/variant_run.h"
#include "drive_log.h"
#include "error_message.h"
#include "log_files.h"
#include "temporary_folder.h"

namespace rtob::test
{
namespace
{
using testing::HasSubstr;

constexpr int drive_scans = 5;

/// Stands still, slowly, and may say that it is lost.
class SlowVariant : public Variant
{
 public:
    explicit SlowVariant(std::optional<std::uint64_t> lost_scans) : lost_scans_(lost_scans) {}

    Pose2 process(const ScanStep& /*step*/) override
    {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        return {};
    }
    [[nodiscard]] VariantMap map() const override { return {}; }
    [[nodiscard]] std::optional<std::uint64_t> lostScans() const override { return lost_scans_; }

 private:
    std::optional<std::uint64_t> lost_scans_;
};

class VariantRun : public testing::Test
{
 protected:
    [[nodiscard]] VariantJob job() const
    {
        VariantJob job;
        job.log = folder_.write("drive.rawlog", rawlog_bytes(drive_objects(drive_scans)));
        job.folder = folder_.path();
        return job;
    }
    void run(const VariantJob& job, std::optional<std::uint64_t> lost_scans = {}) const
    {
        run_variant(
            job, [&](const VariantJob&) { return std::make_unique<SlowVariant>(lost_scans); });
    }

    const TemporaryFolder folder_;
};

TEST_F(VariantRun, IsReadBackAsItRan)
{
    run(job(), 3);
    ComparedRun read;
    read_variant_run(folder_.path(), read);
    EXPECT_EQ(read.trajectory.size(), static_cast<std::size_t>(drive_scans));
    EXPECT_EQ(read.scan_cpu_ms.size(), static_cast<std::size_t>(drive_scans));
    for (const float wall_ms : read.scan_wall_ms) EXPECT_GE(wall_ms, 5);
    EXPECT_EQ(read.lost_scans, 3U);
}

TEST_F(VariantRun, AProgramThatCannotBeLostSaysNothing)
{
    run(job());
    ComparedRun read;
    read_variant_run(folder_.path(), read);
    EXPECT_FALSE(read.lost_scans);
}

TEST_F(VariantRun, EndsWhereItTakesTooLong)
{
    auto limited = job();
    limited.time_limit_s = 0.012;  // between the second scan and the third, at the earliest
    const auto message = error_message([&] { run(limited); });
    EXPECT_THAT(message, HasSubstr("too slow: ended at scan "));
    EXPECT_THAT(message, HasSubstr("--time-limit"));
    EXPECT_FALSE(std::filesystem::exists(folder_.file("result.json")));
    limited.time_limit_s = 600;
    run(limited);
    EXPECT_TRUE(std::filesystem::exists(folder_.file("result.json")));
}
}  // namespace
}  // namespace rtob::test
