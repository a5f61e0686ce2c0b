// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/core/enum_names.h>

#include <array>
#include <string>
#include <utility>

namespace zoo
{
enum class Animal
{
    Cat,
    BrownBear
};

constexpr auto enum_names(Animal)
{
    return std::array<std::pair<Animal, std::string_view>, 2>{
        {{Animal::Cat, "cat"}, {Animal::BrownBear, "brown_bear"}}};
}
}  // namespace zoo

using zoo::Animal;

namespace
{
std::string parse_error(const std::string& text)
{
    try
    {
        (void)rtob::parse_enum<Animal>(text);
    }
    catch (const std::invalid_argument& e)
    {
        return e.what();
    }
    return {};
}
}  // namespace

TEST(EnumNames, NameAndValueAreInverse)
{
    for (const auto animal : {Animal::Cat, Animal::BrownBear})
        EXPECT_EQ(rtob::parse_enum<Animal>(rtob::name_of(animal)), animal);
}

TEST(EnumNames, AreListedInTheOrderOfTheTable)
{
    EXPECT_EQ(rtob::all_names<Animal>(), (std::vector<std::string>{"cat", "brown_bear"}));
}

TEST(EnumNames, RefusesAnUnknownName)
{
    EXPECT_EQ(
        parse_error("brown_baer"),
        "'brown_baer' is not one of: cat, brown_bear; did you mean 'brown_bear'?");
    EXPECT_EQ(parse_error("elephant"), "'elephant' is not one of: cat, brown_bear");
    EXPECT_NE(parse_error("Cat"), "");
    EXPECT_NE(parse_error(""), "");
}

TEST(EnumNames, RefusesANumberThatIsNoValue)
{
    EXPECT_THROW((void)rtob::name_of(static_cast<Animal>(17)), std::invalid_argument);
}
