// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Marks a hot loop that is compiled once for every x86-64 and once for AVX2, chosen when the
/// program starts. Sums keep a fixed order and a*b+c is never fused (-ffp-contract=off), so both
/// give the same bits.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define RTOB_SIMD_CLONES __attribute__((target_clones("avx2", "default"), optimize("O3")))
#else
#define RTOB_SIMD_CLONES
#endif

/// A part of such a loop: compiled into each of its kinds.
#define RTOB_INLINE inline __attribute__((always_inline))
