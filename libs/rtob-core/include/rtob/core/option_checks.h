// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sstream>
#include <stdexcept>
#include <string>

namespace rtob
{
/// @throws std::invalid_argument naming key, value and what is allowed, unless `ok`.
template <class Value>
void require(bool ok, const char* key, const Value& value, const char* allowed)
{
    if (ok) return;
    std::ostringstream message;
    message << key << " = " << value << " is out of range: must be " << allowed;
    throw std::invalid_argument(message.str());
}
}  // namespace rtob
