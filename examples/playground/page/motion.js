"use strict";
// Plane mechanisms that move as a run has them, beside its curves.

/// From a state, the joints from the one that is fixed to the last.
const joints_of = {
  pendulum_3: ([x, y]) => [[0, 0], [x, y]],
  pendulum_2: ([x, y]) => [[0, 0], [x, y]],
  double_pendulum: ([a, b]) => {
    const x = Math.sin(a), y = -Math.cos(a);
    return [[0, 0], [x, y], [x + Math.sin(b), y - Math.cos(b)]];
  },
};

/// The state at t between two rows [t, y...] of a run.
function state_between(rows, t) {
  let low = 0, high = rows.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (rows[middle][0] <= t) low = middle;
    else high = middle;
  }
  const [from, to] = [rows[low], rows[high]], part = to[0] > from[0] ? (t - from[0]) / (to[0] - from[0]) : 0;
  return from.slice(1).map((y, k) => y + part * (to[k + 1] - y));
}

/// A figure with a button to play and a slider for the time; null for problems without joints.
function motion_figure(p, rows) {
  if (!Object.hasOwn(joints_of, p.name) || rows.length < 2) return null;
  const joints = (t) => joints_of[p.name](state_between(rows, t)), end = rows[rows.length - 1][0];
  const paths = rows.map(([, ...y]) => joints_of[p.name](y)), reach = 1.1 * Math.max(...paths.flat(2).map(Math.abs));
  const flat = (points) => points.map(([x, y]) => `${x.toFixed(4)},${(-y).toFixed(4)}`).join(" ");
  const rods = svg("polyline", {class: "rods"}), masses = joints(0).map(() => svg("circle", {class: "mass", r: 0.04 * reach}));
  const trace = svg("polyline", {class: "trace", points: flat(paths.map((points) => points[points.length - 1]))});
  const time = element("input", {type: "range", min: 0, max: end, step: end / 1000, value: 0, "aria-label": "t"});
  const said = element("output"), button = element("button", {}, "Play");
  const show = (t) => {
    const points = joints(t);
    rods.setAttribute("points", flat(points));
    masses.forEach((mass, k) => { mass.setAttribute("cx", points[k][0]); mass.setAttribute("cy", -points[k][1]); });
    said.textContent = ` t = ${t.toFixed(2)}`;
    time.value = t;
  };
  let begun = null;  // when t was 0, in seconds; null while nothing moves
  const frame = (now) => {
    if (begun === null || !whole.isConnected) return;
    show((now / 1000 - begun) % end);
    requestAnimationFrame(frame);
  };
  const stop = () => { begun = null; button.textContent = "Play"; };
  button.addEventListener("click", () => {
    if (begun !== null) return stop();
    begun = performance.now() / 1000 - Number(time.value);
    button.textContent = "Pause";
    requestAnimationFrame(frame);
  });
  time.addEventListener("input", () => { stop(); show(Number(time.value)); });
  const picture = svg("svg", {class: "motion", viewBox: `${-reach} ${-reach} ${2 * reach} ${2 * reach}`, role: "img",
    "aria-label": `${p.title}: its rods at the time of the slider, and the way of its end`}, trace, rods, ...masses);
  const whole = element("figure.plot", {}, element("h3", {}, "In motion"), picture, element("p.row", {}, button, time, said));
  whole.redraw = () => {};
  show(0);
  return whole;
}
