// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <utility>
#include <vector>

#include <stagecraft/integrate.hpp>
#include <stagecraft/method/low_storage_method.hpp>
#include <stagecraft/step/low_storage_step.hpp>

namespace stagecraft {

/// An explicit method that runs in the registers it is written in, whatever its number of stages: for systems so large that the
/// s slopes of a tableau do not fit. Williamson's 2N and Ketcheson's 2S take two vectors, 3S* a third, the state at the start
/// of the step, which a run that may refuse a step keeps anyway; f writes into one more, and embedded weights add up in
/// another. Shu and Osher's forms keep what later stages ask for.
///
///     integrate(carpenter_kennedy_2n_5_4(), f, y0, t0, t1, {.fixed_step = 0.01})
///     integrate(ranocha_3s_3_2(), f, y0, t0, t1, {.rtol = 1e-6, .atol = 1e-6})         // 3S* with an estimate
///     integrate(low_storage(storage_form::williamson, {{A...}, {B...}}), ...)
///
/// coefficients/low_storage.hpp has published ones, tableaux::read_method() reads files. Steps are adaptive with `b_embedded`, else
/// options.fixed_step. y(t) within a step is Hermite's cubic. std::invalid_argument where lists have other lengths or do
/// not hold the value at the beginning once; integrate() throws it for a problem with a mass matrix.
/// (Williamson 1980; Shu-Osher 1988; Ketcheson 2010; Ranocha-Dalcin-Parsani-Ketcheson 2022)
template <class Scalar = double>
low_storage_method<Scalar> low_storage(storage_form form, std::vector<std::vector<Scalar>> rows,
                                       const std::vector<Scalar>& b_embedded = {}) {
    detail::check_storage(form, rows);
    low_storage_method<Scalar> m{form, std::move(rows), {}};
    m.meaning = detail::expanded(form, m.rows);
    if (b_embedded.empty()) return m;
    if (static_cast<int>(b_embedded.size()) != m.stages())
        throw std::invalid_argument("low_storage(form, rows, b_embedded): one weight a stage");
    m.meaning.b_embedded.resize(m.stages());
    for (int j = 0; j < m.stages(); ++j) m.meaning.b_embedded[j] = b_embedded[static_cast<std::size_t>(j)];
    return m;
}

}  // namespace stagecraft
