// node tests/web/platform_test.js: the page's side of a learning platform (app/web/platform.js, cmi5.js) against a strict SCORM
// runtime and a record store, both written here after the standards.
"use strict";
const assert = require("node:assert"), vm = require("node:vm");
const runtime = require("./scorm_runtime.js");
const source = require("./platform_source.js");

class Storage {
  constructor() { this.all = new Map(); }
  getItem(key) { return this.all.has(key) ? this.all.get(key) : null; }
  setItem(key, text) { this.all.set(key, String(text)); }
  removeItem(key) { this.all.delete(key); }
}
// A browser: what the script sees. `stored` lasts as a profile does.
function browser(stored = new Storage(), more = {}) {
  return vm.runInNewContext(source + ";moltactPlatform", {
    localStorage: stored, sessionStorage: new Storage(), console: {warn() {}}, URL, URLSearchParams, TextEncoder, AbortSignal, crypto,
    structuredClone, setInterval() {}, ...more,
  });
}
function windowWith(api, name, depth = 0) {
  let at = {[name]: api, document: {}};
  at.parent = at;
  for (let k = 0; k < depth; ++k) at = {parent: at};
  at.location = at.location || {pathname: "/mod/7/index.html", search: ""};
  at.top = at;
  return at;
}

const suspended = (began, t) => JSON.stringify(["moltact", 1, began, 1, t, "0.0000", 0, 3, [], []]);
const kBegan = "2026-11-21T10:58:14Z";
// As learningRecordJson() writes it.
function record(t, {began = kBegan, done = 0, complete = false, score = 0, interactions = [], text = suspended(began, t)} = {}) {
  return (limit, from) => JSON.stringify({
    began, t, step: "one", place: "one/task 1", done, of: 3, complete, score,
    objectives: [{id: "goal_1", text: "Fühle es", done, of: 2, score}], interactions: interactions.slice(from),
    interaction_count: interactions.length, suspended: text});
}
const task = {id: "task_one_1", text: "Touch it.", kind: "task", judged: "marked", right: true, attempt: 1, choices: [], chosen: [],
              right_choices: [], written: "", misconceptions: [], goals: [0], t: 3.2, at: "2026-11-21T10:58:17Z", latency_s: 3.2};
const wrong = {...task, id: "question_one_which", text: "Which?".padEnd(300, "ü"), kind: "choice", right: false, choices: ["this", "that", "both"],
               chosen: [0], right_choices: [1, 2], misconceptions: ["Takes this für that"], t: 4, at: "2026-11-21T10:58:18Z", latency_s: 4000.05};
const free = {...task, id: "question_one_why", kind: "typed", judged: "free", written: "x[,]y " + "w".repeat(300), t: 9, latency_s: 5};

const kVersions = {
  "1.2": {api: "API", wrong: "wrong", status: "cmi.core.lesson_status", score: "cmi.core.score.raw", time: "cmi.core.session_time", hour: "0001:06:40.05",
          exit: "cmi.core.exit", response: "student_response", chosen: "a", right: "b,c", learner: "cmi.core.student_id", mode: "cmi.core.lesson_mode"},
  "2004": {api: "API_1484_11", wrong: "incorrect", status: "cmi.completion_status", score: "cmi.score.raw", time: "cmi.session_time", hour: "PT4000.05S",
           exit: "cmi.exit", response: "learner_response", chosen: "choice_1", right: "choice_2[,]choice_3", learner: "cmi.learner_id", mode: "cmi.mode"},
};

