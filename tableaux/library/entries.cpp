// SPDX-License-Identifier: BSL-1.0
// The numbers of a tableau file.
#include "stagecraft/tableaux/entry-inl.hpp"
#include "stagecraft/tableaux/partitioned_file-inl.hpp"
#include "stagecraft/tableaux/polynomial_text-inl.hpp"
#include "stagecraft/tableaux/reading-inl.hpp"
#include "stagecraft/tableaux/real_root-inl.hpp"
#include "stagecraft/tableaux/stage_form-inl.hpp"
#include "stagecraft/tableaux/tableau_file-inl.hpp"
