// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

namespace rtob::test
{
/// A path that no other test or process uses: <temporary folder>/<process>_<test><ending>.
inline std::string temporary_path(const std::string& ending)
{
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(test->test_suite_name()) + "_" + test->name() + ending;
    // Tests with parameters have names with slashes.
    std::replace(name.begin(), name.end(), '/', '_');
    return testing::TempDir() + std::to_string(getpid()) + "_" + name;
}

/// A file of the running test, removed with this object. One ending, one file.
class TemporaryFile
{
 public:
    explicit TemporaryFile(const std::string& ending) : path_(temporary_path(ending)) {}
    TemporaryFile(const std::string& ending, const std::string& bytes) : TemporaryFile(ending)
    {
        std::ofstream(path_, std::ios::binary) << bytes;
    }
    ~TemporaryFile() { std::filesystem::remove(path_); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    const std::string& path() const { return path_; }

 private:
    std::string path_;
};
}  // namespace rtob::test