async function scorm(version) {
  const words = kVersions[version], kept = {[words.learner]: "ada", [words.mode]: "normal"}, stored = new Storage();
  const open = async (into, storage, options) => {
    const lms = runtime.make(version, into, options), page = browser(storage);
    const link = await page.find(version, "urn:uuid:1", windowWith(lms.api, words.api, 3));
    const heard = [];
    const program = {record: () => "", news: (what) => heard.push(what)};
    return {lms, link, heard, program, reporter: new page.Reporter(link, program)};
  };

  // A first session: nothing is told before something is done; then an answer is told once, with all that belongs to it.
  let lost = false;
  const a = await open(kept, stored, {lost: () => lost});
  assert.strictEqual(a.reporter.suspended, "");
  await a.reporter.step(false, 1000);
  assert.strictEqual(a.lms.commits(), 0);
  a.program.record = record(4, {done: 1, score: 1 / 3, interactions: [task, wrong]});
  await a.reporter.step(false, 2000);
  await a.reporter.step(false, 4000);  // nothing new
  assert.deepStrictEqual(a.lms.faults, []);
  assert.strictEqual(a.lms.commits(), 1);
  assert.strictEqual(kept[words.status], "incomplete");
  assert.strictEqual(kept[words.score], "33.33");
  assert.strictEqual(kept["cmi.suspend_data"], suspended(kBegan, 4));
  assert.strictEqual(kept["cmi.objectives.0.id"], "goal_1");
  assert.strictEqual(kept["cmi.interactions.0.id"], "task_one_1");
  assert.strictEqual(kept["cmi.interactions.0.result"], "correct");
  assert.strictEqual(kept["cmi.interactions.1.result"], words.wrong);
  assert.strictEqual(kept["cmi.interactions.1.latency"], words.hour);
  assert.strictEqual(kept["cmi.interactions.1." + words.response], words.chosen);
  assert.strictEqual(kept["cmi.interactions.1.correct_responses.0.pattern"], undefined);  // the question is open yet
  assert.strictEqual(kept["cmi.interactions.1.objectives.1.id"], "misconception_takes-this-f.c3.bcr-that");
  assert.strictEqual(kept["cmi.interactions.2.id"], undefined);

  // The connection is lost: it is said once, what is done stays in the browser, and is sent when it is back.
  lost = true;
  a.program.record = record(9, {done: 2, score: 1 / 3, interactions: [task, wrong, free]});
  await a.reporter.step(false, 6000);
  await a.reporter.step(false, 8000);
  await a.reporter.step(false, 17000);
  assert.deepStrictEqual(a.heard, [0]);
  assert.strictEqual(stored.getItem("moltact/unsent/" + a.link.storage), suspended(kBegan, 9));
  assert.strictEqual(kept["cmi.interactions.2.id"], undefined);
  lost = false;
  await a.reporter.step(false, 28000);
  assert.deepStrictEqual(a.heard, [0, 1]);
  assert.strictEqual(stored.getItem("moltact/unsent/" + a.link.storage), null);
  assert.strictEqual(kept["cmi.interactions.2.id"], "question_one_why");
  assert.strictEqual(kept["cmi.interactions.2.result"], "neutral");

  // Lost again when the page closes: this browser goes on from what it kept, another from what the platform has.
  lost = true;
  a.program.record = record(12, {done: 2, score: 1 / 3, interactions: [task, wrong, free]});
  await a.reporter.step(true, 30000);
  assert.strictEqual(a.lms.state(), "over");
  assert.deepStrictEqual(a.lms.faults, []);
  assert.strictEqual((await open({...kept}, stored)).reporter.suspended, suspended(kBegan, 12));
  assert.strictEqual((await open({...kept}, new Storage())).reporter.suspended, suspended(kBegan, 9));

  // On another computer the list goes on behind the 3 interactions of the platform; none is sent twice. The lesson is
  // finished, and a new beginning does not take that back.
  const b = await open(kept, new Storage());
  const late = {...task, id: "task_two_1", t: 20, at: "2026-11-22T08:00:00Z"};
  b.program.record = record(20, {done: 3, complete: true, score: 2 / 3, interactions: [task, wrong, free, late]});
  await b.reporter.step(false, 1000);
  assert.strictEqual(kept["cmi.interactions.3.id"], "task_two_1");
  assert.strictEqual(kept["cmi.interactions.4.id"], undefined);
  assert.strictEqual(kept[words.time], version === "1.2" ? "0000:00:11.00" : "PT11S");  // since 9 s
  assert.strictEqual(kept[words.status], "completed");
  assert.strictEqual(kept["cmi.objectives.1.id"], undefined);
  b.program.record = record(5, {began: "2026-11-22T09:00:00Z", interactions: [{...task, t: 5}]});
  await b.reporter.step(false, 3000);
  assert.strictEqual(kept[words.status], "completed");
  assert.strictEqual(kept[words.score], "66.67");
  assert.strictEqual(kept["cmi.interactions.4.id"], "task_one_1");
  assert.strictEqual(kept[words.time], version === "1.2" ? "0000:00:16.00" : "PT16S");
  await b.reporter.step(true, 4000);
  assert.strictEqual(kept[words.exit], "suspend");
  assert.deepStrictEqual(b.lms.faults, []);

  // A platform without interactions, and one that only shows the lesson.
  const poor = {[words.learner]: "bo", [words.mode]: "normal"}, c = await open(poor, stored, {interactions: false});
  c.program.record = record(4, {done: 1, interactions: [task, wrong]});
  await c.reporter.step(false, 1000);
  assert.strictEqual(poor["cmi.suspend_data"], suspended(kBegan, 4));
  assert.notStrictEqual(c.link.storage, a.link.storage);  // another learner of the same computer
  const shown = {[words.learner]: "bo", [words.mode]: "review"}, d = await open(shown, stored);
  d.program.record = record(4, {done: 1, interactions: [task]});
  await d.reporter.step(false, 1000);
  await d.reporter.step(true, 2000);
  if (version === "1.2") delete shown[words.status];  // the platform's own conclusion
  assert.deepStrictEqual(Object.keys(shown).sort(), [words.learner, words.mode].sort());
  // What is done in a review stays out of the learner's own work, also in this browser.
  const real = await open({...shown, [words.mode]: "normal"}, stored);
  assert.notStrictEqual(d.link.storage, real.link.storage);
  assert.strictEqual(real.reporter.suspended, "");
  const before = {...kept, [words.mode]: "Review"}, e = await open(before, stored, {lost: () => true});
  e.program.record = record(99, {done: 3, interactions: [task]});
  await e.reporter.step(false, 1000);
  assert.deepStrictEqual(e.heard, []);  // nothing is lost where nothing is sent
  await e.reporter.step(true, 2000);
  assert.strictEqual(before["cmi.suspend_data"], kept["cmi.suspend_data"]);
  assert.notStrictEqual((await open({...kept}, stored)).reporter.suspended, suspended(kBegan, 99));
}

