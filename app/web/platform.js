// The learning platform around a page that `moltact pack --scorm` or `--cmi5` made. page.js loads this text only in such
// a page. It finds the platform (SCORM 1.2, SCORM 2004 or cmi5), passes on the record that engine/results/learning_record.h
// computes, and keeps in the browser what a lost connection delays (docs/learning-platforms.md).
"use strict";

const moltactPlatform = (() => {
  const kPoll_ms = 2000, kCommit_ms = 60000, kRetry_ms = 10000, kMaxSearch = 500, kWait_ms = 15000;

  // ---- what all platforms share ----------------------------------------------------------------------------------------

  // The attempt and the time of use in a suspended text (engine/results/suspended.h); null if it is none.
  function stateOf(text) {
    try {
      const all = JSON.parse(text);
      return Array.isArray(all) && all[0] === "moltact" ? {began: String(all[2]), t: Number(all[4]) || 0} : null;
    } catch { return null; }
  }

  // Of what the platform has and what this browser could not send, the one that is farther.
  function fartherOf(there, here) {
    const a = stateOf(there), b = stateOf(here);
    if (!a || !b) return a ? there : b ? here : there;
    return b.began === a.began ? (b.t > a.t ? here : there) : (b.began > a.began ? here : there);
  }

  const store = {
    get(key) { try { return localStorage.getItem(key); } catch { return null; } },
    set(key, text) { try { localStorage.setItem(key, text); return true; } catch { return false; } },
    drop(key) { try { localStorage.removeItem(key); } catch { /* there is none */ } },
  };

  // "misconception_sees-holes" in printable ASCII, as interactionId() of engine/results/learning_record.h escapes.
  function misconceptionId(words) {
    const bytes = new TextEncoder().encode(words.trim().toLowerCase().replace(/\s+/g, "-"));
    const escaped = [...bytes].map((b) => /[a-z0-9-]/.test(String.fromCharCode(b)) ? String.fromCharCode(b)
                                                                                   : "." + b.toString(16).padStart(2, "0"));
    return "misconception_" + escaped.join("").slice(0, 200);
  }

  const cut = (text, most) => [...text].length <= most ? text : [...text].slice(0, most - 1).join("") + "…";
  const iso = (s) => "PT" + (Math.round(Math.max(0, s) * 100) / 100) + "S";
  const marked = (i) => i.judged === "marked";

  // ---- SCORM -----------------------------------------------------------------------------------------------------------

  // The API object as SCORM defines the search: this window's parents, then the opener and its parents.
  function findApi(window, name) {
    const upward = (from) => {
      for (let n = 0, at = from; at && n < kMaxSearch; ++n, at = at.parent === at ? null : at.parent)
        try { if (at[name]) return at[name]; } catch { return null; }  // a window of another origin
      return null;
    };
    let opener = null;
    try { opener = window.top.opener || window.opener; } catch { opener = window.opener; }
    return upward(window) || (opener ? upward(opener) : null);
  }

  const kScorm = {
    "1.2": {
      api: "API", functions: {initialize: "LMSInitialize", get: "LMSGetValue", set: "LMSSetValue", commit: "LMSCommit",
                              terminate: "LMSFinish"},
      limit: 4096, learner: "cmi.core.student_id", mode: "cmi.core.lesson_mode", status: "cmi.core.lesson_status",
      time(s) {
        const whole = Math.floor(s), two = (n) => String(n).padStart(2, "0");
        return String(Math.floor(whole / 3600)).padStart(4, "0") + ":" + two(Math.floor(whole / 60) % 60) + ":" +
               two(whole % 60) + "." + two(Math.floor((s - whole) * 100));
      },
    },
    "2004": {
      api: "API_1484_11", functions: {initialize: "Initialize", get: "GetValue", set: "SetValue", commit: "Commit",
                                      terminate: "Terminate"},
      limit: 64000, learner: "cmi.learner_id", mode: "cmi.mode", status: "cmi.completion_status",
      time: iso,
    },
  };

  class Scorm {
    constructor(version, api, window) {
      this.version = version;
      this.words = kScorm[version];
      this.api = api;
      this.limit = this.words.limit;
      this.ended = false;
      this.best = null;  // the best score sent after completion
      this.takes_interactions = true;
      if (!this.call("initialize", "")) throw new Error("the platform refuses to begin");
      const learner = this.get(this.words.learner), folder = window.location.pathname.replace(/[^/]*$/, "");
      this.storage = `moltact ${folder} ${learner}`;
      this.mode = this.get(this.words.mode) || "normal";
      this.complete = ["completed", "passed"].includes(this.get(this.words.status));
      const raw = this.get(version === "1.2" ? "cmi.core.score.raw" : "cmi.score.raw");
      if (this.complete && raw !== "" && Number.isFinite(Number(raw))) this.best = Number(raw) / 100;
      this.there = this.get("cmi.suspend_data");
      this.interactions = Number(this.get("cmi.interactions._count")) || 0;
      this.objectives = new Map();
      const known = Number(this.get("cmi.objectives._count")) || 0;
      for (let n = 0; n < known; ++n) this.objectives.set(this.get(`cmi.objectives.${n}.id`), n);
      this.known_objectives = known;
    }

    call(what, ...values) {
      const result = this.api[this.words.functions[what]](...values);
      return result === true || String(result).toLowerCase() === "true";
    }
    get(element) { return String(this.api[this.words.functions.get](element) ?? ""); }
    set(element, value) { return this.call("set", element, String(value)); }

    get old() { return this.version === "1.2"; }

    write(record, fresh, session_s) {
      if (this.mode !== "normal") return;
      this.complete ||= record.complete;
      const done = this.complete ? "completed" : "incomplete", percent = (share) => Math.round(share * 10000) / 100;
      // A later attempt does not lower the score of a finished lesson.
      const score = record.score === null ? null : this.best === null ? record.score : Math.max(this.best, record.score);
      if (record.complete && score !== null) this.best = score;
      if (this.old) {
        this.set("cmi.core.lesson_location", cut(record.place, 255));
        this.set("cmi.core.lesson_status", done);
        if (score !== null) this.setScore("cmi.core.score", score, percent);
        this.set("cmi.core.session_time", this.words.time(session_s));
        this.set("cmi.core.exit", "suspend");
      } else {
        this.set("cmi.location", cut(record.place, 1000));
        this.set("cmi.completion_status", done);
        this.set("cmi.progress_measure", this.complete ? 1 : record.of ? Math.min(1, record.done / record.of) : 0);
        if (score !== null) this.setScore("cmi.score", score, percent);
        this.set("cmi.session_time", this.words.time(session_s));
        this.set("cmi.exit", "suspend");
      }
      this.set("cmi.suspend_data", record.suspended);
      for (const goal of record.objectives) this.writeObjective(goal, percent);
      for (const interaction of fresh) this.writeInteraction(interaction);
    }

    setScore(element, share, percent) {
      if (!this.old) this.set(element + ".scaled", Math.round(share * 10000) / 10000);
      this.set(element + ".min", 0);
      this.set(element + ".max", 100);
      this.set(element + ".raw", percent(share));
    }

    writeObjective(goal, percent) {
      let n = this.objectives.get(goal.id);
      if (n === undefined) {
        if (!this.set(`cmi.objectives.${this.known_objectives}.id`, goal.id)) return;
        this.objectives.set(goal.id, n = this.known_objectives++);
      }
      const at = `cmi.objectives.${n}`, done = goal.of > 0 && goal.done >= goal.of;
      const status = done ? "completed" : goal.done ? "incomplete" : "not attempted";
      if (goal.score !== null) this.setScore(at + ".score", goal.score, percent);
      this.set(at + (this.old ? ".status" : ".completion_status"), status);
      if (this.old) return;
      if (goal.of) this.set(at + ".progress_measure", Math.min(1, goal.done / goal.of));
      this.set(at + ".description", cut(goal.text, 250));
    }

    writeInteraction(i) {
      if (!this.takes_interactions) return;
      const at = `cmi.interactions.${this.interactions}`;
      if (!this.set(at + ".id", i.id)) { this.takes_interactions = false; return; }  // an option of SCORM 1.2
      ++this.interactions;
      const {old} = this, letters = (list) => list.map((k) => "abcdefghijklmnopqrstuvwxyz"[k] ?? "0").join(",");
      const names = (list) => list.map((k) => `choice_${k + 1}`).join("[,]");
      const type = i.kind === "task" ? "performance" : i.kind === "choice" ? "choice"
                   : i.judged === "free" && !old ? "long-fill-in" : "fill-in";
      this.set(at + ".type", type);
      [...i.goals.map((g) => `goal_${g + 1}`), ...i.misconceptions.map(misconceptionId)].forEach(
        (id, m) => this.set(`${at}.objectives.${m}.id`, id));
      const when = new Date(i.at), valid = !Number.isNaN(when.getTime());
      if (valid && old) this.set(at + ".time", when.toTimeString().slice(0, 8));
      if (valid && !old) this.set(at + ".timestamp", i.at.replace(/Z$/, ".00Z"));  // a zone stands behind a fraction only
      if (i.kind === "choice" && i.right_choices.length && marked(i))
        this.set(at + ".correct_responses.0.pattern", (old ? letters : names)(i.right_choices));
      const plain = (text, most) => cut(text.replace(/\[([,:.])\]/g, "[ $1]"), most);
      const response = i.kind === "choice" ? (old ? letters : names)(i.chosen)
                       : i.kind === "typed" ? plain(i.written, old ? 255 : type === "fill-in" ? 250 : 4000)
                       : (old ? "" : "task[.]") + (i.right ? "solved" : "shown");
      if (response) this.set(at + (old ? ".student_response" : ".learner_response"), response);
      this.set(at + ".result", !marked(i) ? "neutral" : i.right ? "correct" : old ? "wrong" : "incorrect");
      this.set(at + ".latency", this.words.time(i.latency_s));
      if (!old) {
        const named = i.misconceptions.length ? ` — misconception: ${i.misconceptions.join("; ")}` : "";
        this.set(at + ".description", cut(i.text, Math.max(40, 250 - named.length)) + cut(named, 200));
      }
    }

    async commit() { return this.ended || this.call("commit", ""); }

    // The page closes. Synchronous, as SCORM is. A finished lesson is suspended too: after another exit a platform may
    // drop its data and its completion at the next visit.
    end() {
      if (this.ended) return;
      this.ended = true;
      try {
        this.call("commit", "");
        this.call("terminate", "");
      } catch (error) { console.warn("the learning platform: " + error); }
    }
  }

  // ---- cmi5 ------------------------------------------------------------------------------------------------------------

  const kAdl = "http://adlnet.gov/expapi/verbs/", kCmi5 = "https://w3id.org/xapi/cmi5/context/categories/";
  const kTypes = "http://adlnet.gov/expapi/activities/", kProgress = "https://w3id.org/xapi/cmi5/result/extensions/progress";
  const kMisconceptions = "urn:uuid:5d1c4f0e-6a8b-8c3e-9f27-0b7a51e4c629#misconceptions";
  const kAttempt = "urn:uuid:5d1c4f0e-6a8b-8c3e-9f27-0b7a51e4c629#attempt";
  const kStateId = "moltact";

  function randomId() {
    const b = crypto.getRandomValues(new Uint8Array(16));
    b[6] = (b[6] & 0x0f) | 0x40;
    b[8] = (b[8] & 0x3f) | 0x80;
    const hex = [...b].map((v) => v.toString(16).padStart(2, "0")).join("");
    return hex.replace(/^(.{8})(.{4})(.{4})(.{4})/, "$1-$2-$3-$4-");
  }

  class Cmi5 {
    constructor(query, lesson) {
      this.endpoint = query.get("endpoint").replace(/\/?$/, "/");
      this.actor = JSON.parse(query.get("actor"));
      this.registration = query.get("registration");
      this.activity = query.get("activityId");
      this.lesson = lesson;  // the lesson's own IRI, the same in every platform
      this.storage = `moltact cmi5 ${this.registration} ${this.activity}`;
      this.queue_key = `moltact/queue/${this.storage}`;
      this.limit = 64000;
      this.queue = JSON.parse(store.get(this.queue_key) || "[]");
      this.begun_ms = Date.now();
      this.complete = this.ended = false;
      this.sent_progress = -1;
      this.sent_scores = new Map();
    }

    async ask(method, path, parameters, body, more = {}) {
      const url = new URL(path, this.endpoint);
      for (const [key, value] of Object.entries(parameters)) url.searchParams.set(key, value);
      const headers = {Authorization: this.authorization, "X-Experience-API-Version": "1.0.3"};
      if (body !== undefined) headers["Content-Type"] = "application/json";
      const signal = more.keepalive ? undefined : AbortSignal.timeout(kWait_ms);
      return fetch(url, {method, headers, body: body === undefined ? undefined : JSON.stringify(body), signal, ...more});
    }
    state(id) {
      return {activityId: this.activity, agent: JSON.stringify(this.actor), registration: this.registration, stateId: id};
    }

    async begin(fetch_url) {
      // The address gives its token once; a page that is loaded again takes the one it was given.
      const kept = "moltact/token/" + fetch_url;
      let token = sessionStorage.getItem(kept);
      if (!token) {
        const reply = await (await fetch(fetch_url, {method: "POST"})).json();
        token = reply["auth-token"];
        if (!token) throw new Error("no token: " + (reply["error-text"] || "the platform gives none"));
        sessionStorage.setItem(kept, token);
      }
      this.authorization = "Basic " + token;
      const launch = await this.ask("GET", "activities/state", this.state("LMS.LaunchData"));
      if (!launch.ok) throw new Error("LMS.LaunchData: " + launch.status);
      this.launch = await launch.json();
      this.mode = this.launch.launchMode || "Normal";
      await this.ask("GET", "agents/profile", {agent: JSON.stringify(this.actor), profileId: "cmi5LearnerPreferences"});
      const initialized = await this.ask("POST", "statements", {}, [this.defined("initialized", {})]);
      if (!initialized.ok) throw new Error("initialized: " + initialized.status);
      const state = await this.ask("GET", "activities/state", this.state(kStateId));
      const kept_state = state.ok ? await state.json() : {};
      this.there = String(kept_state.suspended || "");
      this.complete = kept_state.completed === true;
    }

    // A statement in the context that the platform prescribes.
    statement(verb, object, result, context = {}) {
      const template = structuredClone(this.launch.contextTemplate || {}), activities = template.contextActivities || {};
      for (const [key, list] of Object.entries(context.activities || {}))
        activities[key] = [...[].concat(activities[key] || []), ...list];
      const out = {
        id: randomId(), actor: this.actor,
        verb: {id: kAdl + verb, display: {"en-US": verb}}, object,
        context: {...template, registration: this.registration, contextActivities: activities},
        timestamp: context.at || new Date().toISOString(),
      };
      if (result) out.result = result;
      return out;
    }
    defined(verb, result, ...categories) {
      const category = ["cmi5", ...categories].map((name) => ({id: kCmi5 + name}));
      return this.statement(verb, {objectType: "Activity", id: this.activity}, Object.keys(result).length ? result : undefined,
                            {activities: {category}});
    }

    write(record, fresh, session_s) {
      this.session_s = session_s;
      if (this.mode !== "Normal") return;
      for (const i of fresh) this.add(this.answered(i));
      const scores = [{id: "", text: "", score: record.score}, ...record.objectives];
      for (const {id, text, score} of scores) {
        if (score === null || this.sent_scores.get(id) === score || (!this.sent_scores.has(id) && score === 0)) continue;
        this.sent_scores.set(id, score);
        this.add(this.scored(id, text, score));
      }
      const progress = record.of ? Math.floor(100 * record.done / record.of) : 0;
      if (progress !== this.sent_progress && progress > 0 && progress < 100)
        this.add(this.statement("progressed", {objectType: "Activity", id: this.activity}, {extensions: {[kProgress]: progress}}));
      this.sent_progress = progress;
      if (record.complete && !this.complete) {
        this.complete = true;
        this.add(this.defined("completed", {completion: true, duration: iso(session_s)}, "moveon"));
        const mastery = this.launch.masteryScore;
        if (typeof mastery === "number" && record.score !== null)
          this.add(this.defined(record.score >= mastery ? "passed" : "failed",
                                {success: record.score >= mastery, score: {scaled: record.score}, duration: iso(session_s)}, "moveon"));
      }
      this.suspended = record.suspended;
    }

    part(id) { return `${this.lesson}#${id}`; }

    answered(i) {
      const choice = i.kind === "choice";
      const definition = {type: kTypes + "cmi.interaction", name: {und: cut(i.text || i.id, 400)},
                          interactionType: choice ? "choice" : i.kind === "task" ? "performance"
                                           : i.judged === "free" ? "long-fill-in" : "fill-in"};
      if (choice) {
        definition.choices = i.choices.map((text, k) => ({id: `choice_${k + 1}`, description: {und: text}}));
        if (marked(i)) definition.correctResponsesPattern = [i.right_choices.map((k) => `choice_${k + 1}`).join("[,]")];
      }
      const result = {duration: iso(i.latency_s),
                      response: choice ? i.chosen.map((k) => `choice_${k + 1}`).join("[,]")
                                : i.kind === "task" ? "task[.]" + (i.right ? "solved" : "shown") : i.written};
      if (marked(i)) result.success = i.right;
      result.extensions = {[kAttempt]: i.attempt};
      if (i.misconceptions.length) result.extensions[kMisconceptions] = i.misconceptions;
      const parent = [{id: this.activity}], other = i.goals.map((g) => ({id: this.part(`goal_${g + 1}`)}));
      return this.statement("answered", {objectType: "Activity", id: this.part(i.id), definition}, result,
                            {at: i.at || undefined, activities: other.length ? {parent, other} : {parent}});
    }

    scored(id, text, score) {
      const object = id ? {objectType: "Activity", id: this.part(id),
                           definition: {type: kTypes + "objective", name: {und: cut(text, 400)}}}
                        : {objectType: "Activity", id: this.activity};
      return this.statement("scored", object, {score: {scaled: score, raw: Math.round(score * 10000) / 100, min: 0, max: 100}},
                            id ? {activities: {parent: [{id: this.activity}]}} : {});
    }

    add(statement) {
      this.queue.push(statement);
      this.keep();
    }
    keep() { if (this.queue.length) store.set(this.queue_key, JSON.stringify(this.queue)); else store.drop(this.queue_key); }

    async commit() {
      if (this.ended || this.mode !== "Normal") return true;
      while (this.queue.length) {
        const batch = this.queue.slice(0, 50);
        const reply = await this.ask("POST", "statements", {}, batch);
        // 409: the store has a statement with this id, because only its answer was lost. Each is then sent alone.
        if (reply.status === 409 && batch.length > 1) {
          for (const one of batch) {
            const alone = await this.ask("POST", "statements", {}, [one]);
            if (!alone.ok && alone.status !== 409) return false;
          }
        } else if (!reply.ok && reply.status !== 409) return false;
        this.queue.splice(0, batch.length);
        this.keep();
      }
      const body = {suspended: this.suspended, completed: this.complete};
      return (await this.ask("PUT", "activities/state", this.state(kStateId), body)).ok;
    }

    // The page closes: requests that the browser finishes afterwards, up to 64 kB.
    end() {
      if (this.ended) return;
      this.ended = true;
      const last = this.defined("terminated", {duration: iso((Date.now() - this.begun_ms) / 1000)});
      const quietly = (request) => request.catch((error) => console.warn("the learning platform: " + error));
      if (this.mode === "Normal" && this.suspended)
        quietly(this.ask("PUT", "activities/state", this.state(kStateId), {suspended: this.suspended, completed: this.complete},
                         {keepalive: true}));
      const all = [...this.queue.slice(-40), last];
      quietly(this.ask("POST", "statements", {}, JSON.stringify(all).length < 50000 ? all : [last], {keepalive: true}));
    }
  }

  // ---- the page's side ---------------------------------------------------------------------------------------------------

  // Passes the record on as it changes. `page`: record(limit, from) gives the program's JSON or "", news(what) says 0 that
  // the platform does not answer, 1 that it answers again.
  class Reporter {
    constructor(link, page) {
      this.link = link;
      this.page = page;
      this.unsent_key = "moltact/unsent/" + link.storage;
      const there = stateOf(link.there);
      this.there = there;
      this.suspended = fartherOf(link.there, store.get(this.unsent_key) || "");
      this.began = null;
      this.from = 0;
      this.past_s = this.session_s = 0;  // of attempts of this session before the present one; with it
      this.lost = false;
      this.shown = "";
      this.committed_ms = 0;
      this.busy = false;
    }

    // The record with the interactions that the platform does not have; null without an attempt.
    look() {
      let text = this.page.record(this.link.limit, this.from);
      if (!text) return null;
      let record = JSON.parse(text);
      if (record.began !== this.began) {  // begun, resumed or begun anew
        this.began = record.began;
        this.past_s = this.session_s;
        if (this.from) record = JSON.parse(this.page.record(this.link.limit, 0));
        const known_s = this.there && this.there.began === record.began ? this.there.t + 0.0005 : -1;
        // Of an attempt that goes on, the time of use so far belongs to earlier sessions.
        this.first_s = this.suspended && stateOf(this.suspended).began === record.began ? stateOf(this.suspended).t : 0;
        record.interactions = record.interactions.filter((i) => i.t > known_s);
      }
      return record;
    }

    async step(last = false, now_ms = Date.now()) {
      if (this.busy && !last) return;
      const record = this.look();
      if (!record) { if (last) this.link.end(); return; }
      const shown = JSON.stringify([record.place, record.done, record.of, record.score, record.began]);
      const wait_ms = this.lost ? kRetry_ms : kCommit_ms;
      const due = last || record.interactions.length || shown !== this.shown || now_ms - this.committed_ms >= wait_ms;
      if (!due) return;
      this.from = record.interaction_count;
      this.shown = shown;
      this.committed_ms = now_ms;
      store.set(this.unsent_key, record.suspended);  // until the platform has it
      this.busy = true;
      let sent = false;
      try {
        this.link.write(record, record.interactions, this.sessionTime(record));
        if (last) return this.link.end();
        sent = await this.link.commit();
      } catch (error) {
        console.warn("the learning platform: " + error);
      } finally {
        this.busy = false;
      }
      if (sent) store.drop(this.unsent_key);
      if (sent === this.lost) this.page.news(sent ? 1 : 0);
      this.lost = !sent;
    }

    sessionTime(record) { return this.session_s = this.past_s + Math.max(0, record.t - this.first_s); }

    begin(window) {
      setInterval(() => this.step(), kPoll_ms);
      window.addEventListener("pagehide", () => this.step(true));
      window.addEventListener("pageshow", (event) => { if (event.persisted) window.location.reload(); });
      window.document.addEventListener("visibilitychange", () => { if (window.document.hidden) this.step(); });
      window.addEventListener("online", () => { this.committed_ms = 0; this.step(); });
    }
  }

  // The platform of this page, or null where there is none: then nothing is sent. `kind`: "1.2", "2004" or "cmi5".
  async function find(kind, lesson, window) {
    if (kind === "cmi5") {
      const query = new URLSearchParams(window.location.search);
      if (!["endpoint", "fetch", "actor", "registration", "activityId"].every((name) => query.get(name))) return null;
      const link = new Cmi5(query, lesson);
      await link.begin(query.get("fetch"));
      return link;
    }
    const api = kScorm[kind] && findApi(window, kScorm[kind].api);
    return api ? new Scorm(kind, api, window) : null;
  }

  return {find, Reporter, Scorm, Cmi5, fartherOf, stateOf, findApi, misconceptionId, kScorm};
})();
