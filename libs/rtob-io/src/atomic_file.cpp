// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/io/atomic_file.h>

#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <system_error>

namespace rtob
{
namespace
{
[[noreturn]] void fail(const std::string& file, int error_code)
{
    throw std::runtime_error(
        file + ": cannot be written: " + std::generic_category().message(error_code) +
        ". Check the folder, its permissions and the free space.");
}
}  // namespace

AtomicFile::AtomicFile(std::string file)
    : file_(std::move(file)), part_file_(file_ + ".part"), stream_(part_file_, std::ios::binary)
{
    if (!stream_) fail(file_, errno);
}

AtomicFile::~AtomicFile()
{
    if (part_file_.empty()) return;
    stream_.close();
    std::remove(part_file_.c_str());
}

void AtomicFile::check() const
{
    if (!stream_) fail(file_, errno);
}

void AtomicFile::commit()
{
    stream_.close();
    check();
    if (std::rename(part_file_.c_str(), file_.c_str()) != 0) fail(file_, errno);
    part_file_.clear();
}

void write_text(const std::string& file, const std::string& text)
{
    AtomicFile out(file);
    out.stream() << text;
    out.commit();
}
}  // namespace rtob
