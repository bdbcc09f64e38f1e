// The playground, opened from disk in a browser: what a visitor does and sees. page.mjs INDEX.HTML [FOLDER for screenshots]
import assert from "node:assert/strict";
import {mkdirSync, readFileSync, writeFileSync} from "node:fs";
import {resolve} from "node:path";
import {pathToFileURL} from "node:url";
import {open_browser} from "./chromium.mjs";

const address = pathToFileURL(resolve(process.argv[2])).href, pictures = process.argv[3];
const browser = await open_browser();
const {evaluate, until} = browser;
const fragment = (words) => "#" + new URLSearchParams(words);
const title = "document.querySelector('#certificate h2')?.textContent";
const settled = (name, verdict) => until(`${title}?.includes(${JSON.stringify(name)}) && ${title}.includes(${JSON.stringify(verdict)})`);
// As if typed: the value, and the event of it.
const type = (selector, value, event = "input") => evaluate(`(() => {
  const field = document.querySelector(${JSON.stringify(selector)});
  field.value = ${JSON.stringify(value)};
  field.dispatchEvent(new Event("${event}", {bubbles: true}));
})()`);
const click = (selector) => evaluate(`document.querySelector(${JSON.stringify(selector)}).click()`);
const size = (width, dark = false) => Promise.all([
  browser.page("Emulation.setDeviceMetricsOverride", {width, height: 900, deviceScaleFactor: 1, mobile: width < 500}),
  browser.page("Emulation.setEmulatedMedia", {features: [{name: "prefers-color-scheme", value: dark ? "dark" : "light"}]})]);
const misprint = (name) => readFileSync(`tests/data/misprints/${name}.json`, "utf8");

