// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <stdexcept>

namespace rtob
{
/// The command line asks for something that does not exist: exit code 2.
class UsageError : public std::runtime_error
{
 public:
    using std::runtime_error::runtime_error;
};
}  // namespace rtob
