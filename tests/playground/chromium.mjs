// A page in headless Chromium, driven through its debugging pipe: fds 3 and 4, JSON between zero bytes.
import {spawn} from "node:child_process";
import {mkdtempSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";

export async function open_browser() {
  const profile = mkdtempSync(join(tmpdir(), "playground-"));
  const process_ = spawn("chromium", ["--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--remote-debugging-pipe",
    `--user-data-dir=${profile}`, "about:blank"], {stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"]});
  const [, , , to, from] = process_.stdio;
  const answers = new Map(), events = [];
  let count = 0, rest = "";
  from.setEncoding("utf8");
  from.on("data", (data) => {
    const parts = (rest + data).split("\0");
    rest = parts.pop();
    for (const message of parts.map((text) => JSON.parse(text))) {
      if (message.id) {
        const {resolve, reject} = answers.get(message.id);
        if (message.error) reject(new Error(message.error.message));
        else resolve(message.result);
        answers.delete(message.id);
      } else {
        events.push(message);
      }
    }
  });
  const send = (method, params = {}, sessionId) => new Promise((resolve, reject) => {
    answers.set(++count, {resolve, reject});
    to.write(JSON.stringify({id: count, method, params, sessionId}) + "\0");
  });
  const {targetInfos} = await send("Target.getTargets");
  const {targetId} = targetInfos.find(({type}) => type === "page");
  const {sessionId} = await send("Target.attachToTarget", {targetId, flatten: true});
  const page = (method, params) => send(method, params, sessionId);
  for (const domain of ["Page", "Runtime", "Log", "Network"]) await page(`${domain}.enable`);
  const evaluate = async (expression) => {
    const {result, exceptionDetails} = await page("Runtime.evaluate", {expression, awaitPromise: true, returnByValue: true});
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  };
  return {
    page, evaluate,
    /// Goes to the address, from another page so that it is loaded anew.
    async go(url) {
      await page("Page.navigate", {url: "about:blank"});
      await page("Page.navigate", {url});
    },
    /// The value of the expression as soon as it is true.
    async until(expression, seconds = 20) {
      for (const end = Date.now() + 1000 * seconds; Date.now() < end; await new Promise((resolve) => setTimeout(resolve, 20))) {
        const value = await evaluate(expression).catch(() => null);
        if (value) return value;
      }
      throw new Error(`never true: ${expression}`);
    },
    /// What the page complained of, and the addresses that it asked for.
    complaints: () => events.filter(({method, params}) => method === "Runtime.exceptionThrown" ||
      (method === "Log.entryAdded" && params.entry.level === "error") ||
      (method === "Runtime.consoleAPICalled" && ["error", "assert"].includes(params.type)))
      .map(({params}) => JSON.stringify(params).slice(0, 400)),
    requests: () => events.filter(({method}) => method === "Network.requestWillBeSent").map(({params}) => params.request.url),
    async close() {
      await send("Browser.close").catch(() => {});
      await new Promise((resolve) => process_.on("exit", resolve));
      rmSync(profile, {recursive: true, force: true, maxRetries: 5});
    },
  };
}
