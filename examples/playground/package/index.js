// The functions of index.d.ts: JSON from the engine, and an Error where it refuses.
import make_engine from "./engine.cjs";

let ready;

async function ask(name, ...words) {
  const engine = await (ready ??= make_engine());
  const answer = JSON.parse(engine.ccall(`stagecraft_${name}`, "string", words.map(() => "string"), words));
  if (answer.error === undefined) return answer;
  throw Object.assign(new Error(answer.error), {exit_code: answer.exit_code});
}

const text_of = (method) => (typeof method === "string" ? method : JSON.stringify(method));

export const certify = (method, {from = "auto", decimals = "auto"} = {}) =>
  ask("certify", text_of(method), from, decimals);
export const stability = (method, {from = "auto", decimals = "auto"} = {}) =>
  ask("stability", text_of(method), from, decimals);
export const tableau = (family, stages, digits = 20) => ask("tableau", family, `${stages}`, `${digits}`);
export const collocate = (nodes) => ask("collocate", [nodes].flat().join(","));
export const exercise = (kind, seed = 1) => ask("exercise", kind, `${seed}`);
