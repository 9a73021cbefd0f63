// The worker in which a page simulates a molecule. It stands behind moltact_openmm.js, whose functions are those of
// engine/dynamics/openmm_worker.cpp. The first message is {bytes, system, start}: the WebAssembly module, a text, and
// numbers; each later one is a command, numbers. Answers: {kind, text, numbers}, of which `kind` is
// "facts", "frame" or "refusal"; an error of the worker itself ends it.
let openmm = null;

function giveText(text) {
  const bytes = new TextEncoder().encode(text);
  openmm.HEAPU8.set(bytes, openmm._simulation_text_room(bytes.length));
}

function giveNumbers(numbers) {
  const at = openmm._simulation_number_room(numbers.length);
  openmm.HEAPF64.set(numbers, at >> 3);
}

function answer(kind) {
  const at = openmm._simulation_numbers() >> 3;
  const numbers = openmm.HEAPF64.slice(at, at + openmm._simulation_number_count());
  postMessage({kind, text: openmm.UTF8ToString(openmm._simulation_text()), numbers}, [numbers.buffer]);
}

// An error in a promise does not reach the page as an error of the worker; one in a timer does.
const fail = (error) => setTimeout(() => { throw error; });

onmessage = ({data}) => {
  if (openmm) {
    giveNumbers(data);
    openmm._simulation_advance();
    return answer("frame");
  }
  createMoltactOpenMM({wasmBinary: data.bytes, printErr: console.warn}).then((made) => {
    openmm = made;
    giveText(data.system);
    giveNumbers(data.start);
    answer(openmm._simulation_open() ? "facts" : "refusal");
  }).catch(fail);
};
