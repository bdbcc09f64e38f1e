"use strict";
// The engine runs in a worker, made from the text in this page so that it works from disk as well. One question at a time
// is decided; what is asked meanwhile on the same subject replaces what waits.
const engine = (() => {
  const worker_text = `
    const ready = stagecraftEngine();
    onmessage = async ({data: {id, name, words}}) => {
      let answer;
      try {
        const module = await ready;
        answer = JSON.parse(module.ccall("stagecraft_" + name, "string", words.map(() => "string"), words));
      } catch (e) {  // of the engine itself: it starts anew
        answer = {error: "not decided: " + (e.message || e), exit_code: 3, broken: true};
      }
      postMessage({id, answer});
    };`;
  const patience = 1500;  // ms after which a decision that nobody waits for any more is given up
  let worker = null, running = null, waiting = [], last = 0;
  const watchers = [];

  function start() {
    const url = URL.createObjectURL(
      new Blob([document.getElementById("engine").textContent, worker_text], {type: "text/javascript"}));
    worker = new Worker(url);
    worker.onmessage = ({data}) => finish(data.id, data.answer);
    worker.onerror = (e) => finish(last, {error: `this browser cannot run the engine: ${e.message}`, exit_code: 3});
  }

  function stop(reason) {
    if (!running) return;
    worker.terminate();
    start();
    finish(running.id, {error: reason, exit_code: 3});
  }

  function finish(id, answer) {
    if (!running || running.id !== id) return;
    const {resolve, timer} = running;
    clearTimeout(timer);
    running = null;
    if (answer.broken) {
      worker.terminate();
      start();
    }
    next();
    resolve(answer);
  }

  function next() {
    if (!running && waiting.length) {
      running = waiting.shift();
      last = running.id;
      running.since = performance.now();
      const seconds = engine.limit;
      running.timer = setTimeout(() => stop(`not decided within the time limit of ${seconds} s`), 1000 * seconds);
      worker.postMessage({id: running.id, name: running.name, words: running.words});
    }
    watchers.forEach((watch) => watch(Boolean(running)));
  }

  let count = 0;
  start();
  return {
    limit: 20,
    /// What the engine's function answers; null where a later question on the same subject came first.
    ask(subject, name, ...words) {
      return new Promise((resolve) => {
        waiting = waiting.filter((q) => q.subject !== subject || void q.resolve(null));
        waiting.push({id: ++count, subject, name, words, resolve});
        if (running && running.subject === subject && performance.now() - running.since > patience) {
          running.resolve(null);
          running.resolve = () => {};
          stop("");
        } else {
          next();
        }
      });
    },
    cancel() {
      waiting.forEach((q) => q.resolve(null));
      waiting = [];
      stop("cancelled");
    },
    watch(f) {
      watchers.push(f);
    },
  };
})();
