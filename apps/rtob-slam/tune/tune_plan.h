// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "run/run_options.h"

namespace rtob
{
/// What one option may be, all else as it is.
struct Sweep
{
    std::string section, key;
    std::vector<std::string> values;
    std::string density;  ///< the option means something with this density only; empty: with all

    [[nodiscard]] std::string name() const { return section + "." + key; }
};

/// The options whose choice the paper explains (sec. 2.3): drawn points, iterations,
/// correspondence distance, the density and its constants.
[[nodiscard]] std::vector<Sweep> tuning_sweeps();

/// The configuration with this value of the sweep's option. Where the final pair distance would
/// exceed the first, it is lowered to it.
[[nodiscard]] RunConfig config_with(
    const RunConfig& config, const Sweep& sweep, const std::string& value);

/// The value that the configuration has, as it is typed.
[[nodiscard]] std::string value_in(const RunConfig& config, const Sweep& sweep);
}  // namespace rtob
