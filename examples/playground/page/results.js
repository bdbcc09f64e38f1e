"use strict";
// What the engine answers, as elements of the page.

/// element("td.wide", child or text, ...); on... attributes are listeners.
function element(name, attributes = {}, ...children) {
  const [tag, ...classes] = name.split(".");
  const e = document.createElement(tag);
  e.className = classes.join(" ");
  for (const [key, value] of Object.entries(attributes))
    if (key.startsWith("on")) e.addEventListener(key.slice(2), value);
    else e.setAttribute(key, value);
  e.append(...children.filter((child) => child !== null && child !== undefined));
  return e;
}

const signs = {proved: "✓", refuted: "✗", consistent: "≈", inconclusive: "?"};
const words_of = (key) => key.replaceAll("_", " ").replace(/^[a-z]/, (c) => c.toUpperCase())
  .replace(/^([AL]) stable/, "$1-stable");

function badge(standing) {
  return element(`span.badge.${standing.replace(/\W/g, "_")}`, {}, `${signs[standing] ?? ""} ${standing}`.trim());
}

/// A line of a certificate. Colours are for claims: that a method is not A-stable is no fault unless it is claimed.
function statement_row({what, standing, value, claimed, claim, reason}) {
  const found = value !== undefined ? `${value}` : standing === "proved" ? "yes" : standing === "refuted" ? "no" : standing ?? "";
  return element("tr", {},
    element("th", {scope: "row"}, what),
    element("td", {}, found),
    element("td", {}, claim ? element("span.small", {}, `claimed ${{true: "yes", false: "no"}[claimed] ?? claimed} `) : null,
      claim ? badge(claim) : null),
    element("td.reason", {}, reason ?? ""));
}

function statement_table(rows) {
  return element("table.statements", {},
    element("thead", {}, element("tr", {}, ...["", "found", "claim", "because"].map((h) => element("th", {scope: "col"}, h)))),
    element("tbody", {}, ...rows.map(statement_row)));
}

/// Keys of a certificate with an object that is no finding.
const not_findings = ["principal_error", "error_metrics", "nearest", "tableau", "stability_function"];

/// The certificate of a file; `repair` is called with a suspect whose button was pressed.
function file_certificate(c, repair) {
  const rows = Object.entries(c)
    .filter(([key, x]) => x && typeof x === "object" && !Array.isArray(x) && !not_findings.includes(key))
    .map(([key, x]) => ({what: words_of(key), standing: x.verdict, value: x.value, claimed: x.claimed, claim: x.claim,
                         reason: x.reason}));
  return element("div.certificate", {},
    element("h2", {}, c.name || "Tableau", " ", badge(c.verdict)),
    c.source ? element("p.small", {}, c.source) : null,
    element("p.small", {}, [`${c.stages} stages`, c.data, ...(c.notes ?? [])].join("; ")),
    suspects(c, repair),
    statement_table(rows),
    failures(c),
    numbers(c),
    ...(c.partners ?? []).map((p) => file_certificate(p, null)));
}

function suspects(c, repair) {
  if (!c.suspects?.length && !c.suspects_note) return null;
  return element("div.suspects", {},
    c.suspects.length ? element("p", {}, "Entries whose change alone restores every claim:") : null,
    element("ul", {}, ...c.suspects.map((s) =>
      element("li", {}, element("code", {}, s.entry), ` = ${s.written} should read `, element("b", {}, s.suggest), " ",
        repair ? element("button", {onclick: () => repair(s)}, "Repair") : null))),
    c.suspects_note ? element("p.small", {}, c.suspects_note) : null);
}

