"use strict";
// Formulas, by KaTeX; tables that can be sorted and filtered (class "sortable").
// From disk a browser reads no other page, which the search would quote.
if (location.protocol === "file:" && window.DOCUMENTATION_OPTIONS) DOCUMENTATION_OPTIONS.SHOW_SEARCH_SUMMARY = false;
document.addEventListener("DOMContentLoaded", () => {
  for (const e of document.querySelectorAll(".math"))
    katex.render(e.textContent, e, {displayMode: e.tagName === "DIV", throwOnError: false});
  for (const box of document.querySelectorAll(".sortable")) make_sortable(box.querySelector("table"));
});

// Numbers by value ("5(4)" as 5), everything else by text; a heading is a button, so that a keyboard reaches it.
function make_sortable(table) {
  const body = table.tBodies[0];
  const text = (row, k) => row.cells[k].textContent.trim();
  [...table.tHead.rows[0].cells].forEach((cell, k) => {
    const button = document.createElement("button");
    button.textContent = cell.textContent;
    cell.replaceChildren(button);
    button.addEventListener("click", () => {
      const down = cell.getAttribute("aria-sort") === "ascending";
      for (const other of cell.parentNode.cells) other.removeAttribute("aria-sort");
      cell.setAttribute("aria-sort", down ? "descending" : "ascending");
      const rows = [...body.rows].sort((a, b) => {
        const x = text(a, k), y = text(b, k), m = parseFloat(x), n = parseFloat(y);
        return (m === m && n === n ? m - n : x.localeCompare(y)) * (down ? -1 : 1);
      });
      body.append(...rows);
    });
  });
  const field = document.createElement("input");
  field.type = "search";
  field.placeholder = "filter: every word must occur";
  field.setAttribute("aria-label", "filter the table");
  const count = document.createElement("span");
  const show = () => {
    const words = field.value.toLowerCase().split(/\s+/);
    let shown = 0;
    for (const row of body.rows) {
      row.hidden = !words.every((w) => row.textContent.toLowerCase().includes(w));
      shown += !row.hidden;
    }
    count.textContent = ` ${shown} of ${body.rows.length}`;
  };
  field.addEventListener("input", show);
  const line = document.createElement("p");
  line.className = "filter";
  line.append(field, count);
  table.closest(".sortable").prepend(line);
  show();
}
