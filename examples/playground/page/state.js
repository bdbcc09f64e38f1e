"use strict";
// All that is on the page stands in its address, behind the #, so that a link is enough to show it to somebody.
const state = {view: "tableau", text: "", decimals: "auto", nodes: "1/6,2/3,1", kind: "order", seed: "1"};

const allowed_state = {
  view: (x) => ["tableau", "nodes", "exercise"].includes(x),
  text: () => true,
  decimals: (x) => ["auto", "exact", "rounded"].includes(x),
  nodes: () => true,
  kind: (x) => /^[a-z-]{1,40}$/.test(x),
  seed: (x) => /^\d{1,10}$/.test(x),
};
const shown_by = {tableau: ["text", "decimals"], nodes: ["nodes"], exercise: ["kind", "seed"]};

/// Takes over what the address says; what is wrong with it, or nothing.
function read_state(fragment) {
  if (!fragment || fragment === "#") return "";
  for (const [key, value] of new URLSearchParams(fragment.slice(1))) {
    if (!Object.hasOwn(allowed_state, key)) return `the address of this page has '${key}', which says nothing here`;
    if (!allowed_state[key](value)) return `the address of this page has '${key}=${value}', which is not possible`;
    state[key] = value;
  }
  return "";
}

function write_state() {
  const words = new URLSearchParams({view: state.view});
  for (const key of shown_by[state.view]) words.set(key, state[key]);
  const fragment = `#${words}`;
  if (fragment !== location.hash) history.replaceState(null, "", fragment);
}
