"use strict";
// All that is on the page stands in its address, behind the #, so that a link is enough to show it to somebody.
const state = {view: "tableau", text: "", decimals: "auto", nodes: "1/6,2/3,1", kind: "order", seed: "1",
  show: "solution", problem: "van_der_pol", method: "radau_iia 3", parameter: "", end: "", tolerance: "1e-6", step: "", across: "", h: "2.2"};
const is_number = (x) => /^[-+.\deE]{0,24}$/.test(x);

const allowed_state = {
  view: (x) => ["tableau", "nodes", "integrate", "exercise"].includes(x),
  text: () => true,
  decimals: (x) => ["auto", "exact", "rounded"].includes(x),
  nodes: () => true,
  kind: (x) => /^[a-z-]{1,40}$/.test(x),
  seed: (x) => /^\d{1,10}$/.test(x),
  show: (x) => ["solution", "errors", "ghosts"].includes(x),
  problem: (x) => /^\w{1,40}$/.test(x),
  method: (x) => /^\w{1,60}( \d)?$/.test(x),
  parameter: is_number,
  end: is_number,
  tolerance: is_number,
  step: is_number,
  across: (x) => /^(t|\d{1,2})?$/.test(x),
  h: (x) => /^[\d./]{1,24}$/.test(x),
};
const of_runs = {solution: ["problem", "method", "parameter", "end", "tolerance", "step", "across"],
                 errors: ["problem", "method", "parameter", "end"], ghosts: ["method", "h"]};

/// What of the state is on the page. Of a run, what is left out is what the problem has by itself.
function shown() {
  const runs = ["show", ...of_runs[state.show]].filter((key) => state[key] !== "");
  return {tableau: ["text", "decimals"], nodes: ["nodes"], exercise: ["kind", "seed"],
          integrate: state.method === "own" ? [...runs, "text"] : runs}[state.view];
}

/// Takes over what the address says; what is wrong with it, or nothing.
function read_state(fragment) {
  if (!fragment || fragment === "#") return "";
  for (const key of ["parameter", "end", "step", "across"]) state[key] = "";
  for (const [key, value] of new URLSearchParams(fragment.slice(1))) {
    if (!Object.hasOwn(allowed_state, key)) return `the address of this page has '${key}', which says nothing here`;
    if (!allowed_state[key](value)) return `the address of this page has '${key}=${value}', which is not possible`;
    state[key] = value;
  }
  return "";
}

function write_state() {
  const words = new URLSearchParams({view: state.view});
  for (const key of shown()) words.set(key, state[key]);
  const fragment = `#${words}`;
  if (fragment !== location.hash) history.replaceState(null, "", fragment);
}
