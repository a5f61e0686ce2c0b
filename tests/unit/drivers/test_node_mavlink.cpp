// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/drivers/mavlink_codec.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "program.h"

/// Our frames in the eyes of another implementation. Optional: `./dev mavlink` gets it and runs
/// this.
namespace rtob
{
namespace
{
using nlohmann::json;

/// Any values that the wire can hold.
struct Fill
{
    std::mt19937_64& random;

    template <class Value>
    void operator()(const char*, Value& value)
    {
        if constexpr (mavlink::detail::Array<Value>::value)
            for (auto& item : value) one(item);
        else
            one(value);
    }
    void extension() {}

 private:
    template <class Value>
    void one(Value& value)
    {
        if constexpr (std::is_floating_point_v<Value>)
            value =
                static_cast<Value>(std::ldexp(static_cast<double>(random() % 2000001) - 1e6, -9));
        else if constexpr (std::is_same_v<Value, char>)
            value = static_cast<char>('a' + random() % 26);
        else
            value = static_cast<Value>(random());
    }
};

struct Compare
{
    const json& fields;

    template <class Value>
    void operator()(const char* name, const Value& value) const
    {
        ASSERT_TRUE(fields.contains(name)) << name;
        const json& told = fields[name];
        if constexpr (std::is_same_v<Value, std::array<char, 50>>)
            EXPECT_EQ(std::string(value.begin(), value.end()), told.get<std::string>()) << name;
        else if constexpr (mavlink::detail::Array<Value>::value)
            for (std::size_t i = 0; i < value.size(); ++i) EXPECT_EQ(value[i], told.at(i)) << name;
        else if constexpr (sizeof(Value) == 8)
            EXPECT_EQ(std::to_string(value), told.get<std::string>()) << name;
        else
            EXPECT_EQ(value, told.get<Value>()) << name;
    }
    void extension() const {}
};

constexpr int kEach = 100;

template <class Visit>
void for_each_random_message(Visit&& visit)
{
    std::mt19937_64 random(17);
    for (int i = 0; i < kEach; ++i)
        mavlink::for_each_message(
            [&](const auto& kind)
            {
                auto message = kind;
                using Message = std::decay_t<decltype(message)>;
                Message::fields(message, Fill{random});
                visit(message);
            });
}

std::string modules_folder()
{
    const char* folder = std::getenv("RTOB_NODE_MODULES");
    return folder != nullptr ? folder : RTOB_NODE_FOLDER;
}

TEST(NodeMavlink, ReadsAndRepeatsOurFrames)
{
    if (test::run_program("/bin/sh", {"-c", "command -v node"}).exit_code != 0)
        GTEST_SKIP() << "there is no node; ./dev mavlink tells how to get it";
    if (!std::filesystem::exists(modules_folder() + "/node_modules/node-mavlink"))
        GTEST_SKIP() << "node-mavlink is not in " << modules_folder() << "; ./dev mavlink gets it";
    const test::TemporaryFolder folder;
    mavlink::Sender sender{7, 42, 250};  // the sequence wraps
    std::string sent;
    for_each_random_message(
        [&](const auto& message)
        {
            const Bytes frame = sender.encode(message);
            sent.append(frame.begin(), frame.end());
        });
    const auto result = test::run_program(
        "/usr/bin/env", {"node", RTOB_NODE_SCRIPT, modules_folder(), folder.write("sent", sent),
                         folder.file("fields"), folder.file("again")});
    ASSERT_EQ(0, result.exit_code) << result.err;

    std::istringstream lines(test::file_content(folder.file("fields")));
    std::size_t messages = 0;
    std::uint8_t sequence = 250;
    for_each_random_message(
        [&](const auto& message)
        {
            using Message = std::decay_t<decltype(message)>;
            std::string line;
            ASSERT_TRUE(std::getline(lines, line)) << "after " << messages;
            const json told = json::parse(line);
            EXPECT_EQ(Message::name, told["name"]);
            EXPECT_EQ(sequence++, told["seq"]);
            EXPECT_EQ(7, told["sysid"]);
            EXPECT_EQ(42, told["compid"]);
            Message::fields(message, Compare{told["fields"]});
            ++messages;
        });
    EXPECT_EQ(sent, test::file_content(folder.file("again"))) << "byte for byte";
    std::cout << messages << " frames read and repeated by node-mavlink\n";
}
}  // namespace
}  // namespace rtob
