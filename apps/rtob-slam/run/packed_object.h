// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/serialization/CSerializable.h>

#include <string>

namespace rtob
{
/// Writes an MRPT object packed by gzip, as CFileGZInputStream reads it. The same object gives the
/// same bytes; the file appears whole or not at all. Throws std::runtime_error.
void write_packed_object(const std::string& file, const mrpt::serialization::CSerializable& object);
}  // namespace rtob
