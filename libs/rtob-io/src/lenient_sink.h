// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <boost/iostreams/concepts.hpp>
#include <ostream>

namespace rtob
{
/// The end of a packing chain. Boost's packers, told that a byte did not get through, ask again for
/// ever when they are closed: on a full disk the rest is dropped here, and whoever owns `out` looks
/// at its state.
class LenientSink : public boost::iostreams::sink
{
 public:
    explicit LenientSink(std::ostream& out) : out_(&out) {}

    std::streamsize write(const char* bytes, std::streamsize count)
    {
        if (*out_) out_->write(bytes, count);
        return count;
    }

 private:
    std::ostream* out_;
};
}  // namespace rtob
