// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/sim/world.h>

#include "yaml_fields.h"

namespace rtob::sim
{
/// One entry of `objects:` of a world file.
[[nodiscard]] Object read_object(YamlFields fields);
/// One entry of `people:`.
[[nodiscard]] Object read_person(YamlFields fields);
}  // namespace rtob::sim
