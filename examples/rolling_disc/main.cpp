// SPDX-License-Identifier: BSL-1.0
// The rolling disc: an exact Radau IIA tableau, its certificate, and what the method makes of the index-2
// system.
#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stagecraft/coefficients/radau_iia.hpp>

#include <problems/rolling_disc/measure.hpp>
#include "proof.hpp"
#include "report.hpp"

namespace {

using namespace rolling_disc;

constexpr int loosest = 4, tightest = 12;

std::string heading(const std::string& text) { return text + "\n" + std::string(text.size(), '-') + "\n"; }

std::string table_head() {
    return "    tol   steps  rejected      f    LU    error q,q'    error lambda   max|G q'|    |dE|/J    us "
           "min  us "
           "median\n";
}

std::string table_row(const run& r, const timing& t, const state& exact) {
    std::ostringstream out;
    out << std::scientific << std::setprecision(0) << std::setw(7) << r.tolerance << std::setw(8)
        << r.report.steps << std::setw(10) << r.report.rejected() << std::setw(7) << r.report.f
        << std::setw(6) << r.report.factorisations << std::setprecision(2) << std::setw(14)
        << r.error_y(exact) << std::setw(16) << r.error_lambda(exact) << std::setw(12)
        << r.largest_violation() << std::setw(10) << r.largest_drift() << std::fixed << std::setprecision(0)
        << std::setw(10) << t.minimum << std::setw(11) << t.median << '\n';
    return out.str();
}

std::vector<double> work_row(const run& r, const timing& t, const state& exact) {
    return {r.tolerance,
            static_cast<double>(r.report.steps),
            static_cast<double>(r.report.rejected()),
            static_cast<double>(r.report.f),
            static_cast<double>(r.report.factorisations),
            r.error_y(exact),
            r.error_lambda(exact),
            t.minimum,
            t.median};
}

void write_steps(const std::string& file, const run& r) {
    std::vector<std::vector<double>> rows;
    for (const auto& s : r.steps) rows.push_back({s.t, s.h, s.violation[0], s.violation[1], s.drift});
    write_table(file, "t h (G q')_1 (G q')_2 energy-energy0", rows);
}

// All tolerances with one method; the tables go to `directory` unless it is empty.
template <class Method>
std::string work_precision(const Method& method, const std::string& directory, int repeats,
                           const state& exact, bool with_steps) {
    const disc<> body;
    std::string table = table_head();
    std::vector<std::vector<double>> rows;
    for (int digits = loosest; digits <= tightest; ++digits) {
        const double tolerance = std::stod("1e-" + std::to_string(digits));
        const run r = observe(method, body, tolerance, [](double, const auto&) {});
        if (r.status != stagecraft::status::success)
            throw std::runtime_error("the run ended with " + std::string(name(r.status)));
        const timing t = time_run(method, body, tolerance, repeats);
        table += table_row(r, t, exact);
        rows.push_back(work_row(r, t, exact));
        if (with_steps && !directory.empty())
            write_steps(directory + "/steps_" + std::to_string(digits) + ".dat", r);
    }
    if (!directory.empty())
        write_table(directory + "/work_" + std::to_string(method.stages()) + ".dat",
                    "tol steps rejected f LU error_y error_lambda us_min us_median", rows);
    return table;
}

// The solution on a fine grid, from the continuous output of a run at 1e-12.
template <class Method>
void write_solution(const Method& method, const std::string& directory) {
    constexpr int points = 800;
    const disc<> body;
    std::vector<std::vector<double>> rows;
    const auto add = [&](double t, const state& y) {
        const Eigen::Matrix<double, 5, 1> q = y.head<5>(), v = y.segment<5>(5);
        const double kinetic = stagecraft::kinetic_energy(body, q, v), potential = body.potential(q);
        std::vector<double> row{t};
        row.insert(row.end(), y.data(), y.data() + 12);
        row.insert(row.end(), {kinetic, potential, kinetic + potential});
        rows.push_back(row);
    };
    add(0, stagecraft::index_2(body).initial_state(initial_position(), initial_velocity(body)));
    observe(method, body, 1e-12, [&](double t, const auto& output) {
        for (double next = static_cast<double>(rows.size()) / points; next <= t;
             next = static_cast<double>(rows.size()) / points)
            add(next, output(next));
    });
    write_table(directory + "/solution.dat",
                "t x y alpha beta gamma x' y' alpha' beta' gamma' lambda1 lambda2 kinetic potential total",
                rows);
}

// The drift off the constraint after index reduction, for contrast.
template <class Method>
void write_reduced(const Method& method, const std::string& directory, int digits) {
    const disc<> body;
    const double tolerance = std::stod("1e-" + std::to_string(digits));
    Eigen::Matrix<double, 10, 1> y0;
    y0 << initial_position(), initial_velocity(body);
    const double energy0 = stagecraft::total_energy<double>(body, y0.head<5>(), y0.tail<5>());
    std::vector<std::vector<double>> rows;
    const auto result = stagecraft::integrate(
        method, stagecraft::index_reduced(body), y0, 0.0, 1.0, {.rtol = tolerance, .atol = tolerance},
        [&](double t, const Eigen::Matrix<double, 10, 1>& y, double h) {
            const Eigen::Matrix<double, 5, 1> q = y.head<5>(), v = y.tail<5>();
            const Eigen::Vector2d u = body.G(q) * v;
            rows.push_back({t, h, u[0], u[1], stagecraft::total_energy(body, q, v) - energy0});
        });
    if (!result.ok()) throw std::runtime_error("index reduction: " + std::string(name(result.status)));
    write_table(directory + "/reduced_" + std::to_string(digits) + ".dat",
                "t h (G q')_1 (G q')_2 energy-energy0", rows);
}

std::string introduction() {
    return "A thin disc (radius 0.1 m, mass 1 kg) starts upright but for 5 degrees, rolling half a turn per "
           "second "
           "without slip. It tumbles, turns and rights itself within a second. Its equations of motion with "
           "the two rolling constraints form a differential-algebraic system of index 2 with 12 unknowns.";
}

std::vector<picture> pictures() {
    return {
        {"solution", "Solution",
         "Coordinates and constraint forces over one second, from a run at tolerance 1e-12."},
        {"track", "Track on the plane", "The contact point and the centre of the disc from above."},
        {"energy", "Energy",
         "Kinetic and potential energy are exchanged, their sum is constant: below, its change at the "
         "accepted "
         "steps."},
        {"violation", "Constraint violation",
         "The index-2 system keeps the rolling constraint at every step to the accuracy of the Newton "
         "iteration; "
         "after index reduction the solution drifts off."},
        {"steps", "Step sizes", "Small steps where the disc leans most and spins fastest, near t = 0.5 s."},
        {"work", "Error against run time",
         "Maximum error at t = 1 against the reference solution (33 digits), one point per tolerance 1e-4 "
         "... "
         "1e-12. Filled: positions and velocities, open: constraint forces."}};
}

int report(const std::string& directory, int repeats) {
    std::string text = heading("Radau IIA with 3 stages, exactly");
    text += exact_tableau_text() + '\n';
    text += heading("What is proved of it") + certificate_text() + '\n';
    text += heading("The rolling disc as index-2 system, 12 unknowns, t in [0, 1]");
    std::cout << text << std::flush;

    const auto exact = reference_solution(
        std::string(ROLLING_DISC_SOURCE) + "/../problems/rolling_disc/data/disc.json", "1.0");
    if (!directory.empty()) std::filesystem::create_directories(directory);
    const std::string table =
        work_precision(stagecraft::radau_iia<3>(), directory, repeats, exact, true) +
        "(errors at t = 1 against the reference, maximum norm; |dE| the largest change of "
        "the energy; both at accepted steps)\n";
    std::cout << table << std::flush;
    if (directory.empty()) return 0;
    work_precision(stagecraft::radau_iia<5>(), directory, repeats, exact, false);
    write_solution(stagecraft::radau_iia<3>(), directory);
    write_reduced(stagecraft::radau_iia<3>(), directory, 8);
    write_reduced(stagecraft::radau_iia<3>(), directory, 12);
    write_page(directory, "3 5", "A rolling disc by Radau IIA", introduction(), text + table, pictures());
    std::cout << "\nPictures: " << directory << "/index.html\n";
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"An exact Radau IIA tableau, its certificate, and the rolling disc solved with it."};
    std::string directory;
    int repeats = 25;
    app.add_option("--report", directory, "directory for the pictures and the page index.html");
    app.add_option("--repeat", repeats, "how often each run is timed")->check(CLI::Range(1, 100000));
    CLI11_PARSE(app, argc, argv);
    try {
        return report(directory, repeats);
    } catch (const std::exception& e) {
        std::cerr << "rolling_disc: " << e.what() << '\n';
        return 1;
    }
}
