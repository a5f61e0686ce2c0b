// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Whether a sanitizer counts, keeps and replaces memory of its own.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define RTOB_SANITIZED 1
#else
#define RTOB_SANITIZED 0
#endif
