"use strict";
// What the views share: tabs, the bar of work, choices, the address.
const methods = JSON.parse(document.getElementById("methods").textContent || "{}");
const views = {tableau: tableau_view, nodes: nodes_view, integrate: integrate_view, exercise: exercises_view};

/// Shows a view; `fill` instead of what it shows by itself.
function open_view(name, fill = () => views[name].show()) {
  state.view = name;
  for (const other of Object.keys(views)) {
    document.getElementById(other).hidden = other !== name;
    const tab = document.getElementById(`tab-${other}`);
    tab.setAttribute("aria-selected", String(other === name));
    tab.tabIndex = other === name ? 0 : -1;
  }
  fill();
}

function fill_choices({families, exercises}) {
  const option = (value, text = value, title = "") => element("option", {value, title}, text);
  document.getElementById("family").append(...families.map((f) => option(f.name, f.name.replaceAll("_", " "))));
  document.getElementById("family").addEventListener("change", (e) => {
    document.getElementById("stages").min = families.find((f) => f.name === e.target.value).least;
  });
  document.getElementById("node-family").append(...["gauss", "radau_ii", "radau_i", "lobatto_iiia"].flatMap((name) =>
    [1, 2, 3, 4, 5].filter((s) => s >= families.find((f) => f.name === name).least && s <= (name === "lobatto_iiia" ? 5 : 3))
      .map((s) => option(`${name} ${s}`, `${name.replaceAll("_", " ")}, ${s}`))));
  document.getElementById("kind").append(...exercises.map((k) => option(k.name, k.name.replaceAll("-", " "), k.asks)));
}

function start() {
  const $ = (id) => document.getElementById(id);
  $("catalogue").append(...Object.keys(methods).sort((x, y) => methods[x].name.localeCompare(methods[y].name))
    .map((key) => element("option", {value: key}, methods[key].name)));
  const tabs = Object.keys(views).map((name) => $(`tab-${name}`));
  tabs.forEach((tab, k) => {
    tab.addEventListener("click", () => open_view(tab.id.slice(4)));
    tab.addEventListener("keydown", (e) => {
      const step = {ArrowLeft: -1, ArrowRight: 1}[e.key];
      if (!step) return;
      const next = tabs[(k + step + tabs.length) % tabs.length];
      next.focus();
      next.click();
    });
  });
  Object.values(views).forEach((view) => view.listen());

  let busy;
  engine.watch((running) => {  // what takes no time need not flicker
    clearTimeout(busy);
    document.body.toggleAttribute("aria-busy", running);
    if (running) busy = setTimeout(() => { $("status").textContent = "deciding …"; $("cancel").hidden = false; }, 250);
    else { $("status").textContent = ""; $("cancel").hidden = true; }
  });
  $("cancel").addEventListener("click", () => engine.cancel());
  $("limit").addEventListener("change", (e) => { engine.limit = Number(e.target.value); });
  $("share").addEventListener("click", async () => {
    write_state();
    try {
      await navigator.clipboard.writeText(location.href);
      $("status").textContent = "copied";
    } catch {
      $("status").textContent = "the address line has the link";
    }
  });
  let timer;
  const redraw = () => { clearTimeout(timer); timer = setTimeout(() => views[state.view].redraw(), 100); };
  addEventListener("resize", redraw);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
  addEventListener("hashchange", arrive);
  arrive();
  engine.ask("choices", "choices").then((choices) => {
    if (choices.error) return notice(choices.error);
    fill_choices(choices);
    exercises_view.name_kind();
  });
  engine.ask("problems", "problems").then((problems) => (problems.error ? notice(problems.error) : integrate_view.take(problems)));
}

function notice(line) {
  const place = document.getElementById("notice");
  place.textContent = line;
  place.hidden = !line;
}

/// The page as its address says; an empty one, which says why, where the address makes no sense.
function arrive() {
  const fault = read_state(location.hash);
  if (fault) Object.assign(state, {view: "tableau", text: "", decimals: "auto", parameter: "", end: "", tolerance: "1e-6", step: "", h: "2.2"});
  notice(fault && `${fault}; so this page is empty`);
  open_view(state.view, fault || location.hash ? undefined : () => tableau_view.open(methods.classical_rk4));
}

start();
