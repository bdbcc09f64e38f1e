// SPDX-License-Identifier: BSL-1.0
// Runs of methods on problems, and the spurious solutions that methods add, as functions that JavaScript calls; engine.cpp
// says how they answer.
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <stagecraft/families.hpp>
#include <stagecraft/method/step_doubling.hpp>
#include <stagecraft/tableaux/tableau_from_file.hpp>
#include <stagecraft/theory/dynamics/ghosts.hpp>
#include <string>

#include "answer.hpp"
#include "method_argument.hpp"
#include "runs.hpp"

namespace {

using namespace stagecraft;
using namespace playground;

/// The number that `text` is, between `least` and `most`.
double number(const char* argument, const std::string& text, double least, double most) {
    char* end = nullptr;
    const double x = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !(least <= x && x <= most)) {
        std::ostringstream allowed;
        allowed << least << " to " << most;
        throw std::invalid_argument(std::string(argument) + ": '" + text + "' is not a number from " +
                                    allowed.str());
    }
    return x;
}

/// "gauss 3" as the member of a family, else the text of a tableau.
runnable method_of(const std::string& text) {
    const auto space = text.find(' ');
    const std::string family = text.substr(0, space);
    if (space != text.npos && text.find_first_of("{[=\n") == text.npos) {
        const int s = tool::member_of_family(family, text.substr(space + 1), 9).stages;
        if (family == "gauss") return gauss(s);
        if (family == "radau_ia") return radau_ia(s);
        if (family == "radau_iia") return radau_iia(s);
        if (family == "lobatto_iiic") return lobatto_iiic(s);
        return family == "lobatto_iiia" ? lobatto_iiia(s) : lobatto_iiib(s);
    }
    return tableaux::rounded<double>(only_tableau(text, "auto", "auto"));
}

/// The same with an estimate of errors: where no weights are given, of two half steps.
runnable estimating(runnable method) {
    if (const auto* t = std::get_if<tableau<double>>(&method); t && t->b_embedded.size() == 0)
        return step_doubling(*t);
    return method;
}

problem problem_of(const problem_kind& kind, const std::string& parameter) {
    const auto& p = kind.parameter;
    return kind.make(p.name.empty() ? 0 : number(p.name.data(), parameter, p.least, p.most));
}

double end_of(const std::string& text) { return number("to t", text, 1e-9, 1e12); }

const Eigen::VectorXd& solution_of(const problem_kind& kind, const problem& p, const std::string& parameter,
                                   double t1) {
    static std::map<std::string, Eigen::VectorXd> kept;
    const auto key = std::string(kind.name) + ' ' + parameter + ' ' + std::to_string(t1);
    auto place = kept.find(key);
    if (place == kept.end()) place = kept.emplace(key, p.solution ? p.solution(t1) : accurate(p, t1)).first;
    return place->second;
}

json points_of(const theory::periodic_points& found) {
    json points = json::array();
    for (const auto& p : found.points)
        points.push_back({{"x", p.value()},
                          {"equilibrium", p.equilibrium},
                          {"attracting", p.attracting()},
                          {"multiplier", p.multiplier.middle()}});
    return {{"verdict", std::string(name(found.verdict.standing()))},
            {"reason", found.verdict.reason()},
            {"points", points}};
}

}  // namespace

extern "C" {

/// The problems to choose from.
const char* stagecraft_problems() {
    return answered([] {
        json all = json::array();
        for (const auto& k : problem_kinds()) {
            all.push_back({{"name", k.name},
                           {"title", k.title},
                           {"equations", k.equations},
                           {"source", k.source},
                           {"components", k.components},
                           {"t1", k.t1},
                           {"order_t1", k.order_t1},
                           {"across", k.across},
                           {"up", k.up},
                           {"decades", k.decades}});
            const auto& p = k.parameter;
            if (!p.name.empty())
                all.back()["parameter"] = {
                    {"name", p.name}, {"standard", p.standard}, {"least", p.least}, {"most", p.most}};
        }
        return all;
    });
}

/// A run to t1: with step sizes for a tolerance, or with equal ones where `step` is not empty.
const char* stagecraft_run(const char* method, const char* problem, const char* parameter, const char* t1,
                           const char* tolerance, const char* step) {
    return answered([&] {
        const auto p = problem_of(kind_of_problem(problem), parameter);
        options<double> o{.max_steps = 20000};
        if (*step != '\0') {
            o.rtol = o.atol = 1e-12;
            o.fixed_step = number("step", step, 1e-9, 1e12);
            return run(method_of(method), p, end_of(t1), o);
        }
        o.rtol = number("tolerance", tolerance, 1e-13, 1);
        o.atol = o.rtol * kind_of_problem(problem).scale;
        return run(estimating(method_of(method)), p, end_of(t1), o);
    });
}

/// The errors at t1 of so many equal steps.
const char* stagecraft_error(const char* method, const char* problem, const char* parameter, const char* t1,
                             const char* steps) {
    return answered([&] {
        const auto& kind = kind_of_problem(problem);
        const auto p = problem_of(kind, parameter);
        const double end = end_of(t1);
        return error_at_end(method_of(method), p, end, tool::whole_number("steps", steps, 1, 100000),
                            solution_of(kind, p, parameter, end));
    });
}

/// Where equal steps go that solve y' = y (1 - y), for step sizes between two.
const char* stagecraft_orbits(const char* method, const char* low, const char* high, const char* count) {
    return answered([&] {
        return orbits(method_of(method), kind_of_problem("logistic").make(0), number("low", low, 1e-6, 100),
                      number("high", high, 1e-6, 100), tool::whole_number("count", count, 1, 1000));
    });
}

/// All points that a step h of an explicit method for y' = y (1 - y) sends to themselves, and those that two steps do.
const char* stagecraft_ghosts(const char* method, const char* step) {
    return answered([&] {
        const auto h = tableaux::read_entry(step, tableaux::exact_decimals::all());
        if (!h.exact || !h.exact->is_rational())
            throw std::invalid_argument("h: '" + std::string(step) + "' is not a fraction or a decimal");
        const auto m = tableaux::to_rational(only_tableau(method, "auto", "exact"));
        const auto f = [](const auto&, const auto& x, auto& out) { out[0] = x[0] * (1 - x[0]); };
        const auto size = h.exact->rational_part();
        return json{{"fixed", points_of(theory::ghosts(m, f, size))},
                    {"cycles", points_of(theory::two_cycles(m, f, size))}};
    });
}
}
