// SPDX-License-Identifier: BSL-1.0
// headers.hpp is precompiled with this file.