try {
  // A visitor who brings nothing sees a method and its certificate.
  await size(1400);
  await browser.page("Page.addScriptToEvaluateOnNewDocument", {source: `addEventListener("load", () => { window.loaded = performance.now(); });
    new MutationObserver(() => { if (document.querySelector("#certificate h2")) window.certified ??= performance.now(); })
      .observe(document, {subtree: true, childList: true});`});
  await browser.go(address);
  await settled("order 4 (RK4)", "proved");
  const {loaded, certified} = await evaluate("({loaded, certified})");
  console.log(`page: loaded after ${Math.round(loaded)} ms, a certificate ${Math.round(certified - loaded)} ms later`);
  const grey = (x, y) => evaluate(`document.getElementById("region").getContext("2d")
    .getImageData(${x} * document.getElementById("region").width, ${y} * document.getElementById("region").height, 1, 1).data[0]`);
  await until("!document.getElementById('region').parentNode.hidden");
  assert.notEqual(await grey(0.4, 0.45), await grey(0.05, 0.05));  // inside the region of RK4, and outside

  await click("[data-star]");  // the order star
  assert.match(await evaluate("document.getElementById('region-caption').textContent"), /\|R\(z\)\| > \|eᶻ\|/);
  assert.notEqual(await grey(0.1, 0.45), await grey(0.95, 0.45));  // |R| > |e^z| on the left, < on the right
  await click("[data-star]");

  // An entry is mistyped: refused at its field and kept; then wrong: the tree and the repair; repaired: proved.
  await type('[data-entry="A[4][3]"]', "1/0");
  await until(`document.querySelector('[data-entry="A[4][3]"]').getAttribute("aria-invalid") === "true"`);
  assert.match(await evaluate("document.getElementById('error').textContent"), /A\[4\]\[3\]: '1\/0' division by zero/);
  assert.equal(await evaluate(`document.querySelector('[data-entry="A[4][3]"]').value`), "1/0");
  await type('[data-entry="A[4][3]"]', "3/4");
  await settled("RK4", "refuted");
  assert.ok(await evaluate("document.getElementById('error').hidden"));
  await type('[data-entry="A[4][3]"]', "1");
  await settled("RK4", "proved");
  await type('[data-entry="b[4]"]', "1/3");
  await settled("RK4", "refuted");
  assert.equal(await evaluate("document.querySelectorAll('#certificate svg.tree circle').length"), 1);  // of order 1
  await click(".suspects button");
  await settled("RK4", "proved");
  assert.equal(await evaluate(`document.querySelector('[data-entry="b[4]"]').value`), "1/6");

  // The address is the page.
  assert.match(await evaluate("decodeURIComponent(location.hash)"), /"1\/6"/);
  for (const [name, entry] of [["radau_iia_2_lost_sign", /^A/], ["cash_karp_18574", /^b_embedded\[3\]$/]]) {
    await browser.go(address + fragment({view: "tableau", text: misprint(name)}));
    await settled("misprinted", "refuted");
    assert.match(await evaluate("document.querySelector('.suspects code').textContent"), entry);
  }
  const code = "A = [0 0 0; 1//2 0 0; -1 2 0]\nb = [1//6, 2//3, 1//6]\norder = 3";
  await browser.go(address + fragment({view: "tableau", text: code}));
  await settled("", "proved");
  await click("#as-grid");
  await until(`document.querySelector('[data-entry="A[3][1]"]')?.value === "-1"`);
  for (const nonsense of ["#view=everything", "#colour=red", "#seed=-1"]) {
    await browser.go(address + nonsense);
    assert.match(await until("!document.getElementById('notice').hidden && document.getElementById('notice').textContent"), /empty/);
    assert.equal(await evaluate("document.getElementById('text').value"), "");
  }

  // Families; a decision that takes too long can be cancelled, and the page goes on.
  await until("document.querySelector('#family option')");
  await type("#family", "radau_iia", "change");
  await type("#stages", "3");
  await click("#insert");
  await settled("radau_iia, s = 3", "proved");
  await type("#stages", "0");
  await click("#insert");
  assert.match(await until("!document.getElementById('error').hidden && document.getElementById('error').textContent"),
               /'0' is not a whole number from 1 to 30/);
  await type("#stages", "30");
  await click("#insert");
  await until("!document.getElementById('cancel').hidden");
  await click("#cancel");
  assert.match(await until("!document.getElementById('error').hidden && document.getElementById('error').textContent"), /cancelled/);
  await type("#catalogue", "gauss_2", "change");
  await settled("Gauss, s = 2", "proved");
  await evaluate("document.getElementById('stability-box').open = true");
  assert.match(await until("document.getElementById('stability').textContent"), /A-stableproved|A-stable✓ proved/);

  // Nodes by keyboard and by pointer.
  await browser.go(address + fragment({view: "nodes", nodes: "1/6,2/3,1"}));
  const facts = "document.querySelector('#node-certificate .facts')?.textContent";
  assert.match(await until(facts), /order 4.*R\(∞\) 0.*A-stable yes/);
  await evaluate("document.querySelector('[data-node=\"0\"]').focus()");
  for (const type_ of ["keyDown", "keyUp"]) await browser.page("Input.dispatchKeyEvent", {type: type_, key: "ArrowRight", code: "ArrowRight"});
  await until(`document.getElementById("node-text").value === "5/24,2/3,1"`);
  const [x, y, width] = await evaluate(`(() => { const c = document.querySelector('[data-node="2"]').getBoundingClientRect();
    return [c.x + c.width / 2, c.y + c.height / 2, document.querySelector('#line svg').getBoundingClientRect().width]; })()`);
  const mouse = (type_, at) => browser.page("Input.dispatchMouseEvent", {type: type_, x: at, y, button: "left", buttons: 1, clickCount: 1});
  await mouse("mousePressed", x);
  await mouse("mouseMoved", x - (width - 36) / 8);
  await mouse("mouseReleased", x - (width - 36) / 8);
  await until(`document.getElementById("node-text").value === "5/24,2/3,7/8"`);
  await type("#node-text", "1/3,1/3");
  assert.match(await until("!document.getElementById('node-error').hidden && document.getElementById('node-error').textContent"), /distinct/);
  await type("#node-text", "0,1/2,1");
  await until(`${facts}?.includes("order 4") && ${facts}.includes("symmetric yes")`);  // Lobatto IIIA

  // A run: its curves and steps; another problem; a tolerance that is none; what takes too long can be cancelled.
  const words = (id) => `document.getElementById("${id}").textContent`;
  const charts = "document.querySelectorAll('#curves svg.chart').length";
  await browser.go(address + fragment({view: "integrate"}));
  await until(`${charts} === 2`);
  assert.match(await evaluate(words("run-facts")), /ended.*at t = 4.*steps.*refused for the error/);
  assert.equal(await evaluate("document.querySelectorAll('#curves path.refused').length"), 2);  // and in the legend
  await type("#problem", "pendulum_3", "change");
  await until(`${words("equations")}.includes("p·p") && document.querySelector("#curves h3").textContent === "p₂ against p₁"`);
  const rods = "document.querySelector('#curves .rods').getAttribute('points')";
  assert.equal(await evaluate(rods), "0.0000,0.0000 1.0000,0.0000");  // level at t = 0, the fixed end first
  const play = "#curves figure:nth-child(2) button";
  await click(play);
  await until(`${rods} !== "0.0000,0.0000 1.0000,0.0000"`);
  await click(play);
  assert.equal(await evaluate(`document.querySelector("${play}").textContent`), "Play");
  await type("#tolerance", "0");
  assert.match(await until("!document.getElementById('integrate-error').hidden && document.getElementById('integrate-error').textContent"), /tolerance: '0' is not/);
  assert.equal(await evaluate("document.getElementById('tolerance').getAttribute('aria-invalid')"), "true");
  await type("#tolerance", "1e-4");
  await until("document.getElementById('integrate-error').hidden");
  await type("#across", "t", "change");
  await until("document.querySelector('#curves h3').textContent === 'Solution' && location.hash.includes('across=t')");
  await evaluate("document.querySelector('#curves details').open = true");
  assert.match(await until("document.querySelector('#curves pre').textContent"), /^t,p₁,p₂,v₁,v₂,λ\n0,1,0,0,0,0\n/);
  await type("#method", "explicit_euler", "change");  // which no singular M allows
  await until("!document.getElementById('integrate-error').hidden");

  // Slopes: the order that is proved, and the errors that are measured.
  await browser.go(address + fragment({view: "integrate", show: "errors", problem: "logistic", method: "classical_rk4"}));
  await until("document.querySelectorAll('.slopes tbody tr').length >= 6");
  assert.match(await evaluate(words("run-facts")), /order, proved4/);
  assert.ok(Math.abs(await evaluate("Number(document.querySelector('.slopes tbody tr:nth-child(6)').cells[2].textContent)") - 4) < 0.3);

  await type("#method", "radau_iia 3", "change");
  await until(`/order, proved5/.test(${words("run-facts")}) && document.querySelector("#curves .legend").textContent.includes("h⁵")`);

  // Ghosts: two of the explicit midpoint rule, of which the slider moves one; links carry the step size.
  await browser.go(address + fragment({view: "integrate", show: "ghosts", method: "explicit_midpoint", h: "2.5"}));
  await until(`/0\\.8ghost/.test(${words("run-facts")}) && ${words("run-facts")}.includes("these are all")`);
  await type("#h", "1.6");
  await until(`${words("run-facts")}.includes("1.25") && location.hash.includes("h=1.6")`);
  await until("document.querySelector('#curves path.orbit').getAttribute('d').length > 20000");
  await type("#h-text", "x");
  assert.match(await until("!document.getElementById('integrate-error').hidden && document.getElementById('integrate-error').textContent"), /x/);
  for (const [nonsense, said] of [["#view=integrate&h=two", /empty/], ["#view=integrate&across=-1", /empty/], ["#view=integrate&show=all", /empty/]]) {
    await browser.go(address + nonsense);
    assert.match(await until("!document.getElementById('notice').hidden && document.getElementById('notice').textContent"), said);
  }
  for (const [what, said] of [[{problem: "nothing"}, /problem: 'nothing' is none/], [{method: "nobody"}, /method: 'nobody' is none/],
                              [{method: "own"}, /no tableau in the first view/]]) {
    await browser.go(address + fragment({view: "integrate", ...what}));
    assert.match(await until("!document.getElementById('integrate-error').hidden && document.getElementById('integrate-error').textContent"), said);
    assert.equal(await evaluate(charts), 0);
  }

  // Exercises.
  await browser.go(address + fragment({view: "exercise", kind: "a-stability", seed: "3"}));
  assert.match(await until("document.getElementById('question').textContent"), /Is this method A-stable/);
  assert.match(await evaluate("document.getElementById('solution').textContent"), /not A-stable/);
  assert.ok(await evaluate("document.querySelectorAll('#question mtable mtr').length") >= 2);
  await evaluate("window.open = () => ({document: {write(text) { window.sheet = text; }, close() {}}})");
  await click("[data-sheet=no]");
  assert.match(await until("window.sheet"), /10\. a-stability/);
  assert.doesNotMatch(await evaluate("window.sheet"), /Solutions/);
  await until("document.getElementById('asks').textContent === 'decide A- and L-stability, with the reason'");
  assert.equal(await evaluate("document.getElementById('kind').value"), "a-stability");
  await click("#next");
  await until("location.hash.includes('seed=4')");

  for (const dark of [false, true])
    for (const width of [360, 1400]) {
      await size(width, dark);
      for (const [name, words] of Object.entries({tableau: {view: "tableau", text: misprint("radau_iia_2_lost_sign")},
          nodes: {view: "nodes", nodes: "0,1/3,1"}, solution: {view: "integrate", problem: "van_der_pol"},
          errors: {view: "integrate", show: "errors", problem: "index_two"}, robertson: {view: "integrate", problem: "robertson"},
          ghosts: {view: "integrate", show: "ghosts", method: "classical_rk4", h: "3"}, exercise: {view: "exercise", kind: "order", seed: "2"}})) {
        await browser.go(address + fragment(words));
        await until("document.querySelector('#certificate h2, #node-certificate .facts, #run-facts tr, #question:not(:empty)')");
        assert.ok(await evaluate("document.documentElement.scrollWidth <= innerWidth"), `${name} is wider than ${width}`);
        if (!pictures) continue;
        mkdirSync(pictures, {recursive: true});
        await new Promise((done) => setTimeout(done, name === "ghosts" ? 6000 : 1000));
        const {data} = await browser.page("Page.captureScreenshot", {captureBeyondViewport: true});
        writeFileSync(`${pictures}/${name}_${width}${dark ? "_dark" : ""}.png`, Buffer.from(data, "base64"));
      }
    }
  assert.deepEqual(browser.complaints(), []);
  assert.deepEqual(browser.requests().filter((url) => !/^(about|blob|data):/.test(url) && url.split("#")[0] !== address), []);
} finally {
  await browser.close();
}
console.log("page: passed");
