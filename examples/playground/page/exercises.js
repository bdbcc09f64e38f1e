"use strict";
// The view "Exercises".
const exercises_view = (() => {
  const $ = (id) => document.getElementById(id);

  async function make() {
    write_state();
    const answer = await engine.ask("exercise", "exercise", state.kind, state.seed);
    if (!answer) return;
    $("exercise-error").textContent = answer.error ?? "";
    $("exercise-error").hidden = !answer.error;
    $("seed").setAttribute("aria-invalid", String(Boolean(answer.error?.startsWith("seed"))));
    if (answer.error) return;
    $("asks").textContent = $("kind").selectedOptions[0]?.title ?? "";
    $("question").textContent = answer.question;
    $("solution").textContent = answer.solution;
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

  return {
    listen() {
      $("kind").addEventListener("change", () => choose(state.seed));
      $("seed").addEventListener("input", () => choose($("seed").value));
      $("next").addEventListener("click", () => choose(`${(Number(state.seed) + 1) % 2147483648}`));
    },
    show() {
      $("kind").value = state.kind;
      $("seed").value = state.seed;
      make();
    },
    redraw() {},
  };
})();
