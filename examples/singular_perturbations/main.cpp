// SPDX-License-Identifier: BSL-1.0
// Error against run time for eps = 1e-2 ... 1e-14, and the order that is left of a method with equal steps, as CSV.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/lobatto_iiic.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/radau_iia_variable.hpp>
#include <work_precision/measure.hpp>
#include <work_precision/ours.hpp>
#include <work_precision/radau5.hpp>

#include "problems.hpp"

namespace {

namespace sc = stagecraft;
using namespace perturbed_problems;

const std::vector<double> every_eps{1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14};

/// The end of the run to 1e-13 by seven stages; what is known better is left to a member `periodic`.
template <class Problem>
Eigen::VectorXd reference(const Problem& problem) {
    if constexpr (requires { problem.periodic(0.0); }) return problem.periodic(Problem::t1);
    return run_ours(sc::radau_iia<7>(), problem, 1e-13, Problem::t1).y;
}

/// Both codes to 1e-12 end within 1e-9 of the reference, RADAU5 where it gets so far: no measured error is that of the
/// reference. False, and a line that says so, otherwise.
template <class Problem>
bool trusted(const Problem& problem, const Eigen::VectorXd& end) {
    double off = scaled_error(run_ours(sc::radau_iia<5>(), problem, 1e-12, Problem::t1).y, end, 1);
    if (peers::radau5_available()) {
        const outcome peer = peers::radau(peers::radau5_symbol(), problem, 1e-12, Problem::t1);
        if (peer.ok) off = std::max(off, scaled_error(peer.y, end, 1));
        if (!peer.ok)
            std::fprintf(stderr, "%s, eps %g: radau5 to 1e-12 stopped early\n", Problem::name, problem.eps);
    }
    if (!(off < 1e-9))
        std::fprintf(stderr, "%s, eps %g: references differ by %g\n", Problem::name, problem.eps, off);
    return off < 1e-9;
}

template <class Problem>
bool print_costs() {
    bool good = true;
    for (const double eps : every_eps) {
        const Problem problem{eps};
        const Eigen::VectorXd end = reference(problem);
        good = trusted(problem, end) && good;
        std::vector<entrant> all{{"stagecraft", [&](double tol, double t1) {
                                      return run_ours(sc::radau_iia_variable(), problem, tol, t1);
                                  }}};
        if (peers::radau5_available())
            all.push_back({"radau5", [&](double tol, double t1) {
                               return peers::radau(peers::radau5_symbol(), problem, tol, t1);
                           }});
        for (int digits = 3; digits <= 11; ++digits) {
            const auto error = [&](const Eigen::VectorXd& y) { return scaled_error(y, end, 1); };
            const std::vector<point> points = measure(all, std::pow(10.0, -digits), Problem::t1, 5, 1, error);
            for (std::size_t i = 0; i < all.size(); ++i) {
                const point& p = points[i];
                std::printf("%s,%s,%g,%g,%.3e,%.4g,%ld,%ld,%ld\n", Problem::name, all[i].solver.c_str(), eps,
                            p.tolerance, p.error, p.minimum_us, p.counts.steps, p.counts.f,
                            p.counts.factorisations);
                good = good && (p.counts.ok || i > 0);
            }
        }
    }
    return good;
}

/// Errors of y and z at the end of n equal steps of the enzyme's smooth solution, over t = 1 ... 2.
template <class Method>
void print_orders(const char* name, const Method& method) {
    for (const double eps : every_eps) {
        const enzyme problem{eps};
        const sc::options<double> fine{.rtol = 1e-14, .atol = 1e-15};
        const auto start = sc::integrate(sc::radau_iia<7>(), problem, enzyme::initial(), 0, 1, fine);
        const auto end = sc::integrate(sc::radau_iia<7>(), problem, start.y, 1, 2, fine);
        for (int n = 1; n <= 64; n *= 2) {
            const auto r = sc::integrate(method, problem, start.y, 1, 2,
                                         {.rtol = 1e-14, .atol = 1e-15, .fixed_step = 1.0 / n});
            std::printf("%s,%g,%g,%.3e,%.3e\n", name, eps, 1.0 / n, std::abs(r.y[0] - end.y[0]),
                        std::abs(r.y[1] - end.y[1]));
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Singular perturbation problems: error against run time for eps = 1e-2 ... 1e-14, as CSV"};
    bool orders = false;
    app.add_flag("--orders", orders,
                 "instead of it errors over the step size, which show the orders that are left");
    CLI11_PARSE(app, argc, argv);
    if (orders) {
        std::puts("method,eps,h,error of y,error of z");
        print_orders("Radau IIA s = 3", sc::radau_iia<3>());
        print_orders("Lobatto IIIC s = 3", sc::lobatto_iiic<3>());
        print_orders("Gauss s = 3", sc::gauss<3>());
        return 0;
    }
    std::puts("problem,solver,eps,tolerance,error,microseconds,steps,f,factorisations");
    bool good = print_costs<van_der_pol>();
    good = print_costs<enzyme>() && good;
    good = print_costs<ladder>() && good;
    return good ? 0 : 1;
}
