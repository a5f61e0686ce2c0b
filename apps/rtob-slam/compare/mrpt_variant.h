// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/slam/CMetricMapBuilderICP.h>

#include <string>

#include "compare/variant.h"

namespace rtob
{
/// What MRPT's icp-slam runs, set up by one of its .ini files.
class MrptVariant : public Variant
{
 public:
    /// Throws std::runtime_error naming the file when it cannot be read or asks for no map.
    explicit MrptVariant(const std::string& config_file);

    Pose2 process(const ScanStep& step) override;
    [[nodiscard]] VariantMap map() const override;

 private:
    [[nodiscard]] mrpt::Clock::time_point stampFor(double time_s);

    mrpt::slam::CMetricMapBuilderICP builder_;
    double last_time_s_ = -1;
};
}  // namespace rtob
