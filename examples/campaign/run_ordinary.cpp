// SPDX-License-Identifier: BSL-1.0
#include "run.hpp"

campaign::outcome campaign::run_ordinary(int stages, const problem& p, double tol) {
    return run_with<ordinary_view>(stages, p, tol);
}
