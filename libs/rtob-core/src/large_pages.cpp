// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/large_pages.h>

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace rtob
{
void prefer_large_pages(const void* begin, std::size_t bytes)
{
#ifdef __linux__
    constexpr std::uintptr_t kLargePage = 2u << 20;
    constexpr std::size_t kWorthwhile = 8 * kLargePage;
    if (bytes < kWorthwhile) return;
    const auto address = reinterpret_cast<std::uintptr_t>(begin);
    const std::uintptr_t first = (address + kLargePage - 1) / kLargePage * kLargePage;
    const std::uintptr_t end = (address + bytes) / kLargePage * kLargePage;
    // A hint: nothing is lost where it is refused.
    (void)madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
#else
    (void)begin, (void)bytes;
#endif
}
}  // namespace rtob