async function scormFaults(version) {
  const words = kVersions[version], learner = {[words.learner]: "ada", [words.mode]: "normal"};
  const open = async (into, storage = new Storage(), options = {}) => {
    const lms = runtime.make(version, into, options);
    const page = browser(storage), link = await page.find(version, "urn:uuid:1", windowWith(lms.api, words.api));
    const heard = [], program = {record: () => "", news: (what) => heard.push(what)};
    return {lms, link, heard, program, reporter: new page.Reporter(link, program)};
  };

  // Opened and closed before the first deed: not completed, and the next visit goes on.
  const idle = {...learner}, a = await open(idle);
  await a.reporter.step(true, 1000);
  assert.strictEqual(a.lms.state(), "over");
  assert.strictEqual(idle[words.status], "incomplete");
  assert.strictEqual(idle[words.exit], "suspend");
  assert.strictEqual((await open(idle)).link.complete, false);
  a.program.record = record(4, {done: 1, interactions: [task]});
  await a.reporter.step(false, 2000);  // a look after the end calls nothing
  await a.reporter.step(true, 3000);
  assert.deepStrictEqual(a.lms.faults, []);

  // Damaged data: the lesson begins, and its time is told.
  const damaged = {...learner, "cmi.suspend_data": "of another program"}, b = await open(damaged);
  b.program.record = record(7, {done: 1, interactions: [task]});
  await b.reporter.step(false, 1000);
  assert.deepStrictEqual(b.lms.faults, []);
  assert.strictEqual(damaged[words.time], version === "1.2" ? "0000:00:07.00" : "PT7S");

  // A new attempt, which the teacher began, does not find the work of the old one in this browser; unsent work of an
  // attempt that the platform never had does.
  const browser_1 = new Storage(), first = {...learner}, c = await open(first, browser_1);
  c.program.record = record(5, {done: 1, interactions: [task]});
  await c.reporter.step(false, 1000);
  c.program.record = record(8, {done: 1, interactions: [task]});
  await c.reporter.step(true, 2000);
  assert.strictEqual(browser_1.getItem("moltact/unsent/" + c.link.storage), null);  // the last commit was acknowledged
  assert.strictEqual(first["cmi.suspend_data"], suspended(kBegan, 8));
  const lost = await open({...first}, browser_1, {lost: () => true});
  lost.program.record = record(12, {done: 2, interactions: [task]});
  await lost.reporter.step(true, 1000);
  assert.strictEqual((await open({...first}, browser_1)).reporter.suspended, suspended(kBegan, 12));
  assert.strictEqual((await open({...learner}, browser_1)).reporter.suspended, "");
  const unsent = await open({...learner}, browser_1, {lost: () => true});
  unsent.program.record = record(3, {began: "2026-11-25T08:00:00Z", done: 1, interactions: [task]});
  await unsent.reporter.step(true, 1000);
  assert.strictEqual((await open({...learner}, browser_1)).reporter.suspended, suspended("2026-11-25T08:00:00Z", 3));

  // "false" for an interaction, and an exception in the middle of one: it is sent later, once, and in order.
  for (const how of ["false", "throw", "throw in the middle"]) {
    let refusing = true;
    const refuses = (element) => {
      if (!refusing || !element.startsWith("cmi.interactions.0." + (how === "throw in the middle" ? "result" : ""))) return false;
      if (how === "false") return true;
      throw new Error("the frame is gone");
    };
    const into = {...learner}, d = await open(into, new Storage(), {refuses});
    d.program.record = record(4, {done: 1, interactions: [task, wrong]});
    await d.reporter.step(false, 1000);
    assert.deepStrictEqual(d.heard, [0], how);
    assert.strictEqual(into["cmi.suspend_data"], undefined);  // the next visit would send the interactions
    refusing = false;
    await d.reporter.step(false, 12000);
    assert.deepStrictEqual(d.heard, [0, 1], how);
    assert.strictEqual(into["cmi.interactions.0.id"], "task_one_1");
    assert.strictEqual(into["cmi.interactions.0.result"], "correct");
    assert.strictEqual(into["cmi.interactions.1.id"], "question_one_which");
    assert.strictEqual(into["cmi.interactions.2.id"], undefined);
    assert.strictEqual(into["cmi.suspend_data"], suspended(kBegan, 4));
    assert.deepStrictEqual(d.lms.faults, []);
  }
  // A platform that goes on refusing one, while it takes everything else, gets the others.
  const into = {...learner};
  let bad = false;
  const picky = await open(into, new Storage(), {refuses: (element) => bad && element === "cmi.interactions.1.id"});
  picky.program.record = record(4, {done: 1, interactions: [task]});
  await picky.reporter.step(false, 1000);
  bad = true;
  picky.program.record = record(9, {done: 1, interactions: [task, wrong, free]});
  for (const now_ms of [2000, 13000, 24000]) await picky.reporter.step(false, now_ms);
  bad = false;
  await picky.reporter.step(false, 35000);
  assert.deepStrictEqual(picky.heard, [0, 1]);
  assert.deepStrictEqual([0, 1, 2].map((n) => into[`cmi.interactions.${n}.id`]), ["task_one_1", "question_one_why", undefined]);

  // The time of an answer is the clock's, although the time of use stood still in a pause of an hour. Two choices with one
  // misconception name it once. The right choices come with the right answer.
  const timed = {...learner}, f = await open(timed), noon_ms = Date.UTC(2026, 10, 21, 12, 0, 0);
  f.program.record = record(3.2, {done: 1, interactions: [task]});
  await f.reporter.step(false, noon_ms);
  const twice = {...wrong, misconceptions: ["Same", "Same"], t: 10}, right = {...wrong, right: true, chosen: [1, 2], misconceptions: [], attempt: 2, t: 12};
  f.program.record = record(14, {done: 1, interactions: [task, twice, right]});
  await f.reporter.step(false, noon_ms + 3600e3);
  const local = new Date(noon_ms + 3600e3 - 4000).toTimeString().slice(0, 8);
  assert.strictEqual(timed["cmi.interactions.1." + (version === "1.2" ? "time" : "timestamp")],
                     version === "1.2" ? local : "2026-11-21T12:59:56.00Z");
  assert.strictEqual(timed["cmi.interactions.1.objectives.1.id"], "misconception_same");
  assert.strictEqual(timed["cmi.interactions.1.objectives.2.id"], undefined);
  assert.strictEqual(timed["cmi.interactions.2.correct_responses.0.pattern"], words.right);

  // Suspended data that had to be shortened lower neither score nor goal of their attempt; a new attempt does.
  const short = {...learner}, g = await open(short), goal = words.score.replace(/cmi.*score/, "cmi.objectives.0.score");
  g.program.record = record(5, {done: 2, score: 2 / 3});
  await g.reporter.step(true, 1000);
  const h = await open(short);
  h.program.record = record(6, {done: 1, score: 1 / 3});
  await h.reporter.step(false, 1000);
  assert.strictEqual(short[words.score], "66.67");
  assert.strictEqual(short[goal], "66.67");
  assert.strictEqual(short["cmi.objectives.0." + (version === "1.2" ? "status" : "completion_status")], "completed");
  h.program.record = record(1, {began: "2026-11-25T08:00:00Z", done: 0, score: 0});
  await h.reporter.step(false, 3000);
  assert.strictEqual(short[words.score], "0");
  assert.strictEqual(short[goal], "66.67");  // a finished goal stays so
  assert.strictEqual(short["cmi.objectives.0." + (version === "1.2" ? "status" : "completion_status")], "completed");

  // A platform that names no learner: what this browser keeps might be another's.
  const shared = new Storage(), nobody = {[words.mode]: "normal"}, k = await open(nobody, shared, {lost: () => true});
  k.program.record = record(5, {done: 1, interactions: [task]});
  await k.reporter.step(true, 1000);
  const next = await open({[words.mode]: "normal"}, shared);
  assert.strictEqual(next.reporter.suspended, "");
  assert.notStrictEqual(next.link.storage, k.link.storage);
  assert.strictEqual(shared.all.size, 0);
}

