// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/serialization/CArchive.h>
#include <rtob/io/checked_object.h>

#include <filesystem>

#include "error_message.h"
#include "temporary_folder.h"

namespace rtob::test
{
namespace
{
using mrpt::obs::CObservationOdometry;
using testing::AllOf;
using testing::HasSubstr;

const ObjectFormat format{"rtob test", 2, "what this test writes"};

class CheckedObject : public testing::Test
{
 protected:
    /// A file with an odometry of x = 3.
    [[nodiscard]] std::string write(const ObjectFormat& as = format) const
    {
        CObservationOdometry odometry;
        odometry.odometry = {3, 4, 0.5};
        const auto file = folder_.file("object");
        write_checked_object(file, as, odometry);
        return file;
    }
    [[nodiscard]] std::string refusal(const std::string& file) const
    {
        return error_message([&] { (void)read_checked_object(file, format); });
    }

    TemporaryFolder folder_;
};

TEST(Checksum, IsTheOneOfGzipWhateverThePortions)
{
    Checksum at_once, in_portions;
    at_once.add("123456789", 9);
    for (const char digit : std::string("123456789")) in_portions.add(&digit, 1);
    EXPECT_EQ(at_once.value(), 0xCBF43926U);  // the check value of CRC-32
    EXPECT_EQ(in_portions.value(), at_once.value());
    EXPECT_EQ(checksum_text(0x0BF43926U), "0bf43926");
}

TEST_F(CheckedObject, ComesBack)
{
    const auto object = read_checked_object(write(), format);
    const auto odometry = std::dynamic_pointer_cast<CObservationOdometry>(object);
    ASSERT_TRUE(odometry);
    EXPECT_EQ(odometry->odometry.x(), 3);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 1);
}

TEST_F(CheckedObject, IsAnyObjectToMrpt)
{
    mrpt::io::CFileGZInputStream in(write());
    const auto object = mrpt::serialization::archiveFrom(in).ReadObject();
    EXPECT_TRUE(std::dynamic_pointer_cast<CObservationOdometry>(object));
}

TEST_F(CheckedObject, EveryBitThatIsWrongIsSeen)
{
    const std::string whole = file_content(write());
    const std::size_t begin_of_comment = 10;
    const std::size_t trailer = 8;  // of gzip: says again what the comment says
    const std::size_t padded = 1;   // the last packed byte may end in bits that mean nothing
    for (std::size_t k = begin_of_comment; k < whole.size() - trailer - padded; ++k)
    {
        std::string damaged = whole;
        damaged[k] = static_cast<char>(damaged[k] ^ 0x04);
        EXPECT_NE(refusal(folder_.write("damaged", damaged)), "") << "byte " << k;
    }
}

TEST_F(CheckedObject, EveryCutIsSeen)
{
    const std::string whole = file_content(write());
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_THAT(
            refusal(folder_.write("cut", whole.substr(0, size))),
            testing::AnyOf(HasSubstr("is no rtob test"), HasSubstr("cut short or damaged")))
            << size << " bytes of " << whole.size();
}

TEST_F(CheckedObject, SaysWhatIsWrongAndWhatToDo)
{
    ObjectFormat newer = format;
    newer.version = 3;
    EXPECT_THAT(
        refusal(write(newer)),
        AllOf(HasSubstr("object: is in format 3"), HasSubstr("up to 2"), HasSubstr("newer")));
    ObjectFormat other = format;
    other.kind = "rtob other";
    EXPECT_THAT(
        refusal(write(other)),
        AllOf(HasSubstr("is no rtob test"), HasSubstr("Name what this test writes")));
    EXPECT_THAT(refusal(folder_.write("text", "# a text\n")), HasSubstr("is no rtob test"));
    EXPECT_THAT(
        refusal("/nowhere/map"),
        AllOf(HasSubstr("/nowhere/map: cannot be read"), HasSubstr("Check")));
    EXPECT_THAT(refusal("/tmp"), HasSubstr("/tmp: cannot be read: Is a directory"));
}

TEST_F(CheckedObject, NamesTheFileThatCannotBeWritten)
{
    EXPECT_THAT(
        error_message([&] { write_checked_object("/nowhere/a", format, CObservationOdometry()); }),
        HasSubstr("/nowhere/a: cannot be written"));
}
}  // namespace
}  // namespace rtob::test
