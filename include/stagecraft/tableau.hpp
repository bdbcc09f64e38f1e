// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

// -ffast-math, or the parts of it that let NaN pass or reorder sums. clang has no macro for the latter alone.
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#define STAGECRAFT_UNSAFE_MATH
#elif defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#define STAGECRAFT_UNSAFE_MATH
#endif
#ifdef STAGECRAFT_UNSAFE_MATH
#error "stagecraft: -ffast-math and its parts break stiff error control and every proof by enclosure"
#endif

namespace stagecraft {

/// Number of stages known only at run time.
inline constexpr int dynamic = Eigen::Dynamic;

/// What a certificate has proved of a tableau, as plain data a stepper can carry (no theory attached).
/// `order` and `stage_order` are the classical order p and the stage order q (largest q with B(q) and C(q)).
struct facts {
    int order = 0;
    int stage_order = 0;
    bool a_stable = false;
    bool algebraically_stable = false;
    bool symplectic = false;
    bool symmetric = false;
    double r_infinity = 0;  ///< R(inf), NaN where the stability function has no finite limit

    constexpr bool l_stable() const { return a_stable && r_infinity == 0; }
    friend bool operator==(const facts&, const facts&) = default;
};

/// A Runge-Kutta tableau (Butcher array) over any scalar: c | A over b. A regular value.
/// `b_embedded` has size 0 where the method brings no embedded weights.
template <class Scalar, int Stages = dynamic>
struct tableau {
    using scalar = Scalar;
    using matrix = Eigen::Matrix<Scalar, Stages, Stages>;
    using vector = Eigen::Matrix<Scalar, Stages, 1>;

    matrix A;
    vector b;
    vector c;
    Eigen::Matrix<Scalar, Eigen::Dynamic, 1> b_embedded;
    stagecraft::facts facts;

    int stages() const { return static_cast<int>(b.size()); }
    /// The last row of A equals b, hence y1 = Y_s.
    bool stiffly_accurate() const {
        const int s = stages();
        for (int j = 0; j < s; ++j)
            if (!(A(s - 1, j) == b[j])) return false;
        return s > 0;
    }
};

/// A tableau whose A is regular, with A^-1 brought to real block-diagonal form (Hairer-Wanner II.IV.8):
/// T^-1 A^-1 T = diag(gamma_1, ..., [alpha_1 beta_1; -beta_1 alpha_1], ...), the eigenvalues of A^-1 being
/// the real gamma_k and the pairs alpha_k +- i beta_k, beta_k > 0, pairs sorted by increasing beta.
/// Column k of T belongs to gamma_k; the two columns of a pair are the real and the imaginary part of the
/// eigenvector v of alpha + i beta, scaled so that the last component of every eigenvector is 1
/// (so the last row of T reads 1 for each real eigenvalue and 1 0 for each pair).
template <class Scalar, int Stages = dynamic>
struct transformed_tableau : tableau<Scalar, Stages> {
    using typename tableau<Scalar, Stages>::matrix;
    matrix A_inverse;
    matrix T;
    matrix T_inverse;
    Eigen::Matrix<Scalar, Eigen::Dynamic, 1> gamma;  ///< real eigenvalues of A^-1, increasing
    Eigen::Matrix<Scalar, Eigen::Dynamic, 1> alpha;  ///< real parts of the complex pairs
    Eigen::Matrix<Scalar, Eigen::Dynamic, 1> beta;   ///< their positive imaginary parts, increasing
};

}  // namespace stagecraft
