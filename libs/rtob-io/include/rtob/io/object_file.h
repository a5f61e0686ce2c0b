// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/serialization/CSerializable.h>
#include <rtob/io/atomic_file.h>

#include <memory>
#include <string>

namespace rtob
{
/// MRPT objects one after the other in a gzip file: what MRPT reads as a rawlog, a map, a
/// simplemap. Appears whole or not at all; written as the objects come. Throws std::runtime_error.
class ObjectFile
{
 public:
    explicit ObjectFile(const std::string& file);
    ~ObjectFile();

    void write(const mrpt::serialization::CSerializable& object);
    void commit();

 private:
    class Stream;

    AtomicFile out_;
    std::unique_ptr<Stream> stream_;
};
}  // namespace rtob
