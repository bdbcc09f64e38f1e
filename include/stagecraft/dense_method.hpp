// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/integrate.hpp>
#include <stagecraft/method/dense_method.hpp>
#include <stagecraft/step/dense_step.hpp>

// integrate() with methods whose continuous solution is the one published with them (method/dense_method.hpp):
//
//     solution<Vector2d> y;
//     integrate(dormand_prince_8_5_3_dense(), f, y0, t0, t1, {}, y);          // y(t) of order 7; coefficients/dense.hpp
//     integrate(tableaux::read_method("tsitouras_5_4.json"), ...)             // of any file with b_theta
