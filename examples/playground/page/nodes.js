"use strict";
// The view "Collocation": nodes on a line.
const nodes_view = (() => {
  const $ = (id) => document.getElementById(id);
  let answer = null;  // the engine's last
  let zoom = 1;

  const list = () => state.nodes.split(",").map((text) => text.trim()).filter(Boolean);
  const most = () => Math.max(1, Math.min(1000, Math.round(Number($("denominator").value)) || 24));

  function set(nodes) {
    state.nodes = nodes.join(",");
    $("node-text").value = state.nodes;
    draw();
    judge();
  }

  /// Moves node k next to x, to a fraction that no other node has.
  function put(k, x, step = 0) {
    const nodes = list(), taken = nodes.map(value_of);
    let at = nearest_fraction(Math.max(0, Math.min(1, x)), most());
    if (taken.some((y, i) => i !== k && Math.abs(y - at[0] / at[1]) < 1e-9)) {
      if (!step) return;
      at = nearest_fraction(Math.max(0, Math.min(1, x + step)), most());
      if (taken.some((y, i) => i !== k && Math.abs(y - at[0] / at[1]) < 1e-9)) return;
    }
    nodes[k] = fraction_text(at);
    if (nodes[k] !== list()[k]) set(nodes);
  }

  const margin = 18;

  function draw() {
    const width = $("line").clientWidth || 600, X = (c) => margin + (width - 2 * margin) * c;
    const focused = document.activeElement?.dataset?.node;
    const nodes = list();
    const picture = svg("svg", {viewBox: `0 0 ${width} 64`, class: "line"},
      svg("line", {x1: X(0), y1: 30, x2: X(1), y2: 30}),
      ...[0, 0.25, 0.5, 0.75, 1].flatMap((x) => [svg("line", {x1: X(x), y1: 25, x2: X(x), y2: 35}),
        svg("text", {x: X(x), y: 56}, `${x}`)]),
      ...nodes.map((text, k) => {
        const c = value_of(text);
        const handle = svg("circle", {cx: X(c), cy: 30, r: 11, tabindex: 0, role: "slider", "data-node": k,
          "aria-label": `node ${k + 1}`, "aria-valuemin": 0, "aria-valuemax": 1, "aria-valuenow": c, "aria-valuetext": text});
        handle.addEventListener("keydown", (e) => {
          const by = {ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -6, PageUp: 6}[e.key];
          if (!by) return;
          e.preventDefault();
          put(k, c + by / most(), by / most());
        });
        handle.addEventListener("pointerdown", (e) => drag(e, k, picture));
        return handle;
      }));
    $("line").replaceChildren(picture);
    if (focused !== undefined) $("line").querySelector(`[data-node="${focused}"]`)?.focus();
  }

  /// Follows the pointer until it is released. The line is drawn anew meanwhile, so the window listens.
  function drag(e, k) {
    e.preventDefault();
    $("line").querySelector(`[data-node="${k}"]`).focus();
    const follow = (move) => {
      const box = $("line").firstChild.getBoundingClientRect();
      put(k, (move.clientX - box.left - margin) / (box.width - 2 * margin));
    };
    const release = () => {
      removeEventListener("pointermove", follow);
      removeEventListener("pointerup", release);
      removeEventListener("pointercancel", release);
    };
    addEventListener("pointermove", follow);
    addEventListener("pointerup", release);
    addEventListener("pointercancel", release);
  }

  async function judge() {
    write_state();
    const asked = state.nodes;
    const found = await engine.ask("nodes", "collocate", asked);
    if (!found) return;
    if (asked === state.nodes) {
      $("node-error").textContent = (found.error ?? "").replace(/^--nodes: /, "nodes: ");
      $("node-error").hidden = !found.error;
      $("node-text").setAttribute("aria-invalid", String(Boolean(found.error)));
      for (const id of ["node-certificate", "node-tableau"]) $(id).classList.toggle("stale", Boolean(found.error));
      $("node-region").parentNode.classList.toggle("stale", Boolean(found.error));
    }
    if (found.error) return;
    answer = found;
    $("node-certificate").replaceChildren(theorem_certificate(answer.certificate));
    $("node-tableau").replaceChildren(tableau_table(answer.tableau));
    redraw();
  }

  function redraw() {
    if (!answer || state.view !== "nodes") return;
    const {numerator, denominator} = answer.certificate.stability_function, poles = answer.certificate.poles ?? [];
    const r = {numerator: numerator.map(value_of), denominator: denominator.map(value_of)};
    $("node-region").parentNode.hidden = false;
    draw_region($("node-region"), $("node-caption"), r, zoom * natural_window(r, poles), poles);
  }

  function add() {
    const nodes = list(), sorted = [0, ...nodes.map(value_of).sort((x, y) => x - y), 1];
    if (nodes.length >= 30) return;
    let widest = 0;  // the new node stands in the middle of the widest gap
    for (let k = 1; k + 1 < sorted.length; ++k) if (sorted[k + 1] - sorted[k] > sorted[widest + 1] - sorted[widest]) widest = k;
    const at = fraction_text(nearest_fraction((sorted[widest] + sorted[widest + 1]) / 2, Math.max(most(), 48)));
    if (!nodes.includes(at)) set([...nodes, at]);
  }

  async function take_family() {
    const [family, stages] = $("node-family").value.split(" ");
    if (!family) return;
    const member = await engine.ask("family", "family", family, stages);
    if (member && !member.error) set(member.tableau.c.map((c) => c.replaceAll(" ", "")));
  }

  return {
    listen() {
      $("node-text").addEventListener("input", () => { state.nodes = $("node-text").value; draw(); judge(); });
      for (const button of $("node-region").parentNode.querySelectorAll("[data-zoom]"))
        button.addEventListener("click", () => { zoom *= Number(button.dataset.zoom); redraw(); });
      $("node-region").parentNode.querySelector("[data-star]").addEventListener("change", redraw);
      $("add-node").addEventListener("click", add);
      $("drop-node").addEventListener("click", () => { if (list().length > 1) set(list().slice(0, -1)); });
      $("node-family").addEventListener("change", take_family);
      $("to-tableau").addEventListener("click", () => { if (answer) open_view("tableau", () => tableau_view.open(answer.tableau)); });
    },
    show() { $("node-text").value = state.nodes; draw(); judge(); },
    redraw() { draw(); redraw(); },
  };
})();
