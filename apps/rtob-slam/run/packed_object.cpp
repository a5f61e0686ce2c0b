// SPDX-License-Identifier: BSD-3-Clause
#include "run/packed_object.h"

#include <rtob/io/object_file.h>

namespace rtob
{
void write_packed_object(const std::string& file, const mrpt::serialization::CSerializable& object)
{
    ObjectFile out(file);
    out.write(object);
    out.commit();
}
}  // namespace rtob
