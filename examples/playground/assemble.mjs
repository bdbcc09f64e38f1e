// The page in one file: assemble.mjs ENGINE OUTPUT puts styles, scripts, the engine and the published methods into
// page/index.html, so that it works from disk, where a browser loads no second file into a worker.
import {readFileSync, readdirSync, writeFileSync} from "node:fs";

const [engine, output] = process.argv.slice(2);
const folder = new URL("page/", import.meta.url), catalogue = new URL("../../tableaux/catalogue/", import.meta.url);
const text = (name) => readFileSync(new URL(name, folder), "utf8");
// Inside an element of HTML nothing may look like its end.
const inside = (script) => script.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");

const methods = {};
for (const name of readdirSync(catalogue).filter((file) => file.endsWith(".json")))
  methods[name.slice(0, -5)] = JSON.parse(readFileSync(new URL(name, catalogue), "utf8"));

const page = text("index.html")
  .replace(/<link rel="stylesheet" href="([^"]+)">/, (_, name) => `<style>\n${text(name)}</style>`)
  .replace(/(<script [^>]*id="methods">)/, (start) => start + inside(JSON.stringify(methods)))
  .replace(/(<script [^>]*id="engine">)/, (start) => start + inside(readFileSync(engine, "utf8")))
  .replace(/<script src="([^"]+)"><\/script>/g, (_, name) => `<script>\n${inside(text(name))}</script>`);
writeFileSync(output, page);
