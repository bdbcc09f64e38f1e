"use strict";
// The view "Integration": runs of the library's steppers, their errors against the step size, and ghosts.
const integrate_view = (() => {
  const $ = (id) => document.getElementById(id);
  const families = [["radau_iia", [1, 2, 3, 4, 5]], ["gauss", [1, 2, 3, 4, 5]], ["lobatto_iiic", [2, 3, 4]],
                    ["radau_ia", [1, 2, 3]], ["lobatto_iiia", [2, 3, 4]], ["lobatto_iiib", [2, 3, 4]]];
  const meanings = {too_many_steps: "20000 steps were not enough",
    step_underflow: "the steps became too small: a singularity, or a method that does not suit",
    newton_failed: "the equations of the stages were not solved",
    non_finite: "the numbers left every bound", singular_matrix: "the matrix of the stages is singular"};
  let problems = null;  // as the engine lists them
  let figures = [], round = 0;  // what is asked in an earlier round is not shown any more
  let diagram = {method: null, columns: []};

  const kind = () => problems?.find((p) => p.name === state.problem);
  const chosen = (key, standard) => (state[key] === "" ? `${standard}` : state[key]);
  const parameter = () => chosen("parameter", kind().parameter?.standard ?? "");
  const end = () => chosen("end", short(state.show === "errors" ? kind().order_t1 : kind().t1));
  const short = (x) => (x < 1e6 ? `${x}` : x.toExponential().replace("+", ""));

  /// What the engine reads as the method; empty where there is none of that name.
  function method_text() {
    if (state.method === "own") return state.text;
    if (Object.hasOwn(methods, state.method)) return JSON.stringify(methods[state.method]);
    return families.some(([name, stages]) => stages.some((s) => `${name} ${s}` === state.method)) ? state.method : "";
  }
  const family_name = (name) => words_of(name).replace(/ i+[abc]?$/, (number) => number.toUpperCase());
  const method_name = () => [...$("method").options].find((o) => o.value === state.method)?.textContent ?? state.method;

  function complain(line) {
    $("integrate-error").textContent = line;
    $("integrate-error").hidden = !line;
    for (const [id, word] of [["parameter", kind()?.parameter?.name], ["end", "to t"], ["tolerance", "tolerance"], ["step", "step"],
                               ["h-text", "h"]])
      $(id).setAttribute("aria-invalid", String(Boolean(word) && line.startsWith(`${word}:`)));
  }

  function show_figures(list) {
    figures = list;
    $("curves").replaceChildren(...list);
    list.forEach((f) => f.redraw());
  }

  function facts(rows) {
    $("run-facts").replaceChildren(element("table.numbers", {}, element("tbody", {}, ...rows.map(([what, value]) =>
      element("tr", {}, element("th", {scope: "row"}, what), element("td", {}, value))))));
  }

  /// The fields as the state has them; those that say nothing here are hidden.
  function show_fields() {
    const p = kind();
    for (const part of document.querySelectorAll("[data-for]"))
      part.hidden = !part.dataset.for.split(" ").includes(state.show);
    for (const button of document.querySelectorAll("[data-show]"))
      button.setAttribute("aria-pressed", String(button.dataset.show === state.show));
    $("problem").value = state.problem;
    $("method").value = state.method;
    $("tolerance").value = state.tolerance;
    $("step").value = state.step;
    $("h").value = $("h-text").value = state.h;
    if (!p) return;
    $("equations").textContent = state.show === "ghosts" ? "y′ = y (1 − y), whose equilibria are 0 and 1; all other points are on the way"
      : `${p.equations}  (${p.source})`;
    $("parameter-label").hidden = state.show === "ghosts" || !p.parameter;
    $("parameter-name").textContent = p.parameter ? `${p.parameter.name} =` : "";
    if (document.activeElement !== $("parameter")) $("parameter").value = p.parameter ? parameter() : "";
    if (document.activeElement !== $("end")) $("end").value = end();
    $("across").replaceChildren(...["t", ...p.components].map((c, k) => element("option", {value: k ? `${k - 1}` : "t"}, c)));
    $("across").value = across(p);
  }

  /// What is drawn upon: "t" or the number of a component.
  function across(p) {
    if (state.across === "t" || p.components[state.across]) return state.across;
    return p.across >= 0 ? `${p.across}` : "t";
  }

  /// The components against time, or one against another.
  function solution_figure(p, answer) {
    const x = across(p), points = answer.points.filter((row) => row.every(Number.isFinite));
    const pick = (k) => points.map((row) => row[k + 1]);
    const other = p.up >= 0 && `${p.up}` !== x ? p.up : Number(x) ? 0 : Math.min(1, p.components.length - 1);
    const shown = x === "t" ? p.components.map((_, k) => k).slice(0, 8) : [other];
    const values = shown.flatMap(pick), positive = values.filter((v) => v > 0);
    const span = span_of(positive, true), wide = x === "t" && span.high > 1e4 * span.low && positive.length > 0.9 * values.length;
    const log_x = x === "t" && p.decades, xs = x === "t" ? points.map((row) => row[0]) : pick(Number(x));
    const series = shown.map((k, i) => ({kind: "line", style: `c${i}`, points: points.map((row, n) =>
      [log_x && xs[n] <= 0 ? NaN : xs[n], wide && row[k + 1] <= 0 ? NaN : row[k + 1]])}));
    const names = shown.map((k) => p.components[k]);
    const x_axis = {log: log_x, title: x === "t" ? "t" : p.components[x], ...span_of(xs, log_x)};
    const y_axis = {log: wide, title: names.join(", "), ...span_of(values, wide)};
    if (x === "t" && !log_x) [x_axis.low, x_axis.high] = [0, xs[xs.length - 1] || 1];
    const ends = x !== "t" || answer.steps.length > 150 ? [] : [ends_of_steps(answer, points, shown, log_x, wide)];
    return figure(x === "t" ? "Solution" : `${names[0]} against ${p.components[x]}`,
      [...names.map((name, i) => [`c${i}`, name]), ...(ends.length ? [["ends", "ends of steps", "dots"]] : [])],
      ["t", ...p.components], () => points,
      (place) => chart(place, `${p.title}: ${names.join(", ")} against ${x_axis.title} by ${method_name()}`,
        x_axis, y_axis, [...series, ...ends]));
  }

  function ends_of_steps(answer, points, shown, log_x, wide) {
    const times = new Set(answer.steps.map(([t]) => t));
    const at_ends = points.filter(([t]) => times.has(t) && (!log_x || t > 0));
    const points_of = (k) => at_ends.map((row) => [row[0], wide && row[k + 1] <= 0 ? NaN : row[k + 1]]);
    return {kind: "dots", style: "ends", points: shown.flatMap(points_of)};
  }

  function steps_figure(p, {steps}) {
    const log_x = p.decades, x = {log: log_x, title: "t", ...span_of(log_x ? steps.map(([t]) => t) : [0, ...steps.map(([t]) => t)], log_x)};
    if (!log_x) [x.low, x.high] = [0, steps[steps.length - 1]?.[0] || 1];
    const sizes = steps.map(([, h]) => h), y = {log: true, title: "h", ...span_of(sizes, true)};
    const start = ([t, h]) => (log_x ? t : t - h), refused = (k) => steps.filter((s) => s[k] > 0).map((s) => [start(s), s[1]]);
    const series = [{kind: "line", style: "c0", points: steps.flatMap((s) => (log_x ? [[s[0], s[1]]] : [[start(s), s[1]], [s[0], s[1]]]))},
      {kind: "crosses", style: "refused", points: refused(2)}, {kind: "crosses", style: "unsolved", points: refused(3)}];
    const marks = [["refused", "behind steps refused for their error", "crosses"],
                   ["unsolved", "behind steps whose stages were not solved", "crosses"]];
    return figure("Step sizes", [["c0", "taken"], ...marks.filter((_, k) => series[k + 1].points.length)],
      ["t", "h", "refused for the error", "refused by Newton"],
      () => steps, (place) => chart(place, `${steps.length} steps of ${method_name()}, their sizes against t`, x, y, series));
  }

  async function solution(mine) {
    const p = kind();
    const answer = await engine.ask("run", "run", method_text(), p.name, parameter(), end(), state.tolerance, state.step);
    if (!answer || mine !== round) return;
    complain(answer.error ?? "");
    $("curves").classList.toggle("stale", Boolean(answer.error));
    if (answer.error) return;
    const why = answer.status === "success" ? "" : `: ${answer.status.replaceAll("_", " ")}, ${meanings[answer.status] ?? ""}`;
    facts([["ended", `at t = ${answer.t}${why}`], ...Object.entries(answer.report)]);
    const moving = motion_figure(p, answer.points.filter((row) => row.every(Number.isFinite)));
    show_figures([solution_figure(p, answer), ...(moving ? [moving] : []), steps_figure(p, answer)]);
  }

  /// The order that is proved of the method, where there is one.
  async function proved_order() {
    const [family, stages] = state.method.split(" ");
    if (stages) return (await engine.ask("order", "family", family, stages))?.certificate?.order?.value ?? null;
    const order = (await engine.ask("order", "certify", method_text(), "auto", "auto"))?.order;
    return order?.verdict === "refuted" ? null : order?.value ?? null;
  }

  async function errors(mine) {
    const p = kind(), found = [];
    complain("");
    const order = await proved_order();
    for (let n = 4; n <= 16384 && mine === round; n *= 2) {
      const answer = await engine.ask("run", "error", method_text(), p.name, parameter(), end(), `${n}`);
      if (!answer || mine !== round) return;
      complain(answer.error ?? "");
      $("curves").classList.toggle("stale", Boolean(answer.error));
      if (answer.error) return;
      const bounded = Object.values(answer.errors).every((e) => e !== null && e < 1e6);
      found.push({...answer, good: answer.status === "success" && bounded});
      show_errors(p, found, order);
      const good = found.filter((f) => f.good), last = good.slice(-2).map((f) => Math.max(...Object.values(f.errors)));
      if (good.length && (last[last.length - 1] < 1e-12 || (last.length > 1 && last[1] < 1e-8 && last[1] > 0.8 * last[0]))) break;
    }
  }

  function show_errors(p, found, order) {
    const groups = Object.keys(found[0].errors), good = found.filter((f) => f.good);
    const name = (g) => (groups.length === 1 ? "error" : `index ${g}`);
    const slope = (k, g) => {
      const [before, after] = [found[k - 1], found[k]];
      return before?.good && after.good ? Math.log2(before.errors[g] / after.errors[g]).toFixed(2) : "";
    };
    const cells = (f, k) => (f.good ? groups.flatMap((g) => [f.errors[g].toExponential(2), slope(k, g)]) : [f.status.replaceAll("_", " ")]);
    const line = (g) => good.map((f) => [f.h, f.errors[g]]);
    const above = good.filter((f) => f.errors[groups[0]] > 1e-10), middle = above[above.length >> 1] ?? good[0];  // of rounding
    const series = groups.map((g, i) => ({kind: "line", style: `c${i}`, points: line(g)}));
    series.push(...groups.map((g, i) => ({kind: "dots", style: `c${i}`, points: line(g)})));
    const entries = groups.map((g, i) => [`c${i}`, name(g)]);
    if (order && middle) {
      series.unshift({kind: "line", style: "order", points: good.map(({h}) => [h, middle.errors[groups[0]] * (h / middle.h) ** order])});
      entries.push(["order", `h${superscript(order)}: the order of the method, proved`]);
    }
    facts([["method", method_name()], ["order, proved", order ?? "none"], ["error", "at the end, of the component with the largest"]]);
    const head = element("tr", {}, ...["h", ...groups.flatMap((g) => [name(g), "slope"])].map((w) => element("th", {scope: "col"}, w)));
    const table = element("div.scroll", {}, element("table.numbers.slopes", {}, element("thead", {}, head), element("tbody", {},
      ...found.map((f, k) => element("tr", {}, ...[f.h.toPrecision(4), ...cells(f, k)].map((x) => element("td", {}, x)))))));
    table.redraw = () => {};
    show_figures([figure("Error against step size", entries, ["h", ...groups.map(name)],
      () => found.map((f) => [f.h, ...groups.map((g) => f.errors[g])]),
      (place) => chart(place, `Error of ${method_name()} at t = ${end()} against the step size, both in powers of ten: ${p.title}`,
        {log: true, title: "h", ...span_of(found.map((f) => f.h), true)},
        {log: true, title: "error", ...span_of(good.flatMap((f) => Object.values(f.errors)), true)}, series)), table]);
  }

  /// Where equal steps go, for all step sizes; once for each method.
  async function orbits(mine) {
    const text = method_text();
    const parts = 10, columns = 36;
    for (let k = diagram.columns.length / columns; k < parts && mine === round; ++k) {
      const at = (part) => `${0.02 + (3.98 * part) / parts}`;
      const answer = await engine.ask("orbits", "orbits", text, at(k), at(k + 1 - 1 / columns), `${columns}`);
      if (!answer || mine !== round) return;
      if (answer.error) return complain(answer.error);
      diagram.columns.push(...answer);
      figures[0]?.redraw();
    }
  }

  const point_style = (x) => `${x.equilibrium ? "equilibrium" : "ghost"}${x.attracting ? "" : " open"}`;

  async function ghosts(mine) {
    const text = method_text(), h = state.h, family = / \d$/.test(state.method);
    if (!(value_of(h) > 0 && value_of(h) <= 100)) return complain(`h: '${h}' is not a fraction or a decimal from 0 to 100`);
    const run = await engine.ask("run", "run", text, "logistic", "", `${60 * value_of(h)}`, "", `${value_of(h)}`);
    if (!run || mine !== round) return;
    $("curves").classList.toggle("stale", Boolean(run.error));
    complain(run.error ?? "");
    if (run.error) return;
    if (diagram.method !== text) diagram = {method: text, columns: []};
    show_ghosts(h, run, {});
    const answer = family ? {} : await engine.ask("ghosts", "ghosts", text, h);
    if (!answer || mine !== round) return;
    const refused = answer.error?.startsWith("method: must be explicit") || family;
    complain(refused ? "" : answer.error ?? "");
    show_points(answer, refused);
    show_ghosts(h, run, answer);
    await orbits(mine);
  }

  function show_ghosts(h, run, answer) {
    const fixed = answer.fixed?.points ?? [], cycles = answer.cycles?.points ?? [], at = value_of(h);
    const steps = run.points.filter(([t]) => Math.abs(t / at - Math.round(t / at)) < 1e-6).map(([t, y]) => [Math.round(t / at), y]);
    const y = {title: "y", low: -0.5, high: 2};
    const runs = () => ({kind: "dots", style: "orbit", points: diagram.columns.flatMap(([u, ...ys]) => ys.map((v) => [u, v]))});
    const mark = (style) => (x) => ({kind: "dots", style: style ?? point_style(x), points: [[at, x.x]]});
    const level = (x) => ({kind: "line", style: point_style(x), points: [[0, x.x], [60, x.x]]});
    show_figures([
      figure("Where equal steps go", [["orbit", "after 300 steps", "dots"], ["equilibrium", "equilibrium", "dots"],
        ["ghost", "ghost", "dots"], ["cycle", "of period 2", "dots"]], ["h", "y..."], () => diagram.columns,
        (place) => chart(place, `States of ${method_name()} after 300 steps against the step size`, {title: "h", low: 0, high: 4}, y,
          [runs(), {kind: "line", style: "order", points: [[at, -9], [at, 9]]}, ...fixed.map(mark()), ...cycles.map(mark("cycle"))])),
      figure(`The run from 1/10 with h = ${h}`, [["c0", "run"], ["equilibrium", "equilibria"], ["ghost", "ghosts"]], ["n", "y"], () => steps,
        (place) => chart(place, `States of ${method_name()} with h = ${h} against the number of the step`, {title: "steps", low: 0, high: 60},
          y, [...fixed.map(level), {kind: "line", style: "c0", points: steps}, {kind: "dots", style: "c0", points: steps}]))]);
  }

  function show_points(answer, refused) {
    if (!answer.fixed) {
      $("run-facts").replaceChildren(element("p.small", {}, refused ?
        "All points that a step does not move are found for explicit methods with rational entries." : ""));
      return;
    }
    const row = (x, what) => element("tr", {}, element("th", {scope: "row"}, `${Number(x.x.toPrecision(8))}`), element("td", {}, what),
      element("td", {}, x.attracting ? "attracts" : ""), element("td", {}, x.multiplier.toPrecision(4)));
    const note = (found, words) => (found.verdict === "proved" ? element("p.small", {}, `${words} `, badge("proved"), " these are all")
      : element("p.small", {}, `${words} not looked for, as the degree of their equation is too high`));
    $("run-facts").replaceChildren(element("div.scroll", {}, element("table.numbers", {}, element("thead", {}, element("tr", {},
      ...["y", "", "", "multiplier"].map((w) => element("th", {scope: "col"}, w)))), element("tbody", {},
      ...answer.fixed.points.map((x) => row(x, x.equilibrium ? "equilibrium" : "ghost")), ...answer.cycles.points.map((x) => row(x, "period 2"))))),
    note(answer.fixed, "Fixed points:"), note(answer.cycles, "Points of period two:"));
  }

  function make() {
    write_state();
    if (state.view !== "integrate" || !problems) return;
    const mine = ++round;
    show_fields();
    if (!kind()) return nothing(`problem: '${state.problem}' is none of those of this page`);
    if (!method_text() && state.method === "own") return nothing("method: there is no tableau in the first view");
    if (!method_text()) return nothing(`method: '${state.method}' is none of those of this page`);
    ({solution, errors, ghosts})[state.show](mine);
  }

  /// Ghosts are those of explicit methods.
  function show_other(name) {
    Object.assign(state, {show: name, end: ""});
    if (name === "ghosts" && / \d$/.test(state.method)) state.method = "explicit_euler";
    make();
  }

  function nothing(line) {
    $("run-facts").replaceChildren();
    show_figures([]);
    complain(line);
  }

  function listen() {
    const group = (label, options) => element("optgroup", {label}, ...options.map(([value, text]) => element("option", {value}, text)));
    $("method").append(element("option", {value: "own"}, "the tableau of the first view"),
      group("Families", families.flatMap(([name, stages]) =>
        stages.map((s) => [`${name} ${s}`, `${family_name(name)}, ${s} ${s > 1 ? "stages" : "stage"}`]))),
      group("Published", Object.keys(methods).filter((key) => methods[key].A).map((key) => [key, methods[key].name])
        .sort(([, x], [, y]) => x.localeCompare(y))));
    for (const button of document.querySelectorAll("[data-show]")) button.addEventListener("click", () => show_other(button.dataset.show));
    $("problem").addEventListener("change", () => {
      Object.assign(state, {problem: $("problem").value, parameter: "", end: "", step: "", across: ""});
      make();
    });
    for (const id of ["method", "across"]) $(id).addEventListener("change", () => { state[id] = $(id).value; make(); });
    for (const id of ["parameter", "end", "tolerance", "step"])
      $(id).addEventListener("input", () => { state[id] = $(id).value.trim(); make(); });
    $("h-text").addEventListener("input", () => { state.h = $("h").value = $("h-text").value.trim(); make(); });
    $("h").addEventListener("input", () => { state.h = $("h-text").value = $("h").value; make(); });
  }

  return {
    listen, show: make,
    redraw() { figures.forEach((f) => f.redraw()); },
    /// The problems that the engine has.
    take(list) {
      problems = list;
      $("problem").append(...list.map((p) => element("option", {value: p.name}, p.title)));
      if (state.view === "integrate") make();
    },
  };
})();
