// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <filesystem>

#include "carmen_text.h"
#include "log_files.h"
#include "temporary_file.h"

namespace rtob::test
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;

/// A little noise in every range, so that the packed log has some length.
std::string carmen_log(int lines)
{
    std::string text;
    for (int k = 0; k < lines; ++k)
    {
        std::string ranges;
        for (int i = 0; i < 30; ++i) ranges += " " + std::to_string((k * 7919 + i * 104729) % 9973);
        text += flaser("30" + ranges, "1 0 0", "1 0 0", std::to_string(k));
    }
    return text;
}

std::string rawlog(int scans)
{
    std::vector<mrpt::serialization::CSerializable::Ptr> objects;
    for (int k = 0; k < scans; ++k)
    {
        auto scan = mrpt::obs::CObservation2DRangeScan::Create();
        scan->timestamp = mrpt::Clock::fromDouble(k);
        scan->resizeScan(90);
        for (std::size_t i = 0; i < 90; ++i)
        {
            scan->setScanRange(i, static_cast<float>((k * 7919 + int(i) * 104729) % 9973) / 1000);
            scan->setScanRangeValidity(i, true);
        }
        objects.push_back(scan);
    }
    return rawlog_bytes(objects);
}

/// Whatever is cut off, it must be said, and the scans before must be those of the whole log.
void expect_cuts_are_told(const std::string& bytes, std::size_t whole_scans, std::size_t step)
{
    const TemporaryFile file(".cut");
    std::size_t scans_before = 0;
    for (std::size_t size = 1; size < bytes.size(); size += step)
    {
        std::ofstream(file.path(), std::ios::binary) << bytes.substr(0, size);
        const auto log = read_log(file.path());
        EXPECT_THAT(log.error, AllOf(HasSubstr(file.path()), HasSubstr("."))) << "cut at " << size;
        const auto scans = log.scans();
        EXPECT_GE(scans.size(), scans_before) << "cut at " << size;
        EXPECT_LE(scans.size(), whole_scans) << "cut at " << size;
        for (std::size_t k = 0; k < scans.size(); ++k)
            EXPECT_DOUBLE_EQ(mrpt::Clock::toDouble(scans[k]->timestamp), double(k));
        scans_before = scans.size();
    }
    // The last cuts leave nearly everything: what was read before them must have been given out.
    EXPECT_GE(scans_before, whole_scans / 2);
}

TEST(BadLog, ACutGzipRawlogIsTold)
{
    expect_cuts_are_told(gzip(rawlog(60)), 60, 97);
}
TEST(BadLog, ACutGzipTextLogIsTold)
{
    expect_cuts_are_told(gzip(carmen_log(120)), 120, 97);
}

TEST(BadLog, AMissingGzipTrailerIsTold)
{
    // All the data is there, only the check behind it is not: it may as well be a cut at a line
    // end.
    for (const auto& bytes : {gzip(carmen_log(1)), gzip(rawlog(1))})
        for (std::size_t missing = 1; missing <= 8; ++missing)
        {
            const TemporaryFile file(".gz", bytes.substr(0, bytes.size() - missing));
            EXPECT_THAT(read_log(file.path()).error, HasSubstr("cut short")) << missing;
        }
}

TEST(BadLog, ACutPlainRawlogIsToldUnlessBetweenEntries)
{
    const std::string bytes = rawlog(4);
    const std::size_t entry = bytes.size() / 4;
    const TemporaryFile file(".rawlog");
    for (std::size_t size = entry; size <= bytes.size(); ++size)
    {
        std::ofstream(file.path(), std::ios::binary) << bytes.substr(0, size);
        const auto log = read_log(file.path());
        EXPECT_EQ(log.scans().size(), size / entry) << size;
        if (size % entry == 0)
            EXPECT_EQ(log.error, "");
        else
            EXPECT_THAT(log.error, HasSubstr("truncated")) << size;
    }
}

TEST(BadLog, ACutBzip2LogIsTold)
{
    // bzip2 gives out whole blocks only (900 kB), so a small log gives all or nothing.
    const std::string bytes = bzip2(carmen_log(40));
    const TemporaryFile file(".clf.bz2");
    for (std::size_t size = 1; size < bytes.size(); size += 53)
    {
        std::ofstream(file.path(), std::ios::binary) << bytes.substr(0, size);
        EXPECT_NE(read_log(file.path()).error, "") << size;
    }
}

TEST(BadLog, FlippedBytesNeverPassAsACleanLog)
{
    const std::string bytes = gzip(carmen_log(60));
    const TemporaryFile file(".clf.gz");
    for (std::size_t place = 10; place < bytes.size(); place += 211)  // behind the header
    {
        std::string damaged = bytes;
        damaged[place] = static_cast<char>(damaged[place] ^ 0x55);
        std::ofstream(file.path(), std::ios::binary) << damaged;
        EXPECT_NE(read_log(file.path()).error, "") << place;
    }
}

TEST(BadLog, FlippedBytesOfARawlogNeverCrash)
{
    const std::string bytes = rawlog(3);
    const TemporaryFile file(".rawlog");
    for (std::size_t place = 0; place < bytes.size() / 3; ++place)
    {
        std::string damaged = bytes;
        damaged[place] = static_cast<char>(damaged[place] ^ 0x01);
        std::ofstream(file.path(), std::ios::binary) << damaged;
        EXPECT_LE(read_log(file.path()).scans().size(), 3U) << place;
    }
}

TEST(BadLog, MissingFileFolderAndEmptyFilesAreTold)
{
    EXPECT_THAT(
        read_log("/nowhere/a.rawlog").error,
        AllOf(HasSubstr("/nowhere/a.rawlog"), HasSubstr("No such file"), HasSubstr("Check")));
    EXPECT_THAT(read_log(testing::TempDir()).error, HasSubstr("folder"));
    for (const auto& content : {std::string(), gzip(""), bzip2("")})
    {
        const TemporaryFile file(".rawlog", content);
        EXPECT_NE(read_log(file.path()).error, "") << content.size();
    }
}

TEST(BadLog, ForeignFilesAreTold)
{
    for (const std::string& content :
         {std::string("\0\1\2\3\4\5", 6), std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16),
          std::string(
              "\x7f"
              "ELF\2\1\1\0",
              8)})
    {
        const TemporaryFile file(".log", content);
        EXPECT_THAT(read_log(file.path()).error, HasSubstr("neither an MRPT rawlog nor"))
            << content;
    }
    const TemporaryFile prose(".log", "Dear diary, today I drove around.\n");
    EXPECT_THAT(read_log(prose.path()).error, AllOf(HasSubstr("line 1"), HasSubstr("'Dear'")));
}

TEST(BadLog, ATextWithoutLineEndsIsNotReadIntoMemory)
{
    const TemporaryFile file(".log", "SYNC a\n" + std::string(40 << 20, 'A'));
    EXPECT_THAT(
        read_log(file.path()).error, AllOf(HasSubstr("line 2"), HasSubstr("16777216 bytes")));
}

TEST(BadLog, ErrorsKnowTheirFileAndPlace)
{
    const TemporaryFile file(".log", "SYNC a\nnonsense\n");
    const auto reader = open_log(file.path());
    try
    {
        static_cast<void>(reader->next());
        FAIL() << "nonsense was read";
    }
    catch (const LogError& error)
    {
        EXPECT_EQ(error.file(), file.path());
        EXPECT_EQ(error.place(), "line 2");
    }
}
}  // namespace
}  // namespace rtob::test
