// node tests/web/platform_test.js: the page's side of a learning platform (app/web/platform.js) against a strict SCORM
// runtime and a record store, both written here after the standards.
"use strict";
const assert = require("node:assert"), fs = require("node:fs"), path = require("node:path"), vm = require("node:vm");
const runtime = require("./scorm_runtime.js");
const source = fs.readFileSync(path.join(__dirname, "../../app/web/platform.js"), "utf8");

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
  assert.strictEqual(kept["cmi.interactions.1.correct_responses.0.pattern"], words.right);
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
  assert.deepStrictEqual(Object.keys(shown).sort(), [words.learner, words.mode].sort());
}

// ---- a record store -----------------------------------------------------------------------------------------------------

// What cmi5 requires of each request and statement (cmi5 1st edition, sections 7 to 10); xAPI 1.0.3.
function recordStore() {
  const store = {statements: [], states: new Map(), faults: [], lost: false, lose_answer: false, tokens: 0};
  const reply = (status, body) => ({status, ok: status < 300, json: async () => body});
  const must = (holds, what) => { if (!holds) store.faults.push(what); };
  const kCmi5 = "https://w3id.org/xapi/cmi5/context/categories/";
  store.launch = {contextTemplate: {contextActivities: {grouping: [{id: "urn:uuid:1"}]},
                                    extensions: {"https://w3id.org/xapi/cmi5/context/extensions/sessionid": "s1"}},
                  launchMode: "Normal", moveOn: "Completed"};
  function take(one) {
    const verb = one.verb.id.replace("http://adlnet.gov/expapi/verbs/", ""), categories = (one.context.contextActivities.category || []).map((c) => c.id);
    must(/^[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}$/.test(one.id), "id");
    must(!Number.isNaN(Date.parse(one.timestamp)) && one.timestamp.endsWith("Z"), "timestamp " + one.timestamp);
    must(one.actor.account.name === "ada", "actor");
    must(one.context.registration === "r1", "registration");
    must(one.context.extensions["https://w3id.org/xapi/cmi5/context/extensions/sessionid"] === "s1", "session of " + verb);
    must(one.context.contextActivities.grouping.some((g) => g.id === "urn:uuid:1"), "grouping of " + verb);
    const defined = ["initialized", "completed", "passed", "failed", "terminated"].includes(verb);
    must(categories.includes(kCmi5 + "cmi5") === defined, "category of " + verb);
    must(categories.includes(kCmi5 + "moveon") === ["completed", "passed", "failed"].includes(verb), "moveon of " + verb);
    if (defined) must(one.object.id === "https://lms/au/1", "object of " + verb);
    if (["completed", "passed", "failed", "terminated"].includes(verb)) must(/^PT[\d.]+S$/.test(one.result.duration), "duration of " + verb);
    if (verb === "completed") must(one.result.completion === true && one.result.score === undefined && one.result.success === undefined, "result of completed");
    const before = store.statements.map((s) => s.verb.id.split("/").pop());
    if (defined && verb !== "initialized") must(before.includes("initialized") && !before.includes("terminated"), "order of " + verb);
    if (["initialized", "completed", "terminated"].includes(verb)) must(!before.includes(verb), verb + " twice");
    store.statements.push(one);
  }
  store.fetch = async (url, options) => {
    if (store.lost) throw new TypeError("Failed to fetch");
    url = new URL(url);
    if (url.pathname === "/token") {
      must(options.method === "POST", "token by POST");
      return ++store.tokens === 1 ? reply(200, {"auth-token": "dG9rZW4="}) : reply(200, {"error-code": "1", "error-text": "once"});
    }
    must(options.headers.Authorization === "Basic dG9rZW4=", "authorization");
    must(/^1\.0\.\d$/.test(options.headers["X-Experience-API-Version"]), "version");
    if (url.pathname === "/xapi/agents/profile") return reply(404);
    if (url.pathname === "/xapi/activities/state") {
      must(url.searchParams.get("activityId") === "https://lms/au/1" && url.searchParams.get("registration") === "r1", "state");
      const id = url.searchParams.get("stateId");
      if (id === "LMS.LaunchData") return reply(200, store.launch);
      if (options.method === "PUT") { store.states.set(id, JSON.parse(options.body)); return reply(204); }
      return store.states.has(id) ? reply(200, store.states.get(id)) : reply(404);
    }
    must(url.pathname === "/xapi/statements" && options.method === "POST", "address " + url);
    const all = JSON.parse(options.body);
    const known = all.filter((one) => store.statements.some((s) => s.id === one.id));
    if (known.length) return reply(409);
    all.forEach(take);
    if (store.lose_answer) { store.lose_answer = false; throw new TypeError("Failed to fetch"); }
    return reply(200, all.map((one) => one.id));
  };
  return store;
}

async function cmi5() {
  const lrs = recordStore(), stored = new Storage(), session = new Storage();
  const search = "?" + new URLSearchParams({endpoint: "https://lms/xapi", fetch: "https://lms/token", registration: "r1",
                                            activityId: "https://lms/au/1", actor: JSON.stringify({account: {homePage: "https://lms", name: "ada"}})});
  const open = async (storage) => {
    const page = browser(storage, {fetch: lrs.fetch, sessionStorage: session});
    const link = await page.find("cmi5", "urn:uuid:2", {location: {search, pathname: "/"}});
    const heard = [], program = {record: () => "", news: (what) => heard.push(what)};
    return {link, heard, program, reporter: new page.Reporter(link, program)};
  };
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
  assert.deepStrictEqual(answered.object.definition.correctResponsesPattern, ["choice_2[,]choice_3"]);
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
  assert.deepStrictEqual(lrs.states.get("moltact"), {suspended: suspended(kBegan, 20), completed: true});
  assert.strictEqual(stored.getItem(a.link.queue_key), null);
  assert.deepStrictEqual(lrs.faults, []);

  // The page closes; loaded again, it takes the token that it had, and does not say "completed" once more.
  a.program.record = record(21, {done: 3, complete: true, score: 1, interactions: [task, wrong, free, {...task, t: 20}]});
  await a.reporter.step(true, 17000);
  await new Promise((done) => setTimeout(done, 20));
  assert.strictEqual(verbs().at(-1), "terminated");
  assert.deepStrictEqual(lrs.faults, []);
  lrs.statements.length = 0;
  const b = await open(new Storage());
  assert.strictEqual(b.reporter.suspended, suspended(kBegan, 21));
  b.program.record = record(25, {done: 3, complete: true, score: 1, interactions: [task, wrong, free, {...task, t: 20}]});
  await b.reporter.step(false, 1000);
  assert.deepStrictEqual(verbs(), ["initialized", "scored", "scored"]);
  assert.deepStrictEqual(lrs.faults, []);

  // A mark to pass, set by the platform, is judged when the lesson is finished.
  const strict = recordStore();
  strict.launch.masteryScore = 0.8;
  const page = browser(new Storage(), {fetch: strict.fetch});
  const link = await page.find("cmi5", "urn:uuid:2", {location: {search, pathname: "/"}});
  const c = new page.Reporter(link, {record: record(9, {done: 3, complete: true, score: 0.5}), news() {}});
  await c.step(false, 1000);
  assert.strictEqual(strict.statements.at(-1).verb.id, "http://adlnet.gov/expapi/verbs/failed");
  assert.strictEqual(strict.statements.at(-1).result.score.scaled, 0.5);
  assert.deepStrictEqual(strict.faults, []);
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
  await cmi5();
  await none();
  console.log("the learning platforms: all as the standards say");
})().catch((error) => { console.error(error); process.exit(1); });
