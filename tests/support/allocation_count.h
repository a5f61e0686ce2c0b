// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Replaces operator new, to count allocations: include it in one file of a program only.
#include <cstdlib>
#include <new>

#include "sanitized.h"

namespace rtob::test
{
inline thread_local bool counting = false;
inline thread_local int allocations = 0;

/// Counts this thread's allocations while it lives.
class AllocationCount
{
 public:
    AllocationCount() { allocations = 0, counting = true; }
    ~AllocationCount() { counting = false; }
    AllocationCount(const AllocationCount&) = delete;
    AllocationCount& operator=(const AllocationCount&) = delete;
    [[nodiscard]] int soFar() const { return allocations; }
};
}  // namespace rtob::test

#if !RTOB_SANITIZED  // the sanitizers bring their own
void* operator new(std::size_t size)
{
    if (rtob::test::counting) ++rtob::test::allocations;
    if (void* memory = std::malloc(size != 0 ? size : 1)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept
{
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}
#endif
