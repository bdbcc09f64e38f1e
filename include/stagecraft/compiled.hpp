// SPDX-License-Identifier: BSL-1.0
#pragma once

/// Before what an X-inl.hpp defines: `inline` where every program compiles it (X.hpp includes X-inl.hpp then), nothing
/// where STAGECRAFT_COMPILED says that a library holds it, which is compiled with the same macro.
#ifdef STAGECRAFT_COMPILED
#define STAGECRAFT_INLINE
#else
#define STAGECRAFT_INLINE inline
#endif
