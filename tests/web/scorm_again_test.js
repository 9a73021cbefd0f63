// node tests/web/scorm_again_test.js FOLDER: the page's side of SCORM against the runtime scorm-again of npm, unpacked in
// FOLDER (tests/web/platform_tests.py fetches it). Every value that the page writes must be taken without an error.
"use strict";
const assert = require("node:assert"), fs = require("node:fs"), path = require("node:path"), vm = require("node:vm");
const source = require("./platform_source.js");
const dist = path.join(process.argv[2], "package", "dist");

function runtime(file, name) {
  const context = vm.createContext({console: {log() {}, info() {}, warn() {}, error() {}, debug() {}}, setTimeout, clearTimeout,
                                    setInterval, clearInterval, URL, Blob, TextEncoder, TextDecoder});
  context.window = context.self = context.globalThis = context;
  context.addEventListener = context.removeEventListener = () => {};
  vm.runInContext(fs.readFileSync(path.join(dist, file), "utf8"), context);
  return new (vm.runInContext(name, context))({autocommit: false, logLevel: 5});
}

const task = {id: "task_one_1", text: "Touch it.", kind: "task", judged: "marked", right: true, attempt: 1, choices: [], chosen: [],
              right_choices: [], written: "", misconceptions: [], goals: [0], t: 3.2, at: "2026-11-21T10:58:17Z", latency_s: 3.21};
const wrong = {...task, id: "question_f.c3.bcr-alle_which", text: "Which?", kind: "choice", right: false, choices: ["this", "that", "both"], chosen: [0],
               right_choices: [1, 2], misconceptions: ["Takes this für that"], t: 4, latency_s: 4000.5};
const typed = {...task, id: "question_two_how-much", kind: "typed", written: "2.5 Å", t: 5};
const free = {...typed, id: "question_two_why", judged: "free", written: "because", t: 6};
const prediction = {...wrong, id: "question_two_felt", judged: "prediction", t: 7};
const record = {began: "2026-11-21T10:58:14Z", t: 8.5, step: "two", place: "two/task 1", done: 2, of: 3, complete: false, score: 2 / 3,
                objectives: [{id: "goal_1", text: "Fühle", done: 1, of: 2, score: 0.5}, {id: "goal_2", text: "Sage", done: 0, of: 0, score: null}],
                interactions: [task, wrong, typed, free, prediction], interaction_count: 5,
                suspended: JSON.stringify(["moltact", 1, "2026-11-21T10:58:14Z", 1, 8.5, "1.0000", 2, 3, [], [], "x".repeat(3900)])};

const kNow_ms = Date.UTC(2026, 10, 21, 10, 58, 23);

(async () => {
  for (const [version, file, name, api_name] of [["1.2", "scorm12.js", "Scorm12API", "API"], ["2004", "scorm2004.js", "Scorm2004API", "API_1484_11"]]) {
    const api = runtime(file, name), refused = [];
    const old = version === "1.2", set = old ? "LMSSetValue" : "SetValue", error = old ? "LMSGetLastError" : "GetLastError";
    const seen = new Proxy(api, {get(target, key) {
      if (key !== set) return typeof target[key] === "function" ? target[key].bind(target) : target[key];
      return (element, value) => {
        const result = target[set](element, value);
        if (String(result) !== "true") refused.push(`${element} = ${value}: ${target[error]()}`);
        return result;
      };
    }});
    const page = vm.runInNewContext(source + ";moltactPlatform", {console, crypto, TextEncoder, URL, URLSearchParams, setInterval() {}});
    const window = {[api_name]: seen, location: {pathname: "/a/index.html", search: ""}, document: {}};
    window.parent = window.top = window;
    const link = await page.find(version, "urn:uuid:1", window);
    const news = [], reporter = new page.Reporter(link, {record: () => JSON.stringify(record), news: (what) => news.push(what)});
    await reporter.step(false, kNow_ms);
    assert.deepStrictEqual(refused, [], version);
    assert.deepStrictEqual(news, []);
    const cmi = JSON.parse(api.cmi.constructor && JSON.stringify(api.cmi));
    const core = old ? cmi.core : cmi;
    assert.strictEqual(cmi.suspend_data, record.suspended);
    assert.strictEqual(old ? core.lesson_status : core.completion_status, "incomplete");
    assert.strictEqual(String(core.score.raw), "66.67");
    const list = cmi.interactions.childArray ?? Object.values(cmi.interactions);
    assert.strictEqual(list.length, 5);
    assert.deepStrictEqual(list.map((i) => i.result), ["correct", old ? "wrong" : "incorrect", "correct", "neutral", "neutral"]);
    await reporter.step(true, kNow_ms + 1000);
    assert.deepStrictEqual(refused, [], version);
  }
  console.log("scorm-again takes every value");
})().catch((error) => { console.error(error); process.exit(1); });
