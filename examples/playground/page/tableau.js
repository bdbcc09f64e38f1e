"use strict";
// The view "Tableau": the text is what is judged; the grid shows and changes it where it is a single tableau in JSON.
const tableau_view = (() => {
  const $ = (id) => document.getElementById(id);
  const counted = [["order", "order"], ["embedded_order", "embedded order"]];
  const yes_no = [["A_stable", "A-stable"], ["L_stable", "L-stable"], ["algebraically_stable", "algebraically stable"],
                  ["symplectic", "symplectic"], ["symmetric", "symmetric"], ["stiffly_accurate", "stiffly accurate"]];
  let read = null;  // the tableau that the engine read last
  let member = null;  // the family's member that was inserted last, and its certificate
  let as_text = false, view = null, last_half = null;

  /// The tableau in the text, where the grid can show it.
  function model() {
    try {
      const t = JSON.parse(state.text);
      const s = t.b.length, row = (x) => Array.isArray(x) && x.length === s && x.every((e) => /string|number/.test(typeof e));
      const fits = row(t.b) && t.A.length === s && t.A.every(row) && (!t.c || row(t.c)) && (!t.b_embedded || row(t.b_embedded));
      return fits && s > 0 && s <= 16 ? t : null;
    } catch {
      return null;
    }
  }

  /// JSON with a row in a line.
  function written(t) {
    const line = (row) => JSON.stringify(row).replaceAll('","', '", "');
    return "{\n" + Object.entries(t).map(([key, x]) => {
      if (key === "A") return `  "A": [\n    ${x.map(line).join(",\n    ")}\n  ]`;
      return `  ${JSON.stringify(key)}: ${Array.isArray(x) ? line(x) : JSON.stringify(x)}`;
    }).join(",\n") + "\n}";
  }

  function set_model(t, redraw = true) {
    state.text = written(t);
    $("text").value = state.text;
    if (redraw) show();
    judge();
  }

  function change(edit) {
    const t = model();
    if (!t) return;
    edit(t);
    set_model(t);
  }

  function field(name, value, put) {
    return element("td", {}, element("input", {
      "aria-label": name, "data-entry": name, value, size: Math.max(5, Math.min(18, String(value).length + 1)),
      spellcheck: "false", autocomplete: "off",
      oninput: (e) => {
        const t = model();
        put(t, e.target.value.trim());
        e.target.size = Math.max(5, Math.min(18, e.target.value.length + 1));
        set_model(t, false);
      },
      onkeydown: move,
    }));
  }

  /// Up and down go to the entry above and below.
  function move(e) {
    const step = {ArrowUp: -1, ArrowDown: 1}[e.key];
    if (!step) return;
    const cell = e.target.closest("td"), rows = [...$("grid").querySelectorAll("tr")];
    const next = rows[rows.indexOf(cell.parentNode) + step]?.cells[cell.cellIndex]?.querySelector("input");
    if (next) {
      e.preventDefault();
      next.focus();
      next.select();
    }
  }

  function grid(t) {
    const c = t.c ?? t.A.map(() => "");
    const weights = (key, label) => element("tr.weights", {}, element("th", {}, label),
      ...t[key].map((x, j) => field(`${key}[${j + 1}]`, x, (u, value) => { u[key][j] = value; })));
    return element("div.scroll", {}, element("table.butcher.editable", {}, element("tbody", {},
      ...t.A.map((row, i) => element("tr", {},
        t.c ? field(`c[${i + 1}]`, c[i], (u, value) => { u.c[i] = value; }) : element("td", {}, ""),
        ...row.map((x, j) => field(`A[${i + 1}][${j + 1}]`, x, (u, value) => { u.A[i][j] = value; })))),
      weights("b", "b"), t.b_embedded ? weights("b_embedded", "b\u0302") : null)));
  }

  function claims(t) {
    const set = (key, value) => change((u) => {
      const all = {...u.claims};
      if (value === null) delete all[key];
      else all[key] = value;
      delete u.claims;
      if (Object.keys(all).length) u.claims = all;
    });
    const number = ([key, label]) => element("label", {}, `${label} `, element("input", {
      type: "number", min: "1", max: "14", "data-claim": key, value: t.claims?.[key] ?? "",
      onchange: (e) => set(key, e.target.value === "" ? null : Number(e.target.value))}));
    const choice = ([key, label]) => element("label", {}, element("input", {
      type: "checkbox", "data-claim": key, ...(t.claims?.[key] === true ? {checked: ""} : {}),
      onchange: (e) => set(key, e.target.checked ? true : null)}), ` ${label}`);
    return [...counted.filter(([key]) => key === "order" || t.b_embedded).map(number), ...yes_no.map(choice)];
  }

  /// The editor as the state has it.
  function show() {
    const t = model(), focus = document.activeElement?.dataset;
    const text = as_text || !t;
    $("grid").replaceChildren(text ? "" : grid(t));
    $("grid").hidden = $("grid-tools").hidden = text;
    $("text-label").hidden = !text;
    $("claims").hidden = !t;
    $("claims").replaceChildren(element("legend", {}, "Claimed"), ...(t ? claims(t) : []));
    $("embedded").setAttribute("aria-pressed", String(Boolean(t?.b_embedded)));
    $("as-grid").setAttribute("aria-pressed", String(!text));
    $("as-text").setAttribute("aria-pressed", String(text));
    for (const key of ["claim", "entry"])
      if (focus?.[key]) document.querySelector(`[data-${key}="${focus[key]}"]`)?.focus();
    if ($("text").value !== state.text) $("text").value = state.text;
  }

  /// The line of a refusal, at the field that it names.
  function complain(line) {
    $("error").textContent = line;
    $("error").hidden = !line;
    for (const input of document.querySelectorAll("#grid input")) {
      const at_fault = line.includes(`${input.dataset.entry}:`) && !line.includes(`_embedded${input.dataset.entry}`);
      input.setAttribute("aria-invalid", String(at_fault));
      if (at_fault) input.setAttribute("aria-errormessage", "error");
      else input.removeAttribute("aria-errormessage");
    }
  }

  async function judge() {
    write_state();
    const words = [state.text, "auto", state.decimals];
    if (!state.text.trim()) {
      complain("");
      $("certificate").replaceChildren(element("p", {}, "Nothing to judge yet: choose a method, or paste one."));
      $("region").parentNode.hidden = $("stability-box").hidden = true;
      return;
    }
    const certificate = engine.ask("tableau", "certify", ...words), region = engine.ask("region", "function", ...words);
    const answer = await certificate;  // which is shown before the region is there
    if (!answer || words[0] !== state.text) return;
    complain(answer.error ?? "");
    $("certificate").classList.toggle("stale", Boolean(answer.error));
    $("region").parentNode.classList.toggle("stale", Boolean(answer.error));
    if (answer.error) return;
    read = answer.tableau ?? null;
    const found = answer.methods ?? [answer];
    $("certificate").replaceChildren(
      ...(answer.not_used ? [element("p.error", {}, `Not used of this text: ${answer.not_used.join(", ")}`)] : []),
      ...found.map((c) => c.error ? element("div", {}, element("h2", {}, c.name), element("p.error", {}, c.error))
        : file_certificate(c, read?.A ? repair : null)));
    if (member?.text === state.text)
      $("certificate").append(element("details", {open: ""}, element("summary", {}, "Proved of the member of the family, whatever its digits"),
        theorem_certificate(member.certificate)));
    const r = await region;
    if (words[0] !== state.text) return;
    show_region(r, answer.poles ?? []);
    $("stability-box").hidden = !r || r.error;
    if ($("stability-box").open) stability();
  }

  function show_region(r, poles) {
    const figure = $("region").parentNode;
    figure.hidden = !r || Boolean(r.error);
    if (figure.hidden) return;
    view = {r, poles, half: natural_window(r, poles)};
    if (last_half && view.half > last_half / 1.5 && view.half < last_half * 1.5) view.half = last_half;
    last_half = view.half;
    redraw();
  }

  async function stability() {
    const answer = await engine.ask("stability", "stability", state.text, "auto", state.decimals);
    if (answer) $("stability").replaceChildren(answer.error ? element("p.error", {}, answer.error) : stability_report(answer));
  }

  function repair({entry, suggest}) {
    const t = model() ?? structuredClone(read);
    const [, key, i, j] = /^(\w+)\[(\d+)\](?:\[(\d+)\])?$/.exec(entry) ?? [];
    if (!key) return;
    if (j) t[key][i - 1][j - 1] = suggest;
    else t[key][i - 1] = suggest;
    set_model(t);
  }

  function resize(by) {
    change((t) => {
      const s = t.b.length + by;
      if (s < 1 || s > 16) return;
      const cut = (row, fill = "0") => by < 0 ? row.slice(0, s) : [...row, fill];
      t.A = by < 0 ? t.A.slice(0, s).map((row) => cut(row)) : [...t.A.map((row) => cut(row)), Array(s).fill("0")];
      t.b = cut(t.b);
      if (t.c) t.c = cut(t.c);
      if (t.b_embedded) t.b_embedded = cut(t.b_embedded);
    });
  }

  async function insert() {
    const answer = await engine.ask("family", "family", $("family").value, $("stages").value);
    if (!answer) return;
    if (answer.error) complain(answer.error);
    else {
      member = {text: written(answer.tableau), certificate: answer.certificate};
      set_model(answer.tableau);
    }
  }

  function listen() {
    let timer;
    $("text").addEventListener("input", () => {
      state.text = $("text").value;
      clearTimeout(timer);
      timer = setTimeout(() => { judge(); show(); }, 150);
      as_text = true;
    });
    $("as-grid").addEventListener("click", () => {
      as_text = false;
      if (!model() && read?.A) set_model(read);
      else show();
      if (!model()) complain("this is no single tableau of at most 16 stages, so there is no grid of it");
    });
    $("as-text").addEventListener("click", () => { as_text = true; show(); $("text").focus(); });
    $("more").addEventListener("click", () => resize(1));
    $("fewer").addEventListener("click", () => resize(-1));
    $("embedded").addEventListener("click", () => change((t) => {
      if (t.b_embedded) {
        delete t.b_embedded;
        if (t.claims) delete t.claims.embedded_order;
      } else {
        t.b_embedded = [...t.b];
      }
    }));
    $("insert").addEventListener("click", insert);
    $("catalogue").addEventListener("change", () => {
      if ($("catalogue").value) set_model(methods[$("catalogue").value]);
    });
    $("decimals").addEventListener("change", () => { state.decimals = $("decimals").value; judge(); });
    $("stability-box").addEventListener("toggle", () => { if ($("stability-box").open) stability(); });
    for (const button of $("region").parentNode.querySelectorAll("[data-zoom]"))
      button.addEventListener("click", () => { last_half = view.half *= Number(button.dataset.zoom); redraw(); });
    $("region").parentNode.querySelector("[data-star]").addEventListener("change", redraw);
  }

  function redraw() {
    if (view && !$("region").parentNode.hidden)
      draw_region($("region"), $("region-caption"), view.r, view.half, view.poles);
  }

  return {listen, open(t) { as_text = false; set_model(t); }, show() { $("decimals").value = state.decimals; show(); judge(); }, redraw};
})();
