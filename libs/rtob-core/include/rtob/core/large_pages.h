// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>

namespace rtob
{
/// Asks for large memory pages for a big array that is read at random places, before it is first
/// written: with 4 KiB pages the processor looks up where a page lies more often than it reads.
/// Small arrays are left alone, as are systems without such pages.
void prefer_large_pages(const void* begin, std::size_t bytes);
}  // namespace rtob
