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

  // What the browser keeps; nothing where it blocks storage in frames of another site.
  const guarded = (storage) => ({
    get(key) { try { return storage().getItem(key); } catch { return null; } },
    set(key, text) { try { storage().setItem(key, text); return true; } catch { return false; } },
    drop(key) { try { storage().removeItem(key); } catch { /* there is none */ } },
  });
  const store = guarded(() => localStorage), session = guarded(() => sessionStorage);

  function randomId() {
    const b = crypto.getRandomValues(new Uint8Array(16));
    b[6] = (b[6] & 0x0f) | 0x40;
    b[8] = (b[8] & 0x3f) | 0x80;
    const hex = [...b].map((v) => v.toString(16).padStart(2, "0")).join("");
    return hex.replace(/^(.{8})(.{4})(.{4})(.{4})/, "$1-$2-$3-$4-");
  }

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
  // The name of the browser's storage: what somebody does in a review is not the learner's own work.
  const storageOf = (name, mode) => mode === "normal" ? name : name + " " + mode;

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
                              terminate: "LMSFinish", error: "LMSGetLastError"},
      limit: 4096, learner: "cmi.core.student_id", mode: "cmi.core.lesson_mode", status: "cmi.core.lesson_status",
      exit: "cmi.core.exit", raw: "cmi.core.score.raw", goal_status: "status", takes_none: ["201", "401", "402"],
      time(s) {
        const whole = Math.floor(s), two = (n) => String(n).padStart(2, "0");
        return String(Math.floor(whole / 3600)).padStart(4, "0") + ":" + two(Math.floor(whole / 60) % 60) + ":" +
               two(whole % 60) + "." + two(Math.floor((s - whole) * 100));
      },
    },
    "2004": {
      api: "API_1484_11", functions: {initialize: "Initialize", get: "GetValue", set: "SetValue", commit: "Commit",
                                      terminate: "Terminate", error: "GetLastError"},
      limit: 64000, learner: "cmi.learner_id", mode: "cmi.mode", status: "cmi.completion_status",
      exit: "cmi.exit", raw: "cmi.score.raw", goal_status: "completion_status", takes_none: ["401"],
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
      if (!this.call("initialize", "")) throw new Error("the platform refuses to begin");
      const learner = this.get(this.words.learner), folder = window.location.pathname.replace(/[^/]*$/, "");
      this.mode = (this.get(this.words.mode) || "normal").toLowerCase();
      // A learner without a name: what this browser keeps might be another's.
      this.nameless = !learner;
      this.storage = storageOf(`moltact ${folder} ${learner || randomId()}`, this.mode);
      this.complete = ["completed", "passed"].includes(this.get(this.words.status));
      this.score = this.share(this.words.raw);  // what the platform has
      this.there = this.get("cmi.suspend_data");
      this.began = stateOf(this.there)?.began ?? null;
      const count = this.get("cmi.interactions._count");
      this.counts_interactions = count !== "";
      this.interactions = Number(count) || 0;
      this.pending = [];  // interactions that the platform has not taken
      this.takes_interactions = true;
      this.taken = this.refused = 0;
      this.objectives = new Map();
      const known = Number(this.get("cmi.objectives._count")) || 0;
      for (let n = 0; n < known; ++n) {
        const at = `cmi.objectives.${n}`, done = this.get(`${at}.${this.words.goal_status}`) === "completed";
        this.objectives.set(this.get(at + ".id"), {n, done, score: this.share(at + ".score.raw")});
      }
      this.known_objectives = known;
      // A page that is closed before the first deed is not "completed", as SCORM 1.2 lets a platform conclude.
      if (this.mode === "normal") {
        if (!this.complete) this.set(this.words.status, "incomplete");
        this.set(this.words.exit, "suspend");
      }
    }

    share(element) {
      const raw = this.get(element);
      return raw !== "" && Number.isFinite(Number(raw)) ? Number(raw) / 100 : null;
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
      this.pending.push(...fresh);
      // A later attempt does not lower the score of a finished lesson, nor do suspended data that had to be shortened.
      const keeps = this.complete || record.began === this.began;
      const score = record.score === null ? null : keeps ? Math.max(this.score ?? 0, record.score) : record.score;
      this.complete ||= record.complete;
      const done = this.complete ? "completed" : "incomplete", percent = (share) => Math.round(share * 10000) / 100;
      if (this.complete && score !== null) this.score = score;
      let taken;
      if (this.old) {
        taken = this.set("cmi.core.lesson_location", cut(record.place, 255));
        this.set("cmi.core.lesson_status", done);
        if (score !== null) this.setScore("cmi.core.score", score, percent);
        this.set("cmi.core.session_time", this.words.time(session_s));
      } else {
        taken = this.set("cmi.location", cut(record.place, 1000));
        this.set("cmi.completion_status", done);
        this.set("cmi.progress_measure", this.complete ? 1 : record.of ? Math.min(1, record.done / record.of) : 0);
        if (score !== null) this.setScore("cmi.score", score, percent);
        this.set("cmi.session_time", this.words.time(session_s));
      }
      this.set(this.words.exit, "suspend");
      for (const goal of record.objectives) this.writeObjective(goal, keeps, percent);
      this.writePending(taken);
      // Interactions that are still missing are sent at the next visit, because the platform's state is then behind them.
      if (!this.pending.length) this.set("cmi.suspend_data", record.suspended);
    }

    // `answers`: the platform took another value just now, so it is not the connection that refuses.
    writePending(answers) {
      while (this.pending.length && this.takes_interactions && this.writeInteraction(this.pending[0])) {
        this.pending.shift();
        ++this.taken;
        this.refused = 0;
      }
      if (this.pending.length && this.takes_interactions && answers && ++this.refused >= 3) {
        console.warn("the learning platform refuses the interaction " + this.pending[0].id);
        this.refused = 0;
        if (this.taken) this.pending.shift();
        else this.takes_interactions = false;
      }
      if (!this.takes_interactions) this.pending = [];
    }

    setScore(element, share, percent) {
      if (!this.old) this.set(element + ".scaled", Math.round(share * 10000) / 10000);
      this.set(element + ".min", 0);
      this.set(element + ".max", 100);
      this.set(element + ".raw", percent(share));
    }

    writeObjective(goal, keeps, percent) {
      let known = this.objectives.get(goal.id);
      if (!known) {
        if (!this.set(`cmi.objectives.${this.known_objectives}.id`, goal.id)) return;
        this.objectives.set(goal.id, known = {n: this.known_objectives++, done: false, score: null});
      }
      keeps ||= known.done;
      known.done ||= goal.of > 0 && goal.done >= goal.of;
      const at = `cmi.objectives.${known.n}`, status = known.done ? "completed" : goal.done ? "incomplete" : "not attempted";
      if (goal.score !== null) {
        known.score = keeps ? Math.max(known.score ?? 0, goal.score) : goal.score;
        this.setScore(at + ".score", known.score, percent);
      }
      this.set(`${at}.${this.words.goal_status}`, status);
      if (this.old) return;
      if (goal.of) this.set(at + ".progress_measure", known.done ? 1 : Math.min(1, goal.done / goal.of));
      this.set(at + ".description", cut(goal.text, 250));
    }

    // False if the platform does not take it now. Interactions are an option of SCORM 1.2.
    writeInteraction(i) {
      const at = `cmi.interactions.${this.interactions}`;
      if (!this.set(at + ".id", i.id)) {
        const error = String(this.api[this.words.functions.error]?.() ?? "");
        if (!this.counts_interactions || this.words.takes_none.includes(error)) this.takes_interactions = false;
        return false;
      }
      const {old} = this, letters = (list) => list.map((k) => "abcdefghijklmnopqrstuvwxyz"[k] ?? "0").join(",");
      const names = (list) => list.map((k) => `choice_${k + 1}`).join("[,]");
      const type = i.kind === "task" ? "performance" : i.kind === "choice" ? "choice"
                   : i.judged === "free" && !old ? "long-fill-in" : "fill-in";
      this.set(at + ".type", type);
      [...new Set([...i.goals.map((g) => `goal_${g + 1}`), ...i.misconceptions.map(misconceptionId)])].forEach(
        (id, m) => this.set(`${at}.objectives.${m}.id`, id));
      const when = new Date(i.at), valid = !Number.isNaN(when.getTime());
      if (valid && old) this.set(at + ".time", when.toTimeString().slice(0, 8));
      if (valid && !old) this.set(at + ".timestamp", i.at.replace(/Z$/, ".00Z"));  // a zone stands behind a fraction only
      // Not with a wrong answer: a platform may show it to the student, who tries again.
      if (i.kind === "choice" && i.right && i.right_choices.length && marked(i))
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
      ++this.interactions;
      return true;
    }

    async commit() { return this.call("commit", "") && !this.pending.length; }

    // The page closes. Synchronous, as SCORM is. A finished lesson is suspended too: after another exit a platform may
    // drop its data and its completion at the next visit. Returns whether the platform has everything.
    end() {
      if (this.ended) return false;
      this.ended = true;
      try {
        const committed = this.call("commit", ""), terminated = this.call("terminate", "");
        return committed && terminated && !this.pending.length;
      } catch (error) {
        console.warn("the learning platform: " + error);
        return false;
      }
    }
  }

  // ---- cmi5 ------------------------------------------------------------------------------------------------------------

  const kAdl = "http://adlnet.gov/expapi/verbs/", kCmi5 = "https://w3id.org/xapi/cmi5/context/categories/";
  const kTypes = "http://adlnet.gov/expapi/activities/", kProgress = "https://w3id.org/xapi/cmi5/result/extensions/progress";
  const kMisconceptions = "urn:uuid:5d1c4f0e-6a8b-8c3e-9f27-0b7a51e4c629#misconceptions";
  const kAttempt = "urn:uuid:5d1c4f0e-6a8b-8c3e-9f27-0b7a51e4c629#attempt";
  const kStateId = "moltact";

  const isCompleted = (statement) => statement.verb.id === kAdl + "completed";
  const bytes = (value) => new TextEncoder().encode(JSON.stringify(value)).length;
  const kClosing_bytes = 60000;  // all requests of a closing page together have 64 KiB

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
      this.queue = [];
      this.flying = 0;  // statements at the queue's front in a request under way
      this.begun_ms = Date.now();
      this.complete = this.ended = false;
      this.sent_progress = -1;
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
      // A session ends once: a page that is loaded again after its end begins again from the platform.
      this.over_key = "moltact/over/" + fetch_url;
      if (session.get(this.over_key)) throw new Error("this session is over");
      // The address gives its token once; a page that is loaded again takes the one it was given.
      const kept = "moltact/token/" + fetch_url, begun = "moltact/begun/" + fetch_url;
      let token = session.get(kept);
      if (!token) {
        const reply = await (await fetch(fetch_url, {method: "POST", signal: AbortSignal.timeout(kWait_ms)})).json();
        token = reply["auth-token"];
        if (!token) throw new Error("no token: " + (reply["error-text"] || "the platform gives none"));
        session.set(kept, token);
      }
      this.authorization = "Basic " + token;
      const launch = await this.ask("GET", "activities/state", this.state("LMS.LaunchData"));
      if (!launch.ok) throw new Error("LMS.LaunchData: " + launch.status);
      this.launch = await launch.json();
      this.mode = (this.launch.launchMode || "Normal").toLowerCase();
      this.storage = storageOf(this.storage, this.mode);
      await this.ask("GET", "agents/profile", {agent: JSON.stringify(this.actor), profileId: "cmi5LearnerPreferences"});
      const state = await this.ask("GET", "activities/state", this.state(kStateId));
      if (!state.ok && state.status !== 404) throw new Error("state: " + state.status);
      const kept_state = state.ok ? await state.json() : {};
      this.there = String(kept_state.suspended || "");
      this.began = stateOf(this.there)?.began ?? null;
      this.sent_scores = new Map(Object.entries(kept_state.scores || {}));
      this.had_scores = new Map(this.sent_scores);
      // Statements of an earlier session are sent in this one.
      if (this.mode === "normal") this.queue = this.waiting();
      this.complete = kept_state.completed === true || this.queue.some(isCompleted);
      this.initialized = session.get(begun);
      if (this.initialized) return;
      const first = this.defined("initialized", {}), reply = await this.ask("POST", "statements", {}, [first]);
      if (!reply.ok) throw new Error("initialized: " + reply.status);
      this.initialized = first.timestamp;
      session.set(begun, first.timestamp);
    }

    waiting() {
      let kept = [];
      try { kept = JSON.parse(store.get(this.queue_key) || "[]"); } catch { /* damaged */ }
      const {extensions} = this.launch.contextTemplate || {};
      return (Array.isArray(kept) ? kept : []).filter((one) => one?.verb && one.context).map(
        (one) => ({...one, context: {...one.context, extensions: {...one.context.extensions, ...extensions}}}));
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
      if (this.mode !== "normal") return;
      for (const i of fresh) this.add(this.answered(i));
      const scores = [{id: "", text: "", score: record.score}, ...record.objectives];
      for (const {id, text, score} of scores) {
        const sent = this.sent_scores.get(id) ?? 0;
        if (score === null || score === sent || (this.complete && score < sent)) continue;
        // Suspended data that had to be shortened do not lower a score.
        if (record.began === this.began && score < (this.had_scores.get(id) ?? 0)) continue;
        this.sent_scores.set(id, score);
        this.add(this.scored(id, text, score));
      }
      const progress = record.of ? Math.floor(100 * record.done / record.of) : 0;
      if (!this.complete && progress !== this.sent_progress && progress > 0 && progress < 100)
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

    // A time within this session.
    within(at) { return Date.parse(at) >= Date.parse(this.initialized) ? at : this.initialized; }

    answered(i) {
      const choice = i.kind === "choice";
      const definition = {type: kTypes + "cmi.interaction", name: {und: cut(i.text || i.id, 400)},
                          interactionType: choice ? "choice" : i.kind === "task" ? "performance"
                                           : i.judged === "free" ? "long-fill-in" : "fill-in"};
      if (choice) {
        definition.choices = i.choices.map((text, k) => ({id: `choice_${k + 1}`, description: {und: text}}));
        if (marked(i) && i.right) definition.correctResponsesPattern = [i.right_choices.map((k) => `choice_${k + 1}`).join("[,]")];
      }
      const result = {duration: iso(i.latency_s),
                      response: choice ? i.chosen.map((k) => `choice_${k + 1}`).join("[,]")
                                : i.kind === "task" ? "task[.]" + (i.right ? "solved" : "shown") : i.written};
      if (marked(i)) result.success = i.right;
      result.extensions = {[kAttempt]: i.attempt};
      if (i.misconceptions.length) result.extensions[kMisconceptions] = i.misconceptions;
      const parent = [{id: this.activity}], other = i.goals.map((g) => ({id: this.part(`goal_${g + 1}`)}));
      return this.statement("answered", {objectType: "Activity", id: this.part(i.id), definition}, result,
                            {at: this.within(i.at), activities: other.length ? {parent, other} : {parent}});
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

    // True if the store has the statements, or refuses them for good.
    async send(statements) {
      const reply = await this.ask("POST", "statements", {}, statements);
      if (reply.ok) return true;
      if (![400, 409, 413].includes(reply.status)) return false;
      if (statements.length === 1) {  // 409: the store has it, because only its answer was lost
        if (reply.status !== 409) console.warn(`the record store refuses ${statements[0].verb.id}: ${reply.status}`);
        return true;
      }
      for (const one of statements) if (!await this.send([one])) return false;
      return true;
    }

    async commit() {
      if (this.mode !== "normal") return true;
      while (this.queue.length && !this.ended) {
        const batch = this.queue.slice(0, 50);
        this.flying = batch.length;
        const sent = await this.send(batch).finally(() => { if (!this.ended) this.flying = 0; });
        if (!sent || this.ended) return false;
        this.queue.splice(0, batch.length);
        this.keep();
      }
      return !this.ended && (await this.ask("PUT", "activities/state", this.state(kStateId), this.body([]))).ok;
    }
    // `left`: statements that are not sent yet. The lesson is finished for other browsers when that statement is sent.
    body(left) {
      return {suspended: this.suspended, completed: this.complete && !left.some(isCompleted),
              scores: Object.fromEntries(this.sent_scores)};
    }

    // The page closes: requests that the browser finishes afterwards. The state first, then the oldest statements; what
    // does not fit, and what a request under way has, waits in this browser. Returns false: no answer arrives.
    end() {
      if (this.ended) return false;
      this.ended = true;
      session.set(this.over_key, "1");
      const last = this.defined("terminated", {duration: iso((Date.now() - this.begun_ms) / 1000)});
      let room = kClosing_bytes - bytes([last]);
      const state_bytes = bytes(this.body([])) + 1;  // + 1: "false" is longer than "true"
      const tell = this.mode === "normal" && this.suspended && state_bytes <= room;
      if (tell) room -= state_bytes;
      let upto = this.flying;
      for (; upto < this.queue.length; ++upto) {
        room -= bytes(this.queue[upto]) + 1;
        if (room < 0) break;
      }
      const left = [...this.queue.slice(0, this.flying), ...this.queue.slice(upto)];
      const quietly = (request) => request.catch((error) => console.warn("the learning platform: " + error));
      quietly(this.ask("POST", "statements", {}, [...this.queue.slice(this.flying, upto), last], {keepalive: true}));
      if (tell) quietly(this.ask("PUT", "activities/state", this.state(kStateId), this.body(left), {keepalive: true}));
      return false;
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
      this.had_key = "moltact/had/" + link.storage;  // the attempt that the platform had last
      this.silent = link.mode !== "normal";  // the platform only shows the lesson
      this.keeps = !link.nameless;
      this.there = stateOf(link.there);
      let here = this.keeps && store.get(this.unsent_key) || "";
      // The platform had this attempt and has it no longer: the teacher deleted it, or began a new one.
      if (!link.there && here && store.get(this.had_key) === stateOf(here)?.began) {
        store.drop(this.unsent_key);
        here = "";
      }
      if (this.keeps && this.there) store.set(this.had_key, this.there.began);
      this.suspended = fartherOf(link.there, here);
      this.began = null;
      this.from = 0;
      this.past_s = this.session_s = 0;  // of attempts of this session before the present one; with it
      this.lost = false;
      this.shown = "";
      this.committed_ms = 0;
      this.busy = false;
    }

    // The record with the interactions that the platform does not have; null without an attempt.
    look(now_ms) {
      let text = this.page.record(this.link.limit, this.from);
      if (!text) return null;
      let record = JSON.parse(text);
      if (record.began !== this.began) {  // begun, resumed or begun anew
        this.began = record.began;
        this.past_s = this.session_s;
        if (this.from) record = JSON.parse(this.page.record(this.link.limit, 0));
        const known_s = this.there && this.there.began === record.began ? this.there.t + 0.0005 : -1;
        // Of an attempt that goes on, the time of use so far belongs to earlier sessions.
        this.first_s = this.there?.began === record.began ? this.there.t : 0;
        const resumed = stateOf(this.suspended);
        this.earlier_s = resumed?.began === record.began ? resumed.t + 0.0005 : -1;
        record.interactions = record.interactions.filter((i) => i.t > known_s);
      }
      // The program knows the time of use, which stands still in pauses; the clock is read here.
      for (const i of record.interactions)
        if (i.t > this.earlier_s) i.at = new Date(now_ms - 1000 * (record.t - i.t)).toISOString().replace(/\.\d+/, "");
      return record;
    }

    async step(last = false, now_ms = Date.now()) {
      if (this.link.ended || (this.busy && !last)) return;
      const record = this.silent ? null : this.look(now_ms);
      if (!record) { if (last) this.link.end(); return; }
      const shown = JSON.stringify([record.place, record.done, record.of, record.score, record.began]);
      const wait_ms = this.lost ? kRetry_ms : kCommit_ms;
      const due = last || record.interactions.length || shown !== this.shown || now_ms - this.committed_ms >= wait_ms;
      if (!due) return;
      this.from = record.interaction_count;
      this.shown = shown;
      this.committed_ms = now_ms;
      if (this.keeps) store.set(this.unsent_key, record.suspended);  // until the platform has it
      this.busy = true;
      let sent = false;
      try {
        this.link.write(record, record.interactions, this.sessionTime(record));
        sent = last || await this.link.commit();
      } catch (error) {
        console.warn("the learning platform: " + error);
      }
      this.busy = false;
      if (this.link.ended) return;  // while this waited
      if (last) sent = this.link.end() && sent;
      if (sent && this.keeps) {
        store.drop(this.unsent_key);
        store.set(this.had_key, record.began);
      }
      if (this.link.ended) return;
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
