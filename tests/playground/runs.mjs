// What the playground integrates: end states against solutions in quadruple precision and closed forms, slopes against
// published orders, ghosts against closed forms. runs.mjs ENGINE
import assert from "node:assert/strict";
import {readFileSync, readdirSync} from "node:fs";
import {createRequire} from "node:module";
import {resolve} from "node:path";

const module = await createRequire(import.meta.url)(resolve(process.argv[2]))();
const call = (name, ...words) =>
  JSON.parse(module.ccall(`stagecraft_${name}`, "string", words.map(() => "string"), words));
const published = (name) => readFileSync(`tableaux/catalogue/${name}.json`, "utf8");
const stored = (name) => JSON.parse(readFileSync(`examples/problems/data/${name}.json`, "utf8")).y_end.map(Number);
const problems = call("problems");
const standard = (name) => `${problems.find((p) => p.name === name).parameter?.standard ?? ""}`;
function state_at_end(method, problem, t1, tolerance, parameter = standard(problem)) {
  const run = call("run", method, problem, parameter, `${t1}`, `${tolerance}`, "");
  assert.equal(run.status, "success", `${method} ${problem}`);
  assert.ok(run.points.length <= 4001 && run.points.every((row) => row.every(Number.isFinite)));
  assert.equal(run.steps.length, run.report.steps);
  assert.equal(run.steps.reduce((sum, s) => sum + s[2], 0), run.report["refused for the error"]);
  const [t, ...y] = run.points.at(-1);
  assert.equal(t, Number(t1));
  return y;
}
/// Relative to the size of each component.
function near(y, exact, tolerance, what) {
  exact.forEach((x, i) => assert.ok(Math.abs(y[i] - x) <= tolerance * Math.max(Math.abs(x), 1e-12), `${what}: ${y[i]} for ${x}`));
}

// The solutions are stored in quadruple precision; a run's error is the tolerance times what the problem makes of it.
near(state_at_end("radau_iia 5", "van_der_pol", 2, 1e-10, "1e-6"), stored("vdpol"), 1e-6, "van der Pol");
near(state_at_end("radau_iia 3", "robertson", "1e11", 1e-8), stored("rober"), 1e-4, "Robertson");
near(state_at_end("radau_iia 5", "oregonator", 360, 1e-10), stored("orego"), 1e-6, "Oregonator");
near(state_at_end("gauss 4", "hires", 321.8122, 1e-10), stored("hires"), 1e-5, "HIRES");
near(state_at_end(published("dormand_prince_8_5_3"), "kepler", 20, 1e-11), stored("kepler"), 1e-7, "Kepler");
near(state_at_end(published("dormand_prince_5_4"), "lorenz", 10, 1e-11), stored("lorenz"), 1e-5, "Lorenz");
const orbit = state_at_end(published("dormand_prince_8_5_3"), "arenstorf", 17.0652165601579625588917206249, 1e-12);
near([orbit[0], orbit[3]], [0.994, stored("arenstorf")[3]], 1e-3, "Arenstorf's orbit is closed");
const disc = JSON.parse(readFileSync("examples/problems/rolling_disc/data/disc.json", "utf8"))["t=0.5"].values.map(Number);
near(state_at_end("radau_iia 3", "rolling_disc", 0.5, 1e-10), disc, 1e-5, "disc");

// Released where it is level, a pendulum of length 1 and g = 1 is there again after 4 K(1/sqrt 2) = Gamma(1/4)^2/sqrt(pi).
const period = 7.416298709205488;
for (const problem of ["pendulum_3", "pendulum_2"])
  assert.ok(Math.abs(state_at_end("radau_iia 3", problem, period, 1e-9)[0] - 1) < 1e-6, problem);
// From a small angle both rods swing in two modes, of frequencies w with w^2 = 2 -+ sqrt 2, in which the second angle is +- sqrt 2
// times the first; from a large one the energy stays.
const angle = 1e-2 * Math.PI / 180, t_end = 20, root = Math.SQRT2;
const modes = [-1, 1].map((side) => (1 - side / root) / 2 * angle * Math.cos(Math.sqrt(2 + side * root) * t_end));
near(state_at_end("gauss 3", "double_pendulum", t_end, 1e-12, "0.01").slice(0, 2),
     [modes[0] + modes[1], root * (modes[0] - modes[1])], 1e-6, "double pendulum");
const [alpha, beta, u, v] = state_at_end("gauss 3", "double_pendulum", t_end, 1e-10);
const energy = u * u + v * v / 2 + u * v * Math.cos(alpha - beta) - 2 * Math.cos(alpha) - Math.cos(beta);
assert.ok(Math.abs(energy - 1.5) < 1e-7, `energy ${energy} of the double pendulum`);
for (const {name, t1} of problems) state_at_end("radau_iia 3", name, t1, 1e-6);  // all of them arrive

// Equal steps: the slopes are the orders of HLR89, table 2.3, Jay 1993 and of Prothero and Robinson.
function slopes(method, problem, steps, parameter = standard(problem)) {
  const {order_t1} = problems.find((p) => p.name === problem);
  const [a, b] = [steps, 2 * steps].map((n) => call("error", method, problem, parameter, `${order_t1}`, `${n}`));
  assert.equal(b.status, "success");
  return Object.fromEntries(Object.keys(a.errors).map((k) => [k, Math.log2(a.errors[k] / b.errors[k])]));
}
const expected = [
  [published("explicit_euler"), "lotka_volterra", 2048, {1: 1}], [published("heun_2"), "lotka_volterra", 512, {1: 2}],
  [published("classical_rk4"), "kepler", 512, {1: 4}], [published("dormand_prince_5_4"), "kepler", 256, {1: 5}],
  ["gauss 2", "brusselator", 64, {1: 4}], ["gauss 3", "logistic", 8, {1: 6}], ["radau_iia 3", "lotka_volterra", 32, {1: 5}],
  ["radau_iia 2", "index_two", 32, {1: 3, 2: 2}], ["radau_iia 3", "index_two", 16, {1: 5, 2: 3}],
  ["lobatto_iiic 3", "index_two", 32, {1: 4, 2: 2}], ["radau_iia 2", "index_three", 64, {1: 3, 2: 2, 3: 1}],
  ["radau_iia 3", "pendulum_2", 16, {1: 5, 2: 3}]];
