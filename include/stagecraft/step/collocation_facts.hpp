// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>

#include <stagecraft/dense_output.hpp>
#include <stagecraft/method/collocation_functionals.hpp>
#include <stagecraft/method/order_conditions.hpp>
#include <stagecraft/method/structure.hpp>

namespace stagecraft {

/// What follows from the coefficients of a method with regular A and distinct nodes, as functionals of its stages
/// z_i = Y_i - y. Columns: how many nodes the continuous solution may have, at compile time.
template <class Scalar, int Stages, int Columns>
struct collocation_facts {
    using weights = Eigen::Matrix<Scalar, Stages, 1>;

    interpolation_nodes<Scalar, Columns> nodes;
    weights update;             // z -> y1 - y
    weights start;              // z -> value at 0 of the polynomial through the stages alone
    weights leading;            // z -> a_{s-1} of the polynomial through the stages alone
    weights left, right, ends;  // z -> h u'(0), h u'(1), change at 1 without the node 0
    bool stiffly_accurate = true, jump = false, stage_order_two = false;
    int order = 0;

    /// std::invalid_argument where the method has no stage, or its matrices are of another size.
    [[gnu::cold]] static collocation_facts of(const transformed_tableau<Scalar, Stages>& method) {
        const int s = method.stages();
        if (s < 1 || method.A.rows() != s || method.A_inverse.rows() != s || method.c.size() != s)
            throw std::invalid_argument("integrate: method must have at least one stage and a regular A");
        const weights zero = weights::Zero(s);
        collocation_facts known{interpolation_nodes<Scalar, Columns>(s), zero, zero, zero, zero, zero, zero};
        for (int j = 0; j < s; ++j)
            for (int i = 0; i < s; ++i) known.update[j] += method.b[i] * method.A_inverse(i, j);
        known.stiffly_accurate = method.stiffly_accurate();
        known.jump = method.c[0] == Scalar(0);
        known.stage_order_two = stagecraft::has_stage_order_two(method);
        known.order = method.facts.order > 0 ? method.facts.order : quadrature_conditions(method, 2 * s);
        // Node list of the continuous polynomial: 0 carries y, a first stage at 0 gives way to the end point
        // (Radau IA) or drops out where the end point is a node already (Lobatto IIIC).
        auto& nodes = known.nodes;
        nodes.first_column = known.jump && known.stiffly_accurate && s > 1 ? 1 : 0;
        nodes.size = s - nodes.first_column;
        for (int j = 0; j < nodes.size; ++j) nodes.c[j] = method.c[j + nodes.first_column];
        if (known.jump && nodes.first_column == 0) nodes.c[0] = Scalar(1);
        nodes.finish();
        if (!known.jump) known.left = slope_at_left_end(method);
        known.ends = change_without_left_node(method);
        known.start = value_at_left_end(method);
        known.leading = leading_legendre_coefficient(method);
        if (!known.stiffly_accurate) known.right = slope_at_right_end(method);
        return known;
    }
};

}  // namespace stagecraft
