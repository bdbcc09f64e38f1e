// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

// What the library stagecraft::bvp holds compiled, in double: solve_bvp by methods of 3 and 5 stages for n = 2, 3, 4, 6 and n
// known at run time, with one unknown parameter by 5 stages; periodic orbits and paths by 5 stages for n = 2 and 3. A program
// compiled with STAGECRAFT_BVP_COMPILED, as who links the library is, takes these from there; whatever else it asks for it
// compiles for itself. `keyword` is `extern template` in the headers and `template` in the files of include/library/bvp.
//
// Where vectors of Eigen's are aligned otherwise (-mavx), nothing is taken: they are other types to the processor.

#if defined STAGECRAFT_BVP_COMPILED && EIGEN_MAX_STATIC_ALIGN_BYTES == 16
#define STAGECRAFT_BVP_TAKEN
#endif

#define STAGECRAFT_BVP_SOLVE(keyword, S, N, P)                                        \
    keyword bvp_result<Eigen::Matrix<double, N, 1>, Eigen::Matrix<double, P, 1>>      \
    solve_functions<S, Eigen::Matrix<double, N, 1>, Eigen::Matrix<double, P, 1>>(     \
        const tableau<double, S>&, two_point_functions<double, N, P>&,                \
        const guess_view<Eigen::Matrix<double, N, 1>>&, const double&, const double&, \
        const Eigen::Matrix<double, P, 1>&, const bvp_options<double>&, int);

#define STAGECRAFT_BVP_SIZE(keyword, N)    \
    STAGECRAFT_BVP_SOLVE(keyword, 3, N, 0) \
    STAGECRAFT_BVP_SOLVE(keyword, 5, N, 0) \
    STAGECRAFT_BVP_SOLVE(keyword, 5, N, 1)

#define STAGECRAFT_BVP_ORBIT(keyword, S, N)                                                 \
    keyword bvp_result<Eigen::Matrix<double, N, 1>, Eigen::Matrix<double, 1, 1>>            \
    solve_orbit<S, Eigen::Matrix<double, N, 1>>(                                            \
        const tableau<double, S>&, two_point_functions<double, N, 1>&,                      \
        const guess_view<Eigen::Matrix<double, N, 1>>&, const Eigen::Matrix<double, 1, 1>&, \
        const bvp_options<double>&, std::vector<floquet_multiplier<double>>*);

#define STAGECRAFT_BVP_PATH(keyword, S, N, P)                                                               \
    keyword std::vector<path_state<Eigen::Matrix<double, N, 1>, Eigen::Matrix<double, P, 1>>>               \
    follow_path<S, Eigen::Matrix<double, N, 1>, Eigen::Matrix<double, P, 1>>(                               \
        const tableau<double, S>&, path_problem<Eigen::Matrix<double, N, 1>, Eigen::Matrix<double, P, 1>>&, \
        const double&, const double&, const guess_view<Eigen::Matrix<double, N, 1>>&,                       \
        const Eigen::Matrix<double, P, 1>&, const continuation_options<double>&);

#define STAGECRAFT_BVP_PATHS(keyword, N)  \
    STAGECRAFT_BVP_PATH(keyword, 5, N, 1) \
    STAGECRAFT_BVP_PATH(keyword, 5, N, 2)
