// SPDX-License-Identifier: BSL-1.0
// says: M, F, G, g and b of a mechanical model must accept any scalar
// says: model.solve_mass must be callable
// says: model.G_rate must be callable
// says: model.potential must be callable
// says: model.singularity must be callable
// says: M, F, G, g and b of a mechanical model must return matrices, not expressions of Eigen's
#include <stagecraft/refuse/mechanics/checked_model.hpp>

// A particle in the plane, with optional members that cannot be used, and the same as they must be.
template <class S, int Rows = 2>
using matrix = Eigen::Matrix<S, Rows, 2>;
template <class S>
using vector = Eigen::Matrix<S, 2, 1>;

struct particle {
    static constexpr int coordinates = 2, constraints = 1;
    template <class S>
    matrix<S> M(const vector<S>&) const;
    template <class S>
    vector<S> F(const vector<S>&, const vector<S>&) const;
    template <class S>
    matrix<S, 1> G(const vector<S>&) const;
};

#ifdef RIGHT
struct pulled : particle {
    template <class S>
    vector<S> F(const vector<S>&, const vector<S>&) const;
};
struct solving : particle {
    template <class S>
    vector<S> solve_mass(const vector<S>&, const vector<S>&) const;
};
struct turning : particle {
    template <class S>
    matrix<S, 1> G_rate(const vector<S>&, const vector<S>&) const;
};
struct falling : particle {
    template <class S>
    S potential(const vector<S>&) const;
};
struct singular : particle {
    static constexpr const char* singular_position = "everywhere";
    template <class S>
    S singularity(const vector<S>&) const;
};
struct braked : particle {
    template <class S>
    vector<S> F(const vector<S>&, const vector<S>& v) const {
        const vector<S> brakes(1, 2);
        return -brakes.cwiseProduct(v);
    }
};
struct chain {
    int coordinates() const { return 2; }
    int constraints() const { return 1; }
    Eigen::DiagonalMatrix<double, 2> M() const { return Eigen::Vector2d(1, 2).asDiagonal(); }
    Eigen::VectorXd F(const Eigen::VectorXd&, const Eigen::VectorXd&) const;
    const Eigen::MatrixXd& G(const Eigen::VectorXd&) const { return gradient; }
    Eigen::MatrixXd gradient;
};
#else
struct braked : particle {
    template <class S>
    auto F(const vector<S>&, const vector<S>& v) const {
        const vector<S> brakes(1, 2);
        return -brakes.cwiseProduct(v);
    }
};
struct chain {
    int coordinates() const { return 2; }
    int constraints() const { return 1; }
    auto M() const { return Eigen::Vector2d(1, 2).asDiagonal(); }
    Eigen::VectorXd F(const Eigen::VectorXd&, const Eigen::VectorXd&) const;
    const Eigen::MatrixXd& G(const Eigen::VectorXd&) const { return gradient; }
    Eigen::MatrixXd gradient;
};
struct pulled : particle {
    vector<double> F(const vector<double>&, const vector<double>&) const;
};
struct solving : particle {
    template <class S>
    vector<S> solve_mass(const vector<S>&, const vector<S>&);
};
struct turning : particle {
    template <class S>
    matrix<S, 1> G_rate(const vector<S>&) const;
};
struct falling : particle {
    double potential = 0;
};
struct singular : particle {
    template <class S>
    S singularity(const vector<S>&) const;
};
#endif

template struct stagecraft::checked_model<pulled>;
template struct stagecraft::checked_model<solving>;
template struct stagecraft::checked_model<turning>;
template struct stagecraft::checked_model<falling>;
template struct stagecraft::checked_model<singular>;
template struct stagecraft::checked_model<braked>;
template struct stagecraft::checked_model<chain>;
