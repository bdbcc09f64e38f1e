// What the engine in WebAssembly says is what the command prints, in every word: verdicts.mjs ENGINE COMMAND
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import {readFileSync, readdirSync} from "node:fs";
import {createRequire} from "node:module";
import {resolve} from "node:path";

const [engine, command] = process.argv.slice(2).map((path) => resolve(path));
const module = await createRequire(import.meta.url)(engine)();
const call = (name, ...words) =>
  JSON.parse(module.ccall(`stagecraft_${name}`, "string", words.map(() => "string"), words));

// What the command prints: JSON, or a line of it for each tableau of a program, in the engine's form; or its complaint and
// exit code. 1 and 3 are verdicts.
function answer(printed) {
  if (!printed.startsWith("{\"")) return JSON.parse(printed);
  const lines = printed.trim().split("\n").map((line) => JSON.parse(line));
  if (lines.length === 1) return lines[0];
  const methods = lines.filter((line) => !line.not_used), rest = lines.find((line) => line.not_used);
  return rest ? {methods, not_used: rest.not_used} : {methods};
}
function said(input, ...words) {
  try {
    return answer(execFileSync(command, words, {input, encoding: "utf8", stdio: "pipe"}));
  } catch (e) {
    if (e.stdout) return answer(e.stdout);
    return {error: e.stderr.trim().replace(/^stagecraft: /, ""), exit_code: e.status};
  }
}

// Enclosures are printed to three digits from a long double, which has 64 bits there and 113 here: a tie may go the other
// way. Such a number counts as the other's where it is 1 in the third digit apart, and these are counted.
let compared = 0, ties = 0;
const number = /[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?/g;
function as_theirs(ours, theirs) {
  if (typeof ours === "string" && typeof theirs === "string" && ours !== theirs && ours.includes(" +- ")) {
    const x = ours.match(number), y = theirs.match(number);
    const near = x.every((text, k) => Math.abs(text - y[k]) <= 0.01 * Math.abs(y[k]));
    if (!near || ours.replace(number, "") !== theirs.replace(number, "")) return ours;
    ++ties;
    return theirs;
  }
  if (ours === null || theirs === null || typeof ours !== "object" || typeof theirs !== "object") return ours;
  if (Array.isArray(ours)) return ours.map((item, k) => as_theirs(item, theirs[k] ?? null));
  return Object.fromEntries(Object.entries(ours).map(([key, value]) => [key, as_theirs(value, theirs[key] ?? null)]));
}
function same(ours, theirs, what) {
  assert.deepEqual(as_theirs(ours, theirs), theirs, what);
  ++compared;
}

const verdicts = {};
for (const folder of ["tableaux/catalogue", "tableaux/pairs", "tableaux/dense", "tests/data/misprints"])
  for (const file of readdirSync(folder).filter((name) => name.endsWith(".json"))) {
    const text = readFileSync(`${folder}/${file}`, "utf8");
    const ours = call("certify", text, "auto", "auto");
    if (/\.json"/.test(text)) {  // parts in files of their own, which a page cannot open
      assert.match(ours.error, /cannot read/);
      continue;
    }
    same(ours, said("", "certify", `${folder}/${file}`, "--json"), file);
    (verdicts[folder] ??= []).push(ours.verdict);
  }
assert.ok(verdicts["tableaux/catalogue"].length > 100);
assert.ok(verdicts["tests/data/misprints"].every((verdict) => verdict === "refuted"));

const code = "A = np.array([[0, 0, 0], [1/2, 0, 0], [-1, 2, 0]])\nb = [1/6, 2/3, 1/6]\norder = 3";
same(call("certify", code, "auto", "auto"), said(code, "certify", "-", "--from", "text", "--json"), "program text");
for (const several of ["heun_A = [[0,0],[1,0]]\nheun_b = [1/2,1/2]\nmid_A = [[0,0],[1/2,0]]\nmid_b = [0,1]\norder = 7\nE = [1, 2]",
                       "A1 = [[0,0],[1,0]]\nb1 = [1/2,1/2]\nA2 = [[0,0],[1/0,0]]\nb2 = [0,1]"]) {
  assert.equal(call("certify", several, "auto", "auto").methods.length, 2);
  same(call("certify", several, "auto", "auto"), said(several, "certify", "-", "--from", "text", "--json"), several);
}
for (const bad of ['{"A": [["0"]]}', '{"A": [["1/0"]], "b": [1]}', "{", '{"A": [[0]], "b": [1], "claims": {"order": -1}}'])
  same(call("certify", bad, "json", "auto").error, said(bad, "certify", "-", "--json").error.replace(/^-: /, ""), bad);
same(call("certify", "{}", "auto", "odd").exit_code, 2, "decimals");

for (const name of ["gauss_2", "classical_rk4", "radau_iia_5", "dormand_prince_5_4"])
  same(call("stability", readFileSync(`tableaux/catalogue/${name}.json`, "utf8"), "auto", "auto"),
       said("", "stability", `tableaux/catalogue/${name}.json`, "--json"), name);
for (const {name, least} of call("choices").families) {
  for (const s of [least, 5])
    same(call("tableau", name, `${s}`, "30"), said("", "tableau", name, `${s}`, "--digits", "30", "--format", "json"), name);
  const {tableau, ...certificate} = said("", "certify", name, `${least + 1}`, "--json");
  same(call("family", name, `${least + 1}`).certificate, certificate, name);
}
same(call("family", "gaus", "2"), said("", "certify", "gaus", "2", "--json"), "no family");
for (const nodes of ["1/6,2/3,1", "0,1/2,1", "(3-sqrt(3))/6,(3+sqrt(3))/6", "1/2,1/2", "2", ""])
  same(call("collocate", nodes).error ?? call("collocate", nodes),
       nodes === "" ? "--nodes: at least one node needed" : said("", "collocate", "--nodes", nodes, "--json").error ??
       said("", "collocate", "--nodes", nodes, "--json"), nodes);
for (const {name} of call("choices").exercises)
  for (const seed of ["1", "2", "2147483647"])
    same(call("exercise", name, seed), said("", "exercise", name, "--seed", seed, "--json"), name);

const {numerator, denominator} = call("function", readFileSync("tableaux/catalogue/gauss_2.json", "utf8"), "auto", "auto");
assert.deepEqual([numerator, denominator], [[1, 1 / 2, 1 / 12], [1, -1 / 2, 1 / 12]]);  // the Pade approximation
assert.ok(ties <= 3, `${ties} numbers differ in their third digit`);
console.log(`verdicts: ${compared} answers are the command's`);
