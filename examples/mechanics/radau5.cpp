// SPDX-License-Identifier: BSL-1.0
// RADAU5 on the same formulations, where it is installed.
#include "../work_precision/radau5.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

#include "run.hpp"

namespace mechanics {

namespace {

// What the callbacks, which take no context, refer to.
struct context {
    const body* b;
    const formulation* f;
    outcome* o;
    double energy;
    VectorXd in, out;
    Eigen::MatrixXd J;
};
context current;

void right_hand_side(int* n, double* t, double* y, double* f, double*, int*) {
    current.in = Eigen::Map<VectorXd>(y, *n);
    current.f->problem(*t, current.in, current.out);
    Eigen::Map<VectorXd>(f, *n) = current.out;
}
void jacobian(int* n, double* t, double* y, int*, int*, double* dfy, int* rows, double*, int*) {
    const int skipped = current.f->positions;
    current.in = Eigen::Map<VectorXd>(y, *n);
    current.f->problem.jacobian(*t, current.in, current.J);
    Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>> out(dfy, *rows, *n, Eigen::OuterStride<>(*rows));
    out.topRows(*n - skipped) = current.J.bottomRows(*n - skipped);
}
void mass(int* n, double* am, int* rows, double*, int*) {
    Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>> out(am, *rows, *n, Eigen::OuterStride<>(*rows));
    out.topRows(*n) = current.f->problem.M.bottomRightCorner(*n, *n);
}
void accepted(int*, double*, double* t, double* y, double*, int*, int* n, double*, int*, int*) {
    auto now = current.b->look(*t, Eigen::Map<VectorXd>(y, *n));
    now[2] = std::abs(now[2] - current.energy);
    for (std::size_t k = 0; k < now.size(); ++k) current.o->drift[k] = std::max(current.o->drift[k], now[k]);
}

int call(const formulation& f, VectorXd& y, double t1, double tolerance, bool look, std::vector<int>& iwork) {
    int n = static_cast<int>(y.size()), itol = 0, ijac = 1, iout = look, ipar = 0, idid = 0, imas = 1;
    int ml = n - f.positions, mu = ml, mlmas = ml, mumas = ml;
    if (f.positions == 0) ml = mu = mlmas = mumas = n;
    double t = 0, h = 0, rtol = tolerance, atol = tolerance, rpar = 0;
    int lwork = n * (n + n + 3 * n + 12) + 20, liwork = 3 * n + 20;
    std::vector<double> work(static_cast<std::size_t>(lwork), 0.0);
    iwork.assign(static_cast<std::size_t>(liwork), 0);
    iwork[1] = 10'000'000;  // steps allowed
    for (const int i : f.problem.flags) ++iwork[static_cast<std::size_t>(3 + i)];
    iwork[8] = iwork[9] = f.positions;
    peers::radau5_symbol()(&n, right_hand_side, &t, y.data(), &t1, &h, &rtol, &atol, &itol,
                           reinterpret_cast<void (*)()>(jacobian), &ijac, &ml, &mu, mass, &imas, &mlmas,
                           &mumas, accepted, &iout, work.data(), &lwork, iwork.data(), &liwork, &rpar, &ipar,
                           &idid);
    return idid;
}

}  // namespace

bool radau5_available() { return peers::radau5_available(); }

outcome run_radau5(const body& b, const formulation& f, double tolerance, int repeats) {
    outcome o;
    const Eigen::Index n = f.y0.size();
    current = {&b, &f, &o, b.look(0, f.y0)[2], VectorXd(n), VectorXd(n), Eigen::MatrixXd(n, n)};
    std::vector<int> counts;
    o.microseconds = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= repeats; ++k) {
        VectorXd y = f.y0;
        const std::clock_t start = std::clock();
        const int idid = call(f, y, b.end, tolerance, k == 0, counts);
        const double time = 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        if (k > 0) o.microseconds = std::min(o.microseconds, time);
        o.ok = idid == 1;
        o.status = "idid " + std::to_string(idid);
        o.y = y;
        o.steps = counts[15], o.f = counts[13];
    }
    return o;
}

}  // namespace mechanics
