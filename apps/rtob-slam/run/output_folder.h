// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

namespace rtob
{
/// out/<name of the log without its endings>
[[nodiscard]] std::filesystem::path default_output_folder(const std::string& log);

/// The folder that a run writes into. Nothing is touched before create().
class OutputFolder
{
 public:
    /// Throws std::runtime_error when the path is no folder, or holds something and may not be
    /// overwritten.
    OutputFolder(std::filesystem::path folder, bool may_overwrite);

    /// Makes the folder and removes the results of an earlier run from it, other files stay.
    void create() const;

    [[nodiscard]] std::string file(const std::string& name) const { return folder_ / name; }
    [[nodiscard]] std::string path() const { return folder_; }

 private:
    std::filesystem::path folder_;
};
}  // namespace rtob
