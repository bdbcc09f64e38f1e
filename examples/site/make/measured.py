"""Tables and pictures of run times: measured once, kept as CSV beside the program that measured them, drawn for each site."""
import csv
import math
import subprocess

import pictures

HEADER = ("set terminal svg size 760,480 font 'sans,13' background 'white' dynamic\nset logscale xy\nset format '10^{%L}'\n"
          "set grid lc rgb '#dddddd'\nset key outside right\n")
COLOURS = ["#4c78a8", "#f58518", "#54a24b", "#e45756", "#72b7b2", "#b279a2", "#9d755d", "#333333", "#bab0ac"]


def read(site, path):
    return list(csv.DictReader((site.repository / path).read_text().splitlines()))


def draw(site, name, title, x, y, curves, reverse=False):
    """Writes a picture of curves {label: (points, colour, is it thin)} with both axes logarithmic; Markdown that shows it, for
    a page one folder deep."""
    lines = [HEADER, f"set title '{title}'\nset xlabel '{x}'\nset ylabel '{y}'\n", "set xrange [] reverse\n" if reverse else ""]
    parts = [f"'-' with linespoints pt {7 if not thin else 6} ps 0.5 lw {1 if thin else 2} dt {2 if thin else 1} lc rgb "
             f"'{COLOURS[colour]}' title '{label}'" for label, (_, colour, thin) in curves.items()]
    lines.append("plot " + ", ".join(parts) + "\n")
    for points, _, _ in curves.values():
        lines += [f"{a} {b}\n" for a, b in points] + ["e\n"]
    done = subprocess.run(["gnuplot"], input="".join(lines), capture_output=True, text=True)
    if done.returncode or not done.stdout:
        raise SystemExit(f"{name}: gnuplot: {done.stderr}")
    (site.out / "pictures").mkdir(parents=True, exist_ok=True)
    (site.out / "pictures" / f"{name}.svg").write_text(pictures.slim(done.stdout, title))
    return f"![{title}](../pictures/{name}.svg)"


def points(rows, x, y):
    found = [(float(r[x]), float(r[y])) for r in rows]
    return [p for p in found if all(math.isfinite(v) and v > 0 for v in p)]


def cheapest(rows, error):
    """Microseconds of the fastest run whose error is not larger, as text; empty where there is none."""
    times = [float(r["microseconds"]) for r in rows if float(r["error"]) <= error]
    return f"{min(times):.0f}" if times else ""


def distinct(rows, column):
    return list(dict.fromkeys(r[column] for r in rows))


def power(eps):
    return f"1e-{round(-math.log10(float(eps)))}"


def perturbed_costs(site):
    rows = read(site, "examples/singular_perturbations/costs.csv")
    every = distinct(rows, "eps")
    table = ["| microseconds to an error of 1e-8 | | " + " | ".join(f"eps = {power(e)}" for e in every) + " |",
             "|---|---|" + "---|" * len(every)]
    drawn = []
    for problem in distinct(rows, "problem"):
        curves = {}
        for solver in distinct(rows, "solver"):
            mine = {e: [r for r in rows if (r["problem"], r["solver"], r["eps"]) == (problem, solver, e)] for e in every}
            table.append(f"| {problem} | {solver} | " + " | ".join(cheapest(mine[e], 1e-8) for e in every) + " |")
            for colour, e in enumerate(every[::2]):
                curves[f"{solver}, eps = {power(e)}"] = (points(mine[e], "error", "microseconds"), colour, solver != "stagecraft")
        drawn.append(draw(site, "perturbed_" + problem.replace(" ", "_"), f"{problem}: time over error, for four eps", "error",
                          "time / microseconds", curves, reverse=True))
    return "\n".join(table) + "\n\n" + "\n\n".join(drawn)


def perturbed_orders(site):
    rows = read(site, "examples/singular_perturbations/orders.csv")
    drawn = []
    for method in distinct(rows, "method"):
        curves = {}
        for colour, e in enumerate(distinct(rows, "eps")[:4]):
            mine = [r for r in rows if (r["method"], r["eps"]) == (method, e)]
            curves[f"z, eps = {power(e)}"] = (points(mine, "h", "error of z"), colour, False)
            curves[f"y, eps = {power(e)}"] = (points(mine, "h", "error of y"), colour, True)
        drawn.append(draw(site, "perturbed_orders_" + method.replace(" ", "_").replace("=", ""),
                          f"{method}: error over step size, the enzyme behind its layer", "h", "error", curves))
    return "\n\n".join(drawn)


def every_kind(site):
    rows = read(site, "examples/every_kind/times.csv")
    errors = ["1e-4", "1e-6", "1e-8", "1e-10"]
    table = ["| kind | problem | method | unknowns | " + " | ".join(f"microseconds to {e}" for e in errors) + " |",
             "|---|---|---|---|" + "---|" * len(errors)]
    curves = {}
    for colour, kind in enumerate(distinct(rows, "kind")):
        mine = [r for r in rows if r["kind"] == kind]
        said = " | ".join(mine[0][c] for c in ("kind", "problem", "method", "unknowns"))
        table.append(f"| {said} | " + " | ".join(cheapest(mine, float(e)) for e in errors) + " |")
        curves[kind] = (points(mine, "error", "microseconds"), colour, False)
    return "\n".join(table) + "\n\n" + draw(site, "every_kind", "Time over error, one problem of each kind", "error",
                                            "time / microseconds", curves, reverse=True)


def tables(site):
    return {"every_kind": every_kind(site), "perturbed_costs": perturbed_costs(site), "perturbed_orders": perturbed_orders(site)}