for (const [method, problem, n, orders] of expected) {
  const found = slopes(method, problem, n);
  assert.deepEqual(Object.keys(found), Object.keys(orders));
  for (const k of Object.keys(orders))
    assert.ok(Math.abs(found[k] - orders[k]) < 0.3, `${method.slice(0, 30)} ${problem}, index ${k}: ${found[k]} for ${orders[k]}`);
}
// Gauss methods fall to their stage order where the problem is stiff (Hairer, Wanner II, IV.15), and are of order 6 where not.
assert.ok(slopes("gauss 3", "prothero_robinson", 16, "1e6")[1] < 4.3);
assert.ok(slopes("gauss 3", "prothero_robinson", 16, "1")[1] > 5.7);

// Ghosts of the explicit midpoint rule on y' = y (1 - y): y + h/2 f(y) is 0 or 1 at 1 + 2/h and at 2/h.
const close = (a, b) => assert.ok(Math.abs(a - b) < 1e-9, `${a} is not ${b}`);
for (const [text, h] of [["1/2", 0.5], ["2.5", 2.5], ["3", 3]]) {
  const {fixed} = call("ghosts", published("explicit_midpoint"), text);
  assert.equal(fixed.verdict, "proved");
  const ghosts = fixed.points.filter((p) => !p.equilibrium).map((p) => p.x);
  [2 / h, 1 + 2 / h].sort((a, b) => a - b).forEach((x, k) => close(ghosts[k], x));
  assert.equal(ghosts.length, 2);
  assert.deepEqual(fixed.points.filter((p) => p.equilibrium).map((p) => Math.round(p.x)), [0, 1]);
}
// Euler's method: 1 attracts for h < 2, then (2 + h +- sqrt(h^2 - 4))/(2h) of period two, up to sqrt 6.
for (const [text, h] of [["2.2", 2.2], ["2.6", 2.6]]) {
  const {fixed, cycles} = call("ghosts", published("explicit_euler"), text);
  assert.deepEqual(fixed.points.map((p) => [p.x, p.equilibrium, p.attracting]), [[0, true, false], [1, true, false]]);
  const exact = [-1, 1].map((side) => (2 + h + side * Math.sqrt(h * h - 4)) / (2 * h));
  exact.forEach((x, k) => close(cycles.points[k].x, x));
  assert.ok(cycles.points.every((p) => p.attracting === h < Math.sqrt(6)));
  const [[, ...seen]] = call("orbits", published("explicit_euler"), text, text, "1");
  if (h < Math.sqrt(6)) exact.forEach((x) => assert.ok(seen.some((y) => Math.abs(y - x) < 1e-4)));
  else assert.ok(seen.length > 8);
}
assert.deepEqual(call("ghosts", published("explicit_euler"), "1.9").cycles.points, []);
assert.deepEqual(call("orbits", published("explicit_euler"), "1.5", "1.5", "1")[0].slice(1), [1]);
assert.deepEqual(call("orbits", "gauss 2", "1.5", "1.5", "1")[0].slice(1), [1]);

// A method of the visitor's; what cannot be used says so.
const own = "A = [0 0; 2//3 0]\nb = [1//4, 3//4]";
assert.ok(Math.abs(slopes(own, "logistic", 64)[1] - 2) < 0.1);
assert.equal(call("run", own, "logistic", "", "5", "1e-5", "").status, "success");  // by step doubling
const blown = call("run", published("explicit_euler"), "van_der_pol", "1e-6", "2", "", "0.1");
assert.notEqual(blown.status, "success");
for (const [words, said] of [
  [["run", "radau_iia 12", "kepler", "", "1", "1e-6", ""], /stages: '12' is not a whole number/],
  [["run", "radau_iia 3", "keppler", "", "1", "1e-6", ""], /problem: 'keppler' is none/],
  [["run", "radau_iia 3", "kepler", "", "x", "1e-6", ""], /to t: 'x' is not a number/],
  [["run", "radau_iia 3", "kepler", "", "1", "0", ""], /tolerance: '0' is not a number from/],
  [["run", "radau_iia 3", "kepler", "", "1", "1e-6", "-1"], /step: '-1' is not a number/],
  [["run", "radau_iia 3", "van_der_pol", "nan", "1", "1e-6", ""], /ε: 'nan' is not a number/],
  [["run", "{", "kepler", "", "1", "1e-6", ""], /./], [["run", published("explicit_euler"), "index_two", "", "1", "1e-6", ""], /singular|explicit|implicit/],
  [["error", "gauss 2", "kepler", "", "1", "0"], /steps: '0' is not a whole number/],
  [["ghosts", published("gauss_2"), "1"], /./], [["ghosts", published("implicit_euler"), "1"], /must be explicit/],
  [["ghosts", published("explicit_euler"), "0"], /h/], [["orbits", "gauss 2", "0", "1", "5"], /low/]])
  assert.match(call(...words).error ?? "no error", said, words.slice(0, 1).concat(words.slice(2)).join(" "));
console.log(`runs: ${problems.length} problems`);
