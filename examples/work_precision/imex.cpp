// SPDX-License-Identifier: BSL-1.0
// Implicit-explicit methods: ours beside ARKODE with the same tables (Kennedy and Carpenter 2003), the same linear algebra and the
// same Jacobian, which both form once where the implicit part is linear.
#include <stagecraft/additive.hpp>
#include <stagecraft/coefficients/additive.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/linear/banded_blocks.hpp>
#include <stagecraft/linear/klu.hpp>
#include <stagecraft/linear/sparse_blocks.hpp>

#include "compete.hpp"
#include "split_problems.hpp"
#ifdef HAVE_SUNDIALS
#include "sundials_imex.hpp"
#endif

namespace {

template <class P>
constexpr bool is_banded = requires {
    P::lower;
};

/// The implicit part as our integrator takes it, with its linear algebra.
template <class P>
struct fast_part {
    using state = typename P::state;
    P p;
    void operator()(double t, const state& y, state& f) const { p.fast(t, y, f); }
};
template <class P>
struct dense_part : fast_part<P> {
    void jacobian(double, const typename P::state& y, Eigen::Matrix2d& J) const { this->p.jacobian(y, J); }
};
template <class P>
struct banded_part : fast_part<P> {
    stagecraft::bandwidth bandwidth() const { return {P::lower, P::upper}; }
    bool constant_jacobian() const { return true; }
};
template <class P>
struct sparse_part : fast_part<P> {
    using linear_solver = stagecraft::klu_blocks;
    Eigen::SparseMatrix<double> sparsity() const { return this->p.matrix(); }
    bool constant_jacobian() const { return true; }
};
template <class P>
auto implicit_part(const P& p) {
    if constexpr (requires { P::klu; })
        return sparse_part<P>{{p}};
    else if constexpr (is_banded<P>)
        return banded_part<P>{{p}};
    else
        return dense_part<P>{{p}};
}

/// Both parts as one function, for the reference; the two species of a cell are coupled.
template <class P>
struct whole {
    using state = typename P::state;
    P p;
    void operator()(double t, const state& y, state& f) const {
        state slow(y.size());
        p.slow(t, y, slow), p.fast(t, y, f);
        f += slow;
    }
};
template <class P>
struct sparse_whole : whole<P> {
    Eigen::SparseMatrix<double> sparsity() const {
        Eigen::SparseMatrix<double> pattern = this->p.matrix();
        for (int i = 0; i < pattern.rows(); i += 2)
            for (int left = 0; left <= 4 && left <= i; left += 2)  // differences in space reach two cells
                pattern.coeffRef(i, i - left) = pattern.coeffRef(i + 1, i - left) = 1;
        for (int i = 0; i < pattern.rows(); i += 2) {
            pattern.coeffRef(i, i + 1) = 1;
            if (i > 0) pattern.coeffRef(i - 2, i) = 1;
        }
        return pattern;
    }
};
template <class P>
auto in_one(const P& p) {
    if constexpr (requires { p.matrix(); })
        return sparse_whole<P>{{p}};
    else
        return whole<P>{p};
}

template <class Method, class P>
outcome run_split(const Method& method, const P& p, double tolerance) {
    using state = typename P::state;
    const auto slow = [&p](double t, const state& y, state& f) { p.slow(t, y, f); };
    return outcome_of(stagecraft::integrate(method, stagecraft::split(slow, implicit_part(p)), p.initial(),
                                            0.0, P::t1,
                                            {.rtol = tolerance, .atol = tolerance, .max_steps = 1000000}));
}

template <class P>
void compete_on(const P& p, const settings& set, std::vector<curve>& curves) {
    if (!wanted(set.problems, P::name)) return;
    const auto exact = stagecraft::integrate(stagecraft::radau_iia<5>(), in_one(p), p.initial(), 0.0, P::t1,
                                             {.rtol = 1e-12, .atol = 1e-12});
    const auto error = [&](const Eigen::VectorXd& y) { return scaled_error(y, exact.y, 1); };
    std::vector<entrant> all = {
        {"stagecraft ark3", [&](double tol, double) { return run_split(stagecraft::ark3(), p, tol); }},
        {"stagecraft ark4", [&](double tol, double) { return run_split(stagecraft::ark4(), p, tol); }},
        {"stagecraft ark5", [&](double tol, double) { return run_split(stagecraft::ark5(), p, tol); }}};
#ifdef HAVE_SUNDIALS
    for (const int order : {3, 4, 5})
        all.push_back({"arkode ark" + std::to_string(order),
                       [&p, order](double tol, double) { return peers::sundials::imex(p, order, tol); }});
#endif
    const curve kind{P::name, "", static_cast<int>(exact.y.size()), is_banded<P>, false, {}};
    measure_all(kind, all, P::t1, 1e-9, error, set, curves);
}

}  // namespace

void compete_on_split_problems(const settings& set, std::vector<curve>& curves) {
    compete_on(split_problems::kaps{}, set, curves);
    compete_on(split_problems::van_der_pol{}, set, curves);
    compete_on(split_problems::brusselator_1d{}, set, curves);
    compete_on(split_problems::advection_reaction{}, set, curves);
    compete_on(split_problems::brusselator_square{}, set, curves);
    compete_on(split_problems::gray_scott{}, set, curves);
}