// ---- a record store -----------------------------------------------------------------------------------------------------

// What cmi5 requires of each request and statement (cmi5 1st edition, sections 7 to 10); xAPI 1.0.3.
function recordStore() {
  // A launch has a session and a token of its own. `refuses(statement)` gives the status of a request that is refused.
  const store = {statements: [], states: new Map(), faults: [], lost: false, lose_answer: false, tokens: new Set(), session: "s1",
                 state_fails: false, refuses: () => 0, closing: 0};
  const reply = (status, body) => ({status, ok: status < 300, json: async () => body});
  const must = (holds, what) => { if (!holds) store.faults.push(what); };
  const kCmi5 = "https://w3id.org/xapi/cmi5/context/categories/";
  store.launch = {contextTemplate: {contextActivities: {grouping: [{id: "urn:uuid:1"}]},
                                    get extensions() { return {"https://w3id.org/xapi/cmi5/context/extensions/sessionid": store.session}; }},
                  launchMode: "Normal", moveOn: "Completed"};
  function take(one) {
    const verb = one.verb.id.replace("http://adlnet.gov/expapi/verbs/", ""), categories = (one.context.contextActivities.category || []).map((c) => c.id);
    must(/^[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}$/.test(one.id), "id");
    must(!Number.isNaN(Date.parse(one.timestamp)) && one.timestamp.endsWith("Z"), "timestamp " + one.timestamp);
    must(one.actor.account.name === "ada", "actor");
    must(one.context.registration === "r1", "registration");
    must(one.context.extensions["https://w3id.org/xapi/cmi5/context/extensions/sessionid"] === store.session, "session of " + verb);
    must(one.context.contextActivities.grouping.some((g) => g.id === "urn:uuid:1"), "grouping of " + verb);
    const defined = ["initialized", "completed", "passed", "failed", "terminated"].includes(verb);
    must(categories.includes(kCmi5 + "cmi5") === defined, "category of " + verb);
    must(categories.includes(kCmi5 + "moveon") === ["completed", "passed", "failed"].includes(verb), "moveon of " + verb);
    if (defined) must(one.object.id === "https://lms/au/1", "object of " + verb);
    if (["completed", "passed", "failed", "terminated"].includes(verb)) must(/^PT[\d.]+S$/.test(one.result.duration), "duration of " + verb);
    if (["passed", "failed"].includes(verb))
      must(one.context.extensions["https://w3id.org/xapi/cmi5/context/extensions/masteryscore"] === store.launch.masteryScore, "masteryscore of " + verb);
    if (verb === "completed") must(one.result.completion === true && one.result.score === undefined && one.result.success === undefined, "result of completed");
    const name = (s) => s.verb.id.split("/").pop();
    const before = store.statements.filter((s) => s.of === store.session).map(name);
    must((verb === "initialized") === (before.length === 0) && !before.includes("terminated"), `order of ${verb} after ${before}`);
    if (["initialized", "terminated"].includes(verb)) must(!before.includes(verb), verb + " twice");
    if (verb === "completed") must(!store.statements.map(name).includes(verb), verb + " twice");
    const initialized = store.statements.find((s) => s.of === store.session);
    if (initialized && !store.late) must(Date.parse(one.timestamp) >= Date.parse(initialized.timestamp), verb + " before the session");
    store.statements.push({...one, of: store.session});
  }
  store.fetch = async (url, options) => {
    if (store.lost) throw new TypeError("Failed to fetch");
    url = new URL(url);
    must(options.keepalive || options.signal instanceof AbortSignal, "no time limit for " + url);
    if (url.pathname === "/token") {
      must(options.method === "POST", "token by POST");
      if (store.tokens.has(url.search)) return reply(200, {"error-code": "1", "error-text": "once"});
      store.tokens.add(url.search);
      return reply(200, {"auth-token": "dG9rZW4="});
    }
    // Browsers count the bytes of all requests of a closing page together.
    if (options.keepalive && (store.closing += Buffer.byteLength(options.body)) > 65536) throw new TypeError("Failed to fetch");
    must(options.headers.Authorization === "Basic dG9rZW4=", "authorization");
    must(/^1\.0\.\d$/.test(options.headers["X-Experience-API-Version"]), "version");
    if (url.pathname === "/xapi/agents/profile") return reply(404);
    if (url.pathname === "/xapi/activities/state") {
      must(url.searchParams.get("activityId") === "https://lms/au/1" && url.searchParams.get("registration") === "r1", "state");
      const id = url.searchParams.get("stateId");
      if (id === "LMS.LaunchData") return reply(200, store.launch);
      if (store.state_fails && id !== "LMS.LaunchData") return reply(503);
      if (options.method === "PUT") { store.states.set(id, JSON.parse(options.body)); return reply(204); }
      return store.states.has(id) ? reply(200, store.states.get(id)) : reply(404);
    }
    must(url.pathname === "/xapi/statements" && options.method === "POST", "address " + url);
    const all = JSON.parse(options.body);
    const known = all.filter((one) => store.statements.some((s) => s.id === one.id));
    if (known.length) return reply(409);
    const refused = all.map((one) => store.refuses(one)).find(Boolean);
    if (refused) return reply(refused);
    if (store.hangs && !options.keepalive) { await store.hangs; }
    all.forEach(take);
    if (store.lose_answer) { store.lose_answer = false; throw new TypeError("Failed to fetch"); }
    return reply(200, all.map((one) => one.id));
  };
  return store;
}

