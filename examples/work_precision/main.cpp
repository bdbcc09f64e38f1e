// SPDX-License-Identifier: BSL-1.0
// Error against run time: stagecraft beside RADAU5, SUNDIALS and Boost.odeint, in one process.
#include <CLI/CLI.hpp>
#include <iostream>

#include "compete.hpp"
#include "report.hpp"

void compete_on_reactions(const settings&, std::vector<curve>&);
void compete_on_larger_systems(const settings&, std::vector<curve>&);
void compete_on_mechanics(const settings&, std::vector<curve>&);
void compete_on_diffusion(const settings&, std::vector<curve>&);
void compete_on_kinetics(const settings&, std::vector<curve>&);
void compete_on_chains(const settings&, std::vector<curve>&);
void compete_on_full_matrices(const settings&, std::vector<curve>&);
bool open_dopri5(const std::string& library);
bool open_dop853(const std::string& library);
void compete_on_nonstiff(const settings&, std::vector<curve>&);
void print_growth();
#ifdef HAVE_KLU
void compete_on_split_problems(const settings&, std::vector<curve>&);
void compete_on_stabilised(const settings&, std::vector<curve>&);
#endif
void print_symplectic();
int compete_on_hard_problems(const settings&);

int main(int argc, char** argv) {
    settings set;
    std::string csv, svg;
    CLI::App app{"Error against run time: stagecraft beside the peers that are installed"};
    app.add_option(
        "--problem", set.problems,
        "only these: vdpol rober orego hires transamp kepler disc pollution network60 chain14 chain40 "
        "spectral24 spectral64 diodes20 bruss200 front400 bruss bruss-sparse; with "
        "--dopri5 or --dop853 also arenstorf lorenz pleiades");
    app.add_option("--solver", set.solvers, "only these, by the names in the table");
    app.add_option("--tolerances", set.tolerances, "relative tolerances (default 1e-2 ... 1e-12)")
        ->check(CLI::PositiveNumber);
    app.add_option("--repeats", set.repeats, "runs of each solver, interleaved")->check(CLI::PositiveNumber);
    app.add_option("--csv", csv, "write the table to this file");
    app.add_option("--svg", svg, "write one work-precision diagram per problem to this directory");
    std::string radau;
    app.add_option("--radau", radau, "library with RADAU, built of its published source radau.f")
        ->check(CLI::ExistingFile);
    std::string dopri5, dop853;
    app.add_option("--dopri5", dopri5, "library with DOPRI5, built of its published source dopri5.f")
        ->check(CLI::ExistingFile);
    app.add_option("--dop853", dop853, "library with DOP853, built of its published source dop853.f")
        ->check(CLI::ExistingFile);
    bool growth = false;
    app.add_flag("--growth", growth, "only the table of how the cost grows with n, s and the tolerance");
    bool imex = false, stabilised = false, symplectic = false;
    app.add_flag("--imex", imex,
                 "only problems in two parts: kaps vdpol-split bruss-split advection-reaction bruss-2d-split "
                 "gray-scott");
    app.add_flag("--stabilised", stabilised, "only diffusion by stabilised methods: front-2d combustion-2d");
    app.add_flag("--symplectic", symplectic, "only symplectic pairs over long times");
    bool hard = false;
    app.add_flag("--hard", hard,
                 "only these of the test set for initial value problems: pump water fekete nand crank");
    CLI11_PARSE(app, argc, argv);
    if (growth) {
        print_growth();
        return 0;
    }
    if (symplectic) {
        print_symplectic();
        return 0;
    }
    if (hard) return compete_on_hard_problems(set);
    if (set.tolerances.empty())
        for (int k = 2; k <= 12; ++k) set.tolerances.push_back(std::pow(10.0, -k));
    if (!radau.empty() && !peers::open_radau(radau)) {
        std::cerr << "--radau: the library has no radau_\n";
        return 2;
    }
    if (!dopri5.empty() && !open_dopri5(dopri5)) {
        std::cerr << "--dopri5: the library has no dopri5_\n";
        return 2;
    }
    if (!dop853.empty() && !open_dop853(dop853)) {
        std::cerr << "--dop853: the library has no dop853_\n";
        return 2;
    }
    if (!peers::radau5_available()) std::cerr << "radau5 is left out: install r-cran-desolve to have it\n";

    std::vector<curve> curves;
    if (imex || stabilised) {
#ifdef HAVE_KLU
        if (imex) compete_on_split_problems(set, curves);
        if (stabilised) compete_on_stabilised(set, curves);
        std::cerr << "\r                              \r";
        print_table(curves);
        if (!csv.empty()) write_csv(curves, csv);
        if (!svg.empty()) write_diagrams(curves, svg);
        if (imex) print_same_tables(curves);
        if (stabilised) print_ratios(curves, "stagecraft rkc2");
        return 0;
#else
        std::cerr << "--imex and --stabilised need KLU: install libsuitesparse-dev and build again\n";
        return 2;
#endif
    }
    compete_on_reactions(set, curves);
    compete_on_larger_systems(set, curves);
    compete_on_mechanics(set, curves);
    compete_on_kinetics(set, curves);
    compete_on_chains(set, curves);
    compete_on_full_matrices(set, curves);
    compete_on_diffusion(set, curves);
    if (!dopri5.empty() || !dop853.empty()) compete_on_nonstiff(set, curves);
    std::cerr << "\r                              \r";
    if (curves.empty()) {
        std::cerr << "--problem: no problem of that name\n";
        return 2;
    }
    print_table(curves);
    if (!csv.empty()) write_csv(curves, csv);
    if (!svg.empty()) write_diagrams(curves, svg);
    print_ratios(curves, "stagecraft");
}
