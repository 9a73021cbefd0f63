// A small, strict SCORM runtime for tests, after the run-time environments of SCORM 1.2 (section 3.4) and SCORM 2004 4th
// edition (section 4.2): it takes only elements of this table in their formats and sizes, keeps lists without gaps, and
// notes every call that a platform would refuse in `faults`. In Node and in a page.
"use strict";

const scormRuntime = (() => {
  const any = (most) => (v) => [...v].length <= most;
  const match = (pattern, most = 4000) => (v) => pattern.test(v) && v.length <= most;
  const word = (...words) => (v) => words.includes(v);
  const number = (low, high) => (v) => /^-?\d+(\.\d+)?$/.test(v) && Number(v) >= low && Number(v) <= high;
  const percent = number(0, 100), ascii = match(/^[\x21-\x7e]+$/, 255);
  const span12 = match(/^\d{2,4}:[0-5]\d:[0-5]\d(\.\d{1,2})?$/), time12 = match(/^[0-2]\d:[0-5]\d:[0-5]\d(\.\d{1,2})?$/);
  const span2004 = match(/^P(\d+Y)?(\d+M)?(\d+D)?(T(\d+H)?(\d+M)?(\d+(\.\d{1,2})?S)?)?$/);
  const time2004 = match(/^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d{1,2}Z?)?$/);
  const score12 = (at) => ({[`${at}.raw`]: percent, [`${at}.min`]: percent, [`${at}.max`]: percent});
  const score2004 = (at) => ({...score12(at), [`${at}.scaled`]: number(-1, 1)});
  const letters = match(/^[a-z0-9](,[a-z0-9])*$/, 255);

  const kModels = {
    "1.2": {
      "cmi.core.lesson_location": any(255),
      "cmi.core.lesson_status": word("passed", "completed", "failed", "incomplete", "browsed"),
      ...score12("cmi.core.score"),
      "cmi.core.session_time": span12,
      "cmi.core.exit": word("time-out", "suspend", "logout", ""),
      "cmi.suspend_data": (v) => v.length <= 4096 && /^[\x20-\x7e]*$/.test(v),
      "cmi.objectives.n.id": ascii,
      ...score12("cmi.objectives.n.score"),
      "cmi.objectives.n.status": word("passed", "completed", "failed", "incomplete", "browsed", "not attempted"),
      "cmi.interactions.n.id": ascii,
      "cmi.interactions.n.objectives.n.id": ascii,
      "cmi.interactions.n.time": time12,
      "cmi.interactions.n.type": word("true-false", "choice", "fill-in", "matching", "performance", "likert", "sequencing", "numeric"),
      "cmi.interactions.n.correct_responses.n.pattern": letters,
      "cmi.interactions.n.student_response": any(255),
      "cmi.interactions.n.result": (v) => word("correct", "wrong", "unanticipated", "neutral")(v),
      "cmi.interactions.n.latency": span12,
    },
    "2004": {
      "cmi.location": any(1000),
      "cmi.completion_status": word("completed", "incomplete", "not attempted", "unknown"),
      "cmi.progress_measure": number(0, 1),
      ...score2004("cmi.score"),
      "cmi.session_time": span2004,
      "cmi.exit": word("time-out", "suspend", "logout", "normal", ""),
      "cmi.suspend_data": any(64000),
      "cmi.objectives.n.id": match(/^[A-Za-z0-9._~:/?#@!$&'()*+,;=%-]+$/),
      "cmi.objectives.n.description": any(250),
      ...score2004("cmi.objectives.n.score"),
      "cmi.objectives.n.completion_status": word("completed", "incomplete", "not attempted", "unknown"),
      "cmi.objectives.n.progress_measure": number(0, 1),
      "cmi.interactions.n.id": match(/^[A-Za-z0-9._~:/?#@!$&'()*+,;=%-]+$/),
      "cmi.interactions.n.type": word("true-false", "choice", "fill-in", "long-fill-in", "matching", "performance", "likert",
                                      "sequencing", "numeric", "other"),
      "cmi.interactions.n.objectives.n.id": match(/^[A-Za-z0-9._~:/?#@!$&'()*+,;=%-]+$/),
      "cmi.interactions.n.timestamp": time2004,
      "cmi.interactions.n.correct_responses.n.pattern": match(/^\w+(\[,\]\w+)*$/),
      "cmi.interactions.n.learner_response": any(4000),
      "cmi.interactions.n.result": (v) => word("correct", "incorrect", "unanticipated", "neutral")(v) || number(-1e9, 1e9)(v),
      "cmi.interactions.n.latency": span2004,
      "cmi.interactions.n.description": any(250),
    },
  };
  // Set by the platform; SCORM 1.2 lets nobody read interactions.
  const kRead = {
    "1.2": ["cmi.core.student_id", "cmi.core.student_name", "cmi.core.lesson_mode", "cmi.core.entry", "cmi.core.total_time"],
    "2004": ["cmi.learner_id", "cmi.learner_name", "cmi.mode", "cmi.entry", "cmi.total_time"],
  };

  /// `kept`: the values by element, which the test keeps from one session to the next. `options.lost()` is true while the
  /// connection is lost; `options.interactions` is false for a platform that takes none. `options.refuses(element)` is true
  /// where the platform answers "false" to a value, and may throw.
  function make(version, kept, options = {}) {
    const model = kModels[version], values = {...kept}, faults = [], old = version === "1.2";
    let state = "new", commits = 0, error = "0";
    const fault = (...what) => { faults.push(what.join(" ")); return "false"; };
    const general = (element) => element.replace(/\.\d+(?=\.|$)/g, ".n");
    const count = (list) => {
      const found = new Set();
      for (const element of Object.keys(values))
        if (element.startsWith(list + ".")) found.add(element.slice(list.length + 1).split(".")[0]);
      return found.size;
    };
    const api = {
      initialize: (x) => state !== "new" || x !== "" ? fault("Initialize in state", state) : (state = "running", "true"),
      get(element) {
        if (state !== "running") return fault("GetValue in state", state), "";
        if (options.interactions === false && element.startsWith("cmi.interactions")) return error = "401", "";
        if (/\._count$/.test(element)) return String(count(element.slice(0, -7)));
        if (old && element.startsWith("cmi.interactions.")) return fault("GetValue of", element), "";
        if (!model[general(element)] && !kRead[version].includes(element)) return fault("GetValue of", element), "";
        return values[element] ?? "";
      },
      set(element, value) {
        if (state !== "running") return fault("SetValue in state", state);
        if (typeof value !== "string") return fault("SetValue of no text", element);
        if (options.interactions === false && element.startsWith("cmi.interactions.")) return error = "401", "false";
        if (options.refuses && options.refuses(element)) return error = "101", "false";
        const takes = model[general(element)];
        if (!takes) return fault("SetValue of", element);
        if (!takes(value)) return fault("SetValue", element, value);
        const parts = element.split(".");
        for (let k = 1; k < parts.length; ++k)
          if (/^\d+$/.test(parts[k]) && Number(parts[k]) > count(parts.slice(0, k).join("."))) return fault("gap before", element);
        const id = element.replace(/^(cmi\.(?:interactions|objectives)\.\d+)\..*$/, "$1.id");
        if (id !== element && /^cmi\.(interactions|objectives)\.\d+\./.test(element) && !(id in values)) return fault("no id before", element);
        if (!old && /correct_responses|learner_response/.test(element) && !(id.replace(/id$/, "type") in values))
          return fault("no type before", element);
        values[element] = value;
        return "true";
      },
      commit(x) {
        if (state !== "running" || x !== "") return fault("Commit in state", state);
        if (options.lost && options.lost()) return "false";
        ++commits;
        for (const element of Object.keys(kept)) delete kept[element];
        Object.assign(kept, values);
        return "true";
      },
      terminate(x) {
        if (state !== "running" || x !== "") return fault("Terminate in state", state);
        // SCORM 1.2, lesson_status: a platform may conclude so where the lesson told it nothing.
        if (old && !values["cmi.core.lesson_status"]) values["cmi.core.lesson_status"] = "completed";
        api.commit("");
        state = "over";
        return "true";
      },
    };
    const names = old ? {LMSInitialize: "initialize", LMSGetValue: "get", LMSSetValue: "set", LMSCommit: "commit", LMSFinish: "terminate"}
                      : {Initialize: "initialize", GetValue: "get", SetValue: "set", Commit: "commit", Terminate: "terminate"};
    const out = {[old ? "LMSGetLastError" : "GetLastError"]: () => error};
    for (const [name, own] of Object.entries(names)) out[name] = api[own];
    return {api: out, faults, values, state: () => state, commits: () => commits};
  }
  return {make};
})();
if (typeof module === "object") module.exports = scormRuntime;