// Launches the lesson in the store's session. `session`: a tab's.
async function launched(lrs, storage = new Storage(), session = new Storage()) {
  const search = "?" + new URLSearchParams({endpoint: "https://lms/xapi", fetch: "https://lms/token?" + lrs.session, registration: "r1",
                                            activityId: "https://lms/au/1", actor: JSON.stringify({account: {homePage: "https://lms", name: "ada"}})});
  lrs.closing = 0;
  const page = browser(storage, {fetch: lrs.fetch, sessionStorage: session});
  const link = await page.find("cmi5", "urn:uuid:2", {location: {search, pathname: "/"}});
  const heard = [], program = {record: () => "", news: (what) => heard.push(what)};
  return {link, heard, program, reporter: new page.Reporter(link, program)};
}
const settled = () => new Promise((done) => setTimeout(done, 20));

async function cmi5() {
  const lrs = recordStore(), stored = new Storage(), session = new Storage(), open = (storage) => launched(lrs, storage, session);
  const verbs = () => lrs.statements.map((s) => s.verb.id.split("/").pop());
  const a = await open(stored);
  assert.deepStrictEqual(verbs(), ["initialized"]);
  a.program.record = record(4, {done: 1, score: 1 / 3, interactions: [task, wrong]});
  await a.reporter.step(false, 1000);
  assert.deepStrictEqual(verbs(), ["initialized", "answered", "answered", "scored", "scored", "progressed"]);
  const answered = lrs.statements[2];
  assert.strictEqual(answered.object.id, "urn:uuid:2#question_one_which");
  assert.strictEqual(answered.result.success, false);
  assert.strictEqual(answered.result.response, "choice_1");
  assert.strictEqual(answered.object.definition.correctResponsesPattern, undefined);  // the question is open yet
  assert.deepStrictEqual(Object.values(answered.result.extensions), [1, ["Takes this für that"]]);
  assert.strictEqual(lrs.states.get("moltact").suspended, suspended(kBegan, 4));

  // The answer to a request is lost, and then the connection: everything arrives, and nothing twice.
  lrs.lose_answer = true;
  a.program.record = record(9, {done: 2, score: 1 / 3, interactions: [task, wrong, free]});
  await a.reporter.step(false, 3000);
  lrs.lost = true;
  a.program.record = record(20, {done: 3, complete: true, score: 1, interactions: [task, wrong, free, {...task, t: 20}]});
  await a.reporter.step(false, 5000);
  assert.deepStrictEqual(a.heard, [0]);
  lrs.lost = false;
  await a.reporter.step(false, 16000);
  assert.deepStrictEqual(a.heard, [0, 1]);
  assert.deepStrictEqual(verbs().slice(6), ["answered", "progressed", "answered", "scored", "scored", "completed"]);
  assert.strictEqual(new Set(lrs.statements.map((s) => s.id)).size, lrs.statements.length);
  assert.deepStrictEqual(lrs.states.get("moltact"), {suspended: suspended(kBegan, 20), completed: true, scores: {"": 1, goal_1: 1}});
  assert.strictEqual(stored.getItem(a.link.queue_key), null);
  assert.deepStrictEqual(lrs.faults, []);

  // The page is loaded again without its end (a tab that crashed): the same token, and the session begins only once.
  const crashed = await open(stored);
  assert.strictEqual(verbs().filter((verb) => verb === "initialized").length, 1);
  assert.strictEqual(crashed.reporter.suspended, suspended(kBegan, 20));

  // The page closes. Loaded again, it does not begin: the session is over, and the platform begins a new one, on any
  // computer. "completed" is not said once more, and what a finished lesson has does not fall.
  a.program.record = record(21, {done: 3, complete: true, score: 1, interactions: [task, wrong, free, {...task, t: 20}]});
  await a.reporter.step(true, 17000);
  await settled();
  assert.strictEqual(verbs().at(-1), "terminated");
  assert.deepStrictEqual(lrs.faults, []);
  await assert.rejects(open(stored), /this session is over/);
  assert.strictEqual(verbs().at(-1), "terminated");
  lrs.session = "s2";
  const told = lrs.statements.length, b = await open(new Storage());
  assert.strictEqual(b.reporter.suspended, suspended(kBegan, 21));
  b.program.record = record(25, {done: 3, complete: true, score: 1, interactions: [task, wrong, free, {...task, t: 20}]});
  await b.reporter.step(false, 1000);
  b.program.record = record(2, {began: "2026-11-25T08:00:00Z", done: 1, score: 1 / 3, interactions: [task]});
  await b.reporter.step(false, 3000);
  assert.deepStrictEqual(verbs().slice(told), ["initialized", "answered"]);
  assert.deepStrictEqual(lrs.states.get("moltact").scores, {"": 1, goal_1: 1});
  assert.deepStrictEqual(lrs.faults, []);

  // The way back to the platform, if it names one on the web: what is done goes there first, and a connection that is lost
  // does not hold the student.
  for (const [address, wanted] of [[undefined, null], ["https://lms/course/4?a=b", "https://lms/course/4?a=b"], ["javascript:alert(1)", null],
                                   ["/course", null], ["file:///etc/passwd", null], ["http://lms/", "http://lms/"]]) {
    const back = recordStore(), gone = [];
    back.launch.returnURL = address;
    const d = await launched(back);
    assert.strictEqual(d.link.return_url, wanted);
    if (!wanted) continue;
    d.program.record = record(4, {done: 1, interactions: [task]});
    const window = {location: {assign: (to) => gone.push([to, back.statements.length])}};
    await d.reporter.leave(window);
    back.lost = true;
    d.program.record = record(5, {done: 1, interactions: [task, wrong]});
    await d.reporter.leave(window);
    assert.deepStrictEqual(gone, [[wanted, 3], [wanted, 3]]);  // initialized, answered, progressed
    assert.deepStrictEqual(back.faults, []);
  }

  // A mark to pass, set by the platform, is judged when the lesson is finished.
  const strict = recordStore();
  strict.launch.masteryScore = 0.8;
  const c = await launched(strict);
  c.program.record = record(9, {done: 3, complete: true, score: 0.5});
  await c.reporter.step(false, 1000);
  assert.strictEqual(strict.statements.at(-1).verb.id, "http://adlnet.gov/expapi/verbs/failed");
  assert.strictEqual(strict.statements.at(-1).result.score.scaled, 0.5);
  assert.deepStrictEqual(strict.faults, []);
}

