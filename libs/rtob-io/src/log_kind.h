// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string_view>

namespace rtob
{
enum class LogKind
{
    Rawlog,
    Text,
    Unknown
};

/// What the first (unpacked) bytes of a file say; at least one.
[[nodiscard]] LogKind log_kind_of(std::string_view beginning);
}  // namespace rtob
