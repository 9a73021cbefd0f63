// Simulations in workers, for engine/dynamics/begin_simulation_web.cpp. `unpacked` returns what came with the page under
// a name; the worker's script and module are unpacked when the first simulation begins. `stir` requests frames.
function moltactSimulations(unpacked, stir) {
  "use strict";
  const kKinds = {facts: 1, frame: 2, refusal: 3, end: 4};
  const all = new Map();  // by number: {worker, waiting: [{kind, text, numbers}], newest: the last taken}
  const kNothing = {kind: "", text: "", numbers: new Float64Array()};
  let last = 0, parts = null;

  function hear(one, message) {
    if (one.closed) return;
    one.waiting.push(message);
    stir();
  }

  const end = (one, why) => hear(one, {kind: "end", text: String(why), numbers: kNothing.numbers});

  async function start(one, system, numbers) {
    try {
      parts ??= Promise.all([unpacked("simulation-script"), unpacked("simulation-bytes")]);
      const [script, bytes] = await parts;
      if (one.closed) return;
      const url = URL.createObjectURL(new Blob([script], {type: "text/javascript"}));
      one.worker = new Worker(url);
      one.worker.onmessage = ({data}) => { URL.revokeObjectURL(url); hear(one, data); };
      one.worker.onerror = (event) => { event.preventDefault(); end(one, event.message || "worker"); };
      one.worker.postMessage({bytes, system, start: numbers});
    } catch (error) {
      parts = null;  // the next one unpacks them again
      end(one, error);
    }
  }

  return {
    all,  // for debugging
    open(system, numbers) {
      const one = {worker: null, waiting: [], newest: kNothing, closed: false};
      all.set(++last, one);
      start(one, system, numbers);
      return last;
    },
    close(number) {
      const one = all.get(number);
      if (!one) return;
      one.closed = true;
      if (one.worker) one.worker.terminate();
      all.delete(number);
    },
    ask(number, numbers) { all.get(number)?.worker?.postMessage(numbers, [numbers.buffer]); },
    news(number) {
      const one = all.get(number);
      if (!one || !one.waiting.length) return 0;
      one.newest = one.waiting.shift();
      return kKinds[one.newest.kind] ?? kKinds.end;
    },
    text: (number) => (all.get(number)?.newest ?? kNothing).text,
    numbers: (number) => (all.get(number)?.newest ?? kNothing).numbers,
  };
}