async function cmi5Faults() {
  const verb = (s) => s.verb.id.split("/").pop(), state_key = "moltact";
  // A statement that the store refuses for good does not hold back the others.
  for (const status of [400, 413]) {
    const lrs = recordStore(), a = await launched(lrs);
    lrs.refuses = (s) => s.object.id.endsWith("_which") ? status : 0;
    a.program.record = record(9, {done: 2, score: 1 / 3, interactions: [task, wrong, free]});
    await a.reporter.step(false, 1000);
    assert.deepStrictEqual(a.heard, []);
    assert.deepStrictEqual(lrs.statements.filter((s) => verb(s) === "answered").map((s) => s.object.id),
                           ["urn:uuid:2#task_one_1", "urn:uuid:2#question_one_why"]);
    assert.strictEqual(lrs.states.get(state_key).suspended, suspended(kBegan, 9));
    assert.deepStrictEqual(lrs.faults, []);
    lrs.refuses = () => 500;  // but a store that is out of order is a lost connection
    a.program.record = record(12, {done: 2, score: 1 / 3, interactions: [task, wrong, free, {...task, t: 11}]});
    await a.reporter.step(false, 3000);
    assert.deepStrictEqual(a.heard, [0]);
    assert.strictEqual(a.link.queue.length, 1);
  }

  // A state that cannot be read: the session does not begin, and the work in the platform stays.
  const lrs = recordStore();
  lrs.states.set(state_key, {suspended: suspended(kBegan, 4), completed: false});
  lrs.state_fails = true;
  await assert.rejects(launched(lrs), /state: 503/);
  assert.deepStrictEqual(lrs.statements, []);
  assert.strictEqual(lrs.states.get(state_key).suspended, suspended(kBegan, 4));

  // A close with a long rest: the requests keep to 64 KiB, the oldest statements go first, and the rest waits, with
  // "completed", for the next session, which sends it as its own.
  const full = recordStore(), stored = new Storage(), b = await launched(full, stored);
  const many = Array.from({length: 60}, (_, k) => ({...free, id: `question_one_q${k}`, written: "ü".repeat(1200), t: k + 1}));
  const long = JSON.stringify([...JSON.parse(suspended(kBegan, 61)), "x".repeat(20000)]);
  b.program.record = record(61, {done: 3, complete: true, score: 1, interactions: many, text: long});
  await b.reporter.step(true, 1000);
  await settled();
  const sent = full.statements.map(verb);
  assert.strictEqual(sent.at(-1), "terminated");
  assert.ok(full.closing > 50000 && full.closing <= 65536, String(full.closing));
  const count = sent.length - 2;  // but initialized and terminated
  assert.ok(count > 10 && count < 60, String(count));
  assert.deepStrictEqual(full.statements.slice(1, -1).map((s) => s.object.id.split("_q")[1]), many.slice(0, count).map((_, k) => String(k)));
  assert.deepStrictEqual(full.states.get(state_key), {suspended: long, completed: false, scores: {"": 1, goal_1: 1}});
  full.session = "s2";
  full.late = true;  // the statements keep the time of their deed
  const c = await launched(full, stored);
  c.program.record = record(62, {done: 3, complete: true, score: 1, interactions: many});
  await c.reporter.step(false, 1000);
  const all = full.statements.map(verb);
  assert.deepStrictEqual(["answered", "completed", "terminated"].map((v) => all.filter((one) => one === v).length), [60, 1, 1]);
  assert.strictEqual(full.states.get(state_key).completed, true);
  assert.strictEqual(stored.getItem(c.link.queue_key), null);
  assert.deepStrictEqual(full.faults, []);

  // Suspended data that had to be shortened lower no score of their attempt; a new attempt does.
  const short = recordStore();
  short.states.set(state_key, {suspended: suspended(kBegan, 5), completed: false, scores: {"": 2 / 3, goal_1: 2 / 3}});
  const h = await launched(short);
  h.program.record = record(6, {done: 1, score: 1 / 3});
  await h.reporter.step(false, 1000);
  assert.ok(!short.statements.map(verb).includes("scored"));
  h.program.record = record(1, {began: "2026-11-25T08:00:00Z", done: 1, score: 0});
  await h.reporter.step(false, 3000);
  assert.deepStrictEqual(short.statements.filter((s) => verb(s) === "scored").map((s) => s.result.score.scaled), [0, 0]);

  // A close while a request is under way: its statements are not sent a second time, which would refuse "terminated" too.
  const slow = recordStore(), d = await launched(slow);
  let release;
  slow.hangs = new Promise((done) => { release = done; });
  d.program.record = record(4, {done: 1, score: 1 / 3, interactions: [task]});
  const flying = d.reporter.step(false, 1000);
  d.program.record = record(5, {done: 1, score: 1 / 3, interactions: [task, wrong]});
  await d.reporter.step(true, 2000);
  await settled();
  assert.deepStrictEqual(slow.statements.map(verb), ["initialized", "answered", "terminated"]);
  assert.strictEqual(slow.statements[1].object.id, "urn:uuid:2#question_one_which");
  assert.strictEqual(slow.states.get(state_key).suspended, suspended(kBegan, 5));
  assert.deepStrictEqual(slow.faults, []);
  slow.hangs = null;
  slow.faults.length = 0;
  release();
  await flying;
  assert.deepStrictEqual(d.heard, []);

  // A damaged list of waiting statements, and a browser that blocks its storage, hinder nothing.
  const damaged = new Storage();
  damaged.setItem(d.link.queue_key, "{");
  const e = await launched(recordStore(), damaged);
  assert.deepStrictEqual([...e.link.queue], []);
  damaged.setItem(d.link.queue_key, "[null, 3]");
  assert.deepStrictEqual([...(await launched(recordStore(), damaged)).link.queue], []);
  const blocked = new Proxy({}, {get() { throw new Error("SecurityError"); }}), shut = recordStore();
  const f = await launched(shut, blocked, blocked);
  f.program.record = record(4, {done: 1, score: 1 / 3, interactions: [task, {...wrong, right: true, chosen: [1, 2], misconceptions: []}]});
  await f.reporter.step(false, 1000);
  assert.deepStrictEqual(shut.statements.map(verb).slice(0, 3), ["initialized", "answered", "answered"]);
  assert.deepStrictEqual(shut.statements[2].object.definition.correctResponsesPattern, ["choice_2[,]choice_3"]);
  assert.deepStrictEqual(shut.faults, []);

  // A review: the session begins and ends, and tells nothing else.
  const review = recordStore();
  review.launch.launchMode = "Review";
  const g = await launched(review);
  g.program.record = record(4, {done: 3, complete: true, score: 1, interactions: [task]});
  await g.reporter.step(false, 1000);
  await g.reporter.step(true, 2000);
  await settled();
  assert.deepStrictEqual(review.statements.map(verb), ["initialized", "terminated"]);
  assert.strictEqual(review.states.size, 0);
}

