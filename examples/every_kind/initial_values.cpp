// SPDX-License-Identifier: BSL-1.0
#include <problems/stiff.hpp>
#include <problems/stored.hpp>
#include <stagecraft/coefficients/explicit.hpp>
#include <stagecraft/linear/banded_blocks.hpp>
#include <stagecraft/radau_iia_variable.hpp>
#include <work_precision/nonstiff.hpp>

#include "print_run.hpp"

namespace sc = stagecraft;

void initial_values() {
    print_run("not stiff", "Arenstorf's orbit", "Dormand-Prince 8(5;3)", sc::dormand_prince_8_5_3(),
              problems::arenstorf{}, problems::arenstorf::initial(), problems::arenstorf::t1,
              problems::reference("arenstorf"));
    print_run("stiff", "van der Pol", "Radau IIA variable", sc::radau_iia_variable(), problems::van_der_pol{},
              problems::van_der_pol::initial(), 2, problems::reference("vdpol"));
    const problems::brusselator large;
    print_run("large", "Brusselator with diffusion", "Radau IIA variable", sc::radau_iia_variable(), large,
              large.initial(), problems::brusselator::t1, problems::reference("brusselator1d_N500"));
}
