// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/io/log_reader.h>

namespace rtob
{
LogError::LogError(
    const std::string& file, const std::string& place, const std::string& problem,
    const std::string& fix)
    : std::runtime_error(
          file + (place.empty() ? "" : ", " + place) + ": " + problem + ". " + fix + "."),
      file_(file),
      place_(place)
{
}
}  // namespace rtob
