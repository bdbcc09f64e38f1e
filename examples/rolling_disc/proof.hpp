// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

namespace rolling_disc {

/// The three-stage Radau IIA tableau in exact surds, and what is proved of it, as text.
std::string exact_tableau_text();
std::string certificate_text();

}  // namespace rolling_disc
