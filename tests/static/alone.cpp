// SPDX-License-Identifier: BSL-1.0
// Nothing of its own: tests/static/run compiles it once with every header included.