async function none() {
  const page = browser(undefined, {fetch: () => assert.fail("something was sent")});
  const alone = {location: {search: "", pathname: "/"}};
  alone.parent = alone.top = alone;
  for (const kind of ["1.2", "2004", "cmi5", "other"]) assert.ok(!await page.find(kind, "urn:uuid:1", alone));
  assert.ok(!await page.find("cmi5", "urn:uuid:1", {location: {search: "?endpoint=x&fetch=y", pathname: "/"}}));
  // The opener's parents are searched as well, and a window of another origin ends the search.
  const api = {}, far = {location: alone.location, opener: windowWith(api, "API", 2)};
  far.parent = far.top = far;
  assert.strictEqual(page.findApi(far, "API"), api);
  const closed = {location: alone.location, parent: new Proxy({}, {get() { throw new Error("of another origin"); }})};
  closed.top = closed;
  assert.strictEqual(page.findApi(closed, "API"), null);
  // What is farther: the later attempt, and of one attempt the longer.
  const one = suspended(kBegan, 4), more = suspended(kBegan, 5), later = suspended("2026-11-22T10:58:14Z", 1);
  for (const [there, here, wanted] of [["", "", ""], [one, "", one], ["", one, one], [one, more, more], [more, one, more], [one, later, later],
                                       [later, more, later], ["damaged", one, one], [one, "damaged", one], ["damaged", "", "damaged"]])
    assert.strictEqual(page.fartherOf(there, here), wanted);
}

(async () => {
  await scorm("1.2");
  await scorm("2004");
  await scormFaults("1.2");
  await scormFaults("2004");
  await cmi5();
  await cmi5Faults();
  await none();
  console.log("the learning platforms: all as the standards say");
})().catch((error) => { console.error(error); process.exit(1); });
