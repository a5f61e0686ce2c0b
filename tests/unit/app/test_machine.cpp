// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "compare/machine.h"

namespace rtob::test
{
namespace
{
TEST(Machine, RemarksOnABusyComputerOnly)
{
    EXPECT_EQ(remark_on({0.0, 2}), "");
    EXPECT_EQ(remark_on({1.9, 2}), "");
    EXPECT_THAT(remark_on({10.44, 2}), testing::HasSubstr("(10.4 programs on 2 processors)"));
}

TEST(Machine, FactsNameTheLoad)
{
    bool has_load = false;
    for (const auto& [name, value] : machine_facts())
    {
        EXPECT_NE(value, "") << name;
        has_load = has_load || name == "load at the start";
    }
    EXPECT_TRUE(has_load);
}
}  // namespace
}  // namespace rtob::test