function failures(c) {
  if (!c.failures?.length) return null;
  const row = (f) => element("tr", {}, element("td", {}, f.tree ? tree_picture(f.tree) : null),
    element("td", {}, element("code", {}, f.condition)), element("td", {}, element("code", {}, f.residual)));
  const table = (list) => element("div.scroll", {}, element("table.failures", {},
    element("thead", {}, element("tr", {}, ...["tree", "condition", "residual"].map((h) => element("th", {scope: "col"}, h)))),
    element("tbody", {}, ...list.map(row))));
  const vertices = (f) => f.tree.split("tau").length - 1 + f.tree.split("[").length - 1;
  const sorted = [...c.failures].sort((f, g) => vertices(f) - vertices(g));  // a claim of the lowest order fails first
  const shown = sorted.slice(0, 6), rest = sorted.slice(6);
  const all = [table(shown), rest.length ? element("details", {}, element("summary", {}, `${rest.length} more`), table(rest)) : null];
  if (c.verdict === "refuted") return element("div", {}, element("h3", {}, "Conditions that fail"), ...all);
  return element("details", {}, element("summary", {}, "Conditions that fail, though nothing claimed needs them"), ...all);
}

function metrics_line(m) {
  const next = m.lower_order + 2;
  return `Error metrics: A^(${m.order + 1}) = ${m.A}, A^(${m.lower_order + 1}) = ${m.A_embedded}, B^(${next}) = ${m.B}, ` +
    `C^(${next}) = ${m.C}, D = ${m.D}, E^(${next}) = ${m.E}`;
}

function numbers(c) {
  const list = (values) => values.length
    ? values.map((z) => `${z.exact ?? z.re}${Number(z.im) ? ` ${z.im < 0 ? "−" : "+"} ${String(z.im).replace("-", "")} i` : ""}` +
        (z.multiplicity > 1 ? ` (${z.multiplicity} times)` : "")).join(", ") : "none";
  const lines = [
    c.principal_error && `Principal error, of order ${c.principal_error.order}: 2-norm ${c.principal_error.norm}, largest ${c.principal_error.largest}`,
    c.error_metrics && metrics_line(c.error_metrics),
    c.eigenvalues && `Eigenvalues of A: ${list(c.eigenvalues)}`,
    c.poles && `Poles of R: ${list(c.poles)}`,
    c.nearest && `Nearest: ${c.nearest.family} with ${c.nearest.stages} stages, largest error ${c.nearest.error} ${c.nearest.entry ? `at ${c.nearest.entry}` : ""}`];
  return element("div.small", {}, ...lines.filter(Boolean).map((line) => element("p", {}, line)));
}

/// A list of {statement, verdict, reason}.
function claims_table(claims) {
  return element("table.statements", {}, element("tbody", {}, ...claims.map((c) =>
    element("tr", {}, element("th", {scope: "row"}, c.statement), element("td.unclaimed", {}, badge(c.verdict)),
      element("td.reason", {}, c.reason)))));
}

/// The certificate of a family's member or of given nodes: what is most asked for, then every statement.
function theorem_certificate(c) {
  const yes_no = [["A-stable", c.A_stable], ["L-stable", c.L_stable], ["algebraically stable", c.algebraically_stable],
                  ["symplectic", c.symplectic], ["symmetric", c.symmetric], ["stiffly accurate", c.stiffly_accurate]];
  return element("div.certificate", {},
    element("p.facts", {}, ...[["order", c.order.value], ["R(∞)", c.R_infinity === "infinity" ? "∞" : c.R_infinity],
      ...yes_no.map(([what, v]) => [what, v.verdict === "proved" ? "yes" : v.verdict === "refuted" ? "no" : v.verdict])]
      .map(([what, value]) => element("span", {}, `${what} `, element("b", {}, `${value}`)))),
    claims_table(c.claims));
}

/// The report of `stability`: sections of statements.
function stability_report(answer) {
  return element("div", {}, ...Object.entries(answer).filter(([, list]) => Array.isArray(list))
    .flatMap(([title, list]) => [element("h3", {}, title), claims_table(list)]));
}

/// c | A over b, to read.
function tableau_table(t) {
  return element("table.butcher", {}, element("tbody", {}, ...t.A.map((row, i) =>
    element("tr", {}, element("th", {}, t.c?.[i] ?? ""), ...row.map((a) => element("td", {}, a))))),
    element("tfoot", {}, element("tr", {}, element("th"), ...t.b.map((b) => element("td", {}, b)))));
}
