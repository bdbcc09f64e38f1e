// SPDX-License-Identifier: BSL-1.0
// RADAU5 on the same problems, where it is installed.
#include "../work_precision/radau5.hpp"

#include "problem.hpp"

namespace campaign {

namespace {

// What the callbacks, which take no context, refer to.
struct context {
    const problem* p;
    outcome* o;
    double tol;
};
thread_local context current;

void right_hand_side(int* n, double* t, double* y, double* f, double*, int*) {
    VectorXd out(*n);
    current.p->f(*t, Eigen::Map<VectorXd>(y, *n), out);
    Eigen::Map<VectorXd>(f, *n) = out;
}
void jacobian(int* n, double* t, double* y, int*, int*, double* dfy, int* rows, double*, int*) {
    MatrixXd J = MatrixXd::Zero(*n, *n);
    current.p->jacobian(*t, Eigen::Map<VectorXd>(y, *n), J);
    Eigen::Map<MatrixXd, 0, Eigen::OuterStride<>>(dfy, *n, *n, Eigen::OuterStride<>(*rows)) = J;
}
void mass(int* n, double* am, int* rows, double*, int*) {
    for (int i = 0; i < *n; ++i) am[i * *rows] = i < current.p->differential ? 1 : 0;
}
void accepted(int* number, double* before, double* t, double* y, double*, int*, int* n, double*, int*, int*) {
    if (*number == 1) return;  // the start
    const problem& p = *current.p;
    if (p.exact_everywhere || *t == p.t1)
        current.o->worst = std::max(current.o->worst,
                                    error_of(p, *t, Eigen::Map<VectorXd>(y, *n), *t - *before, current.tol));
}

}  // namespace

bool radau5_available() { return peers::radau5_available(); }

namespace {

/// From (t, y) to t1.
void run_to(double t1, double& t, VectorXd& y, const problem& p, double tol, outcome& o) {
    int n = static_cast<int>(y.size()), itol = 0, ijac = 1, iout = 1, ipar = 0, idid = 0, ml = n, mu = n;
    int imas = p.ordinary() ? 0 : 1, mlmas = 0, mumas = 0;
    double h = 0, rpar = 0;
    int lwork = n * (n + imas + 3 * n + 12) + 20, liwork = 3 * n + 20;
    std::vector<double> work(static_cast<std::size_t>(lwork), 0.0);
    std::vector<int> iwork(static_cast<std::size_t>(liwork), 0);
    iwork[1] = 100000;  // steps allowed
    for (const int i : p.index) ++iwork[static_cast<std::size_t>(3 + std::max(i, 1))];
    peers::radau5_symbol()(&n, right_hand_side, &t, y.data(), &t1, &h, &tol, &tol, &itol,
                           reinterpret_cast<void (*)()>(jacobian), &ijac, &ml, &mu, mass, &imas, &mlmas,
                           &mumas, accepted, &iout, work.data(), &lwork, iwork.data(), &liwork, &rpar, &ipar,
                           &idid);
    o.success = idid == 1;
    o.status = "idid " + std::to_string(idid);
    o.t = t;
    o.steps += iwork[15];
}

}  // namespace

/// Driven by hand from point to point where times are known: up to the double before each, and on from it.
outcome run_radau5(const problem& p, double tol) {
    outcome o;
    current = {&p, &o, tol};
    VectorXd y = p.y0;
    double t = p.t0;
    std::vector<double> stops = p.known;
    stops.insert(stops.end(), p.doses.begin(), p.doses.end());
    std::sort(stops.begin(), stops.end());
    for (const double stop : stops) {
        run_to(std::nextafter(stop, p.t0), t, y, p, tol, o);
        if (!o.success) return o;
        t = stop;
        if (!p.doses.empty()) p.dose(t, y);
    }
    run_to(p.t1, t, y, p, tol, o);
    return o;
}

}  // namespace campaign
