// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/eval/comparison.h>

#include <string>
#include <vector>

namespace rtob
{
/// What a log's trajectories are judged by.
class Truth
{
 public:
    /// None.
    Truth() = default;
    /// Throws std::runtime_error naming the file when it holds neither relations nor poses.
    explicit Truth(const std::string& file);

    [[nodiscard]] TruthKind kind() const { return kind_; }

    /// Throws std::runtime_error naming the file when it says nothing about the times of the scans.
    void checkTimes(const std::vector<StampedPose2>& scans) const;

    /// None without a truth. Throws std::runtime_error naming the file.
    [[nodiscard]] std::optional<Accuracy> judge(const std::vector<StampedPose2>& trajectory) const;

 private:
    std::string file_;
    TruthKind kind_ = TruthKind::None;
    std::vector<Relation> relations_;
    std::vector<StampedPose2> poses_;
};
}  // namespace rtob
