// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <stdexcept>
#include <string>

namespace rtob::test
{
/// What the call threw; empty when it threw nothing. Other kinds of errors pass through.
template <class Error = std::runtime_error, class Call>
std::string error_message(Call&& call)
{
    try
    {
        call();
    }
    catch (const Error& e)
    {
        return e.what();
    }
    return {};
}
}  // namespace rtob::test
