// SPDX-License-Identifier: BSL-1.0
// Stability.
#include "stagecraft/theory/stability/embedded_collocation-inl.hpp"
#include "stagecraft/theory/stability/enclosed_signs-inl.hpp"
#include "stagecraft/theory/stability/nodal_stability-inl.hpp"
#include "stagecraft/theory/stability/spectrum-inl.hpp"
#include "stagecraft/theory/stability/symplectic_pair-inl.hpp"
