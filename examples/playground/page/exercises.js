"use strict";
// The view "Exercises".
const exercises_view = (() => {
  const $ = (id) => document.getElementById(id);

  /// The kind in words. Called again when the engine has said what kinds there are.
  function name_kind() {
    $("kind").value = state.kind;
    $("asks").textContent = $("kind").selectedOptions[0]?.title ?? "";
  }

  async function make() {
    write_state();
    const answer = await engine.ask("exercise", "exercise", state.kind, state.seed);
    if (!answer) return;
    $("exercise-error").textContent = answer.error ?? "";
    $("exercise-error").hidden = !answer.error;
    $("seed").setAttribute("aria-invalid", String(Boolean(answer.error?.startsWith("seed"))));
    if (answer.error) return;
    name_kind();
    $("question").innerHTML = answer.question_html;  // the engine's own
    $("solution").innerHTML = answer.solution_html;
    $("question-latex").textContent = answer.question_latex;
    $("solution-latex").textContent = answer.solution_latex;
    $("answer").replaceChildren(claims_table(answer.certificate));
  }

  function choose(seed) {
    state.kind = $("kind").value;
    state.seed = seed;
    $("seed").value = seed;
    $("answer-box").open = $("solution-box").open = false;  // of another exercise
    make();
  }

  /// A page of its own, which the browser prints.
  async function sheet(solutions) {
    const page = window.open("", "_blank");  // now, as browsers open none later
    const answer = await engine.ask("sheet", "sheet", state.kind, state.seed, solutions);
    if (!answer || answer.error || !page) return page?.close();
    page.document.write(answer.html);
    page.document.close();
  }

  return {
    listen() {
      for (const button of document.querySelectorAll("[data-sheet]"))
        button.addEventListener("click", () => sheet(button.dataset.sheet));
      $("kind").addEventListener("change", () => choose(state.seed));
      $("seed").addEventListener("input", () => choose($("seed").value));
      $("next").addEventListener("click", () => choose(`${(Number(state.seed) + 1) % 2147483648}`));
    },
    show() {
      $("seed").value = state.seed;
      make();
    },
    name_kind,
    redraw() {},
  };
})();
