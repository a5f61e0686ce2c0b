// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include "temporary_file.h"

namespace rtob::test
{
inline std::string file_content(const std::string& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// A folder of the running test, removed with this object and all it holds, unless the test failed:
/// then it is kept, to be looked at. One ending, one folder.
class TemporaryFolder
{
 public:
    explicit TemporaryFolder(const std::string& ending = "_folder") : path_(temporary_path(ending))
    {
        std::filesystem::create_directories(path_);
    }
    ~TemporaryFolder()
    {
        if (testing::Test::HasFailure())
            std::cout << "kept: " << path_ << std::endl;
        else
            std::filesystem::remove_all(path_);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] std::string file(const std::string& name) const { return path_ + "/" + name; }
    /// @return its path
    std::string write(const std::string& name, const std::string& bytes) const
    {
        std::ofstream(file(name), std::ios::binary) << bytes;
        return file(name);
    }

 private:
    std::string path_;
};
}  // namespace rtob::test
