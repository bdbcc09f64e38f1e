// SPDX-License-Identifier: BSL-1.0
// Chapter 5 and section 6.2: single and multiple shooting, and the elimination that is shooting in disguise.
#include <stagecraft/linear/two_point_matrix.hpp>

#include <Eigen/LU>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>

#include "experiments.hpp"

namespace boundary_values {

namespace {

/// Enough digits for what cond X(10) = e^210 loses.
using wide =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<200>, boost::multiprecision::et_off>;
using wide_matrix = theory::square_matrix<wide>;
using problem = theory::linear_two_point<wide>;

/// Stoer and Bulirsch, section 7.3.4: eigenvalues -10 and 11, eigenvectors (1, -10) and (1, 11); x_1(0) = x_1(10) = 1.
const MatrixXd coefficients = (MatrixXd(2, 2) << 0, 1, 110, 1).finished();

problem growth() {
    wide_matrix B0(2, 2), BT(2, 2);
    B0 << 1, 0, 0, 0;
    BT << 0, 0, 1, 0;
    return {[](const wide& t) {
                const wide e = exp(-10 * t), g = exp(11 * t);
                wide_matrix X(2, 2);
                X << 11 * e + 10 * g, g - e, 110 * (g - e), 10 * e + 11 * g;
                return wide_matrix(X / 21);
            },
            0, 10, B0, BT};
}

/// Ascher, Mattheij and Russell, p. 151: modes e^{-18 t} and e^{20 t} that turn with t; x(0) + x(pi) given.
problem modes() {
    const wide_matrix one = wide_matrix::Identity(2, 2);
    return {[](const wide& t) {
                const wide e = exp(-18 * t), g = exp(20 * t), c = cos(t), s = sin(t);
                wide_matrix X(2, 2);
                X << c * e, s * g, -s * e, c * g;
                return X;
            },
            0, boost::math::constants::pi<wide>(), one, one};
}

std::vector<wide> equal_parts(const problem& p, int N) {
    std::vector<wide> t;
    for (int i = 0; i <= N; ++i) t.push_back(p.at(i, N));
    return t;
}

struct condition {
    double inverse, product;
};
/// |S'^-1| and cond S' in the 2-norm; with all digits where double would not do.
condition condition_of(const problem& p, int N) {
    const auto t = equal_parts(p, N);
    const wide_matrix S = theory::shooting_matrix(p, t);
    if (N < 9) {
        const wide inverse = theory::two_norm<wide>(p.inverse(S));
        return {static_cast<double>(inverse), static_cast<double>(wide(inverse * theory::two_norm<wide>(S)))};
    }
    const MatrixXd rounded = S.cast<double>();
    const double inverse = theory::two_norm<double>(rounded.partialPivLu().inverse());
    return {inverse, inverse * theory::two_norm<double>(rounded)};
}

template <class Scalar>
std::vector<Eigen::Matrix<Scalar, 2, 1>> by_recursion(const Eigen::Matrix<Scalar, 2, 2>& L,
                                                      const Eigen::Matrix<Scalar, 2, 2>& R, int N) {
    // Section 6.2: w_0 = y_0, w_i = R y_i; then w_i = G_i w_0, and the conditions are 2 equations for w_0.
    using matrix = Eigen::Matrix<Scalar, 2, 2>;
    const matrix Ri = R.inverse(), step = -L * Ri;
    matrix G = -L, M;
    for (int i = 1; i < N; ++i) G = step * G;
    const matrix end = Ri * G;
    M << Scalar(1), Scalar(0), end(0, 0), end(0, 1);
    std::vector<Eigen::Matrix<Scalar, 2, 1>> y{
        M.partialPivLu().solve(Eigen::Matrix<Scalar, 2, 1>(Scalar(1), Scalar(1)))};
    Eigen::Matrix<Scalar, 2, 1> w = -L * y[0];
    for (int i = 1; i <= N; ++i) {
        y.push_back(Ri * w);
        w = step * w;
    }
    return y;
}

}  // namespace

chapter stoer_bulirsch() {
    chapter out;
    const problem p = growth();
    using vector = Eigen::Matrix<wide, Eigen::Dynamic, 1>;
    vector z(2);
    z << wide(1), -10 + wide("1e-9");
    const wide reached = (p.X(10) * z)[0];
    out.find("Stoer-Bulirsch: x_1(10) from -10 + 1e-9", "2.8e37",
             number(static_cast<double>(reached), "%.4e"), "2.8195e+37",
             near(static_cast<double>(reached), 2.8195e37, 1e-4));
    const wide_matrix M = p.solvability();
    const double cond =
        static_cast<double>(wide(theory::two_norm<wide>(M) * theory::two_norm<wide>(p.inverse(M))));
    const double kappa1 = static_cast<double>(p.kappa1(20)), kappa2 = static_cast<double>(p.kappa2(10));
    const auto zero = [](double) { return VectorXd(VectorXd::Zero(2)); };
    const auto r = solve({[](double) { return coefficients; }, zero},
                         {p.B0.cast<double>(), p.BT.cast<double>(), VectorXd::Ones(2)}, 10, {.rtol = 1e-10});
    out.find("its kappa1, kappa2 from X(t), 200 digits", "-", number(kappa1) + ", " + number(kappa2),
             "sqrt(122) = " + number(std::sqrt(122.0)),
             near(kappa1, std::sqrt(122.0), 1e-7) && near(kappa2, std::sqrt(122.0), 1e-7));
    out.find("its kappa1, kappa2 by collocation, status", "-",
             number(r.conditioning.kappa1) + ", " + number(r.conditioning.kappa2) + ", " + name(r.status),
             number(std::sqrt(122.0)),
             r.ok() && near(r.conditioning.kappa1, std::sqrt(122.0), 1e-5) &&
                 near(r.conditioning.kappa2, std::sqrt(122.0), 1e-5));
    out.find("its cond M", "large", number(cond, "%.2e"), "2.8e+48", near(cond, 2.8e48, 0.02));

    // Single shooting: M z = d, then x_1(10) from z.
    const MatrixXd in_double = M.cast<double>();
    const VectorXd start = in_double.partialPivLu().solve(VectorXd(VectorXd::Ones(2)));
    const wide missed = (p.X(10) * vector(start.cast<wide>()))[0] - 1;
    using boost::multiprecision::cpp_bin_float;
    using eighty = boost::multiprecision::number<cpp_bin_float<80>, boost::multiprecision::et_off>;
    const theory::square_matrix<eighty> in_80_digits = M.cast<eighty>();
    const Eigen::Matrix<eighty, Eigen::Dynamic, 1> ones = Eigen::Matrix<eighty, Eigen::Dynamic, 1>::Ones(2);
    const vector exact = in_80_digits.partialPivLu().solve(ones).eval().cast<wide>();
    const wide met = (p.X(10) * exact)[0] - 1;
    out.find("single shooting in double: |x_1(10) - 1|", "fails",
             number(std::abs(static_cast<double>(missed)), "%.1e"), "at least 1/2", abs(missed) > 0.5);
    out.find("with 80 digits", "-", number(std::abs(static_cast<double>(met)), "%.0e"), "below 1e-25",
             abs(met) < 1e-25);
    const std::vector<std::pair<int, double>> table{
        {5, 1.9e11}, {10, 3.2e6}, {20, 1.3e4}, {40, 838}, {80, 231}};
    for (const auto& [N, theory] : table) {
        const double c = condition_of(p, N).product;
        out.find("multiple shooting, N = " + std::to_string(N) + ": cond S'", "-", number(c, "%.4g"),
                 number(theory, "%.3g"), near(c, theory, N < 40 ? 0.03 : 0.002));
    }
    return out;
}

chapter turning_modes() {
    chapter out;
    const problem p = modes();
    struct line {
        int N;
        const char* printed;
        double cond, inverse, block;
    };
    for (const line& row : {line{1, "1, 1.9e27", 1.9388e27, 1, 0}, line{3, "1, 1.2e9", 1.2469e9, 1, 0},
                            line{9, "1, 1.1e3", 1079.3, 1.002, 0}, line{15, "1, 6.9e1", 68.50, 1.024, 69.55},
                            line{24, "1.1, 1.6e1", 16.25, 1.105, 17.41}}) {
        const condition c = condition_of(p, row.N);
        const std::string which = "AMR p. 151, N = " + std::to_string(row.N);
        out.find(which + ": |S'^-1|, cond S' in the 2-norm", row.printed,
                 number(c.inverse, "%.4g") + ", " + number(c.product, "%.5g"),
                 number(row.inverse, "%.4g") + ", " + number(row.cond, "%.5g"),
                 near(c.product, row.cond, 1.5e-4) && std::abs(c.inverse - row.inverse) < 5.1e-4);
        if (row.block == 0) continue;
        const auto t = equal_parts(p, row.N);
        const wide_matrix S = theory::shooting_matrix(p, t), R = theory::shooting_inverse(p, t);
        const double block = static_cast<double>(
            wide(theory::block_row_norm<wide>(S, 2) * theory::block_row_norm<wide>(R, 2)));
        out.find(which + ": cond S' in the norm of Satz 5.1", row.printed, number(block, "%.4g"),
                 number(row.block, "%.4g"), near(block, row.block, 3e-4));
    }
    const auto A = [](double t) {
        MatrixXd a(2, 2);
        const double c = 19 * std::cos(2 * t), s = 19 * std::sin(2 * t);
        a << 1 - c, 1 + s, s - 1, 1 + c;
        return a;
    };
    const auto q = [A](double t) {
        return VectorXd(std::exp(t) * (VectorXd::Ones(2) - A(t) * VectorXd::Ones(2)));
    };
    const MatrixXd one = MatrixXd::Identity(2, 2);
    const auto r = solve({A, q}, {one, one, (1 + std::exp(pi)) * VectorXd::Ones(2)}, pi, {.rtol = 1e-10});
    double error = 0;
    for (int k = 0; k < 100; ++k) {
        const double t = pi * k / 100;
        error = std::max(
            error, (r.y(t) - std::exp(t) * VectorXd::Ones(2)).cwiseAbs().maxCoeff() / (1 + std::exp(t)));
    }
    out.find("by collocation: kappa1, kappa2, status", "2",
             number(r.conditioning.kappa1, "%.4f") + ", " + number(r.conditioning.kappa2, "%.4f") + ", " +
                 name(r.status),
             "1.0000",
             r.ok() && near(r.conditioning.kappa1, 1, 1e-4) && near(r.conditioning.kappa2, 1, 1e-4));
    out.find("its error, estimate " + number(r.error.global, "%.0e"), "-", number(error, "%.0e"),
             "at most 1e-10", error <= 1e-10);
    return out;
}

chapter factorisation() {
    chapter out;
    for (const int N : {10, 100, 1000}) {
        // Lobatto IIIA-3: R(z) = (1 + z/2 + z^2/12)/(1 - z/2 + z^2/12).
        const wide h = wide(10) / N;
        const Eigen::Matrix<wide, 2, 2> A = coefficients.cast<wide>(),
                                        one = Eigen::Matrix<wide, 2, 2>::Identity();
        const Eigen::Matrix<wide, 2, 2> square = A * A * (h * h / 12), half = A * (h / 2),
                                        L = -(one + half + square), R = one - half + square;
        const auto exact = by_recursion<wide>(L, R, N);
        const Eigen::Matrix2d Ld = L.cast<double>(), Rd = R.cast<double>();
        const auto lecture = by_recursion<double>(Ld, Rd, N);
        two_point_matrix<double, 2> m;
        MatrixXd conditions = MatrixXd::Zero(2, 4), block(2, 4), g = MatrixXd::Zero(2, N), y(2, N + 1);
        conditions(0, 0) = conditions(1, 2) = 1;
        block << Ld, Rd;
        m.start(2, N, conditions);
        for (int i = 0; i < N; ++i) m.set(i, block);
        m.factor();
        VectorXd none(0);
        m.solve(g, VectorXd(VectorXd::Ones(2)), y, none);
        double theirs = 0, ours = 0;
        for (int i = 0; i <= N; ++i) {
            const Eigen::Vector2d reference = exact[i].cast<double>();
            const double size = 1 + reference.norm();
            theirs = std::max(theirs, (lecture[i] - reference).norm() / size);
            ours = std::max(ours, (y.col(i) - reference).norm() / size);
        }
        // What the recursion makes of rounding errors: R(11 h)^N times as much.
        const double z = 110.0 / N, R_of_z = (1 + z / 2 + z * z / 12) / (1 - z / 2 + z * z / 12);
        const double lost = std::numeric_limits<double>::epsilon() * std::pow(R_of_z, N);
        out.find("section 6.2 on Stoer-Bulirsch, N = " + std::to_string(N) + ": its error, ours",
                 "stable solver needed", number(theirs, "%.0e") + ", " + number(ours, "%.0e"),
                 "about " + number(lost, "%.0e") + ", 1e-15",
                 theirs > lost / 1000 && theirs < 1000 * lost && ours < 1e-14);
    }
    return out;
}

}  // namespace boundary_values
