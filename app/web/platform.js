// The learning platform around a page that `moltact pack --scorm` or `--cmi5` made. page.js loads this text only in such
// a page. It finds the platform (SCORM 1.2, SCORM 2004 or cmi5), passes on the record that engine/results/learning_record.h
// computes, and keeps in the browser what a lost connection delays (docs/learning-platforms.md). cmi5.js stands before it.
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

  const Cmi5 = moltactCmi5({kWait_ms, stateOf, store, session, randomId, cut, iso, marked, storageOf});

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

    // The student goes back to the platform, which then has what it can have; what it does not take stays in this browser.
    async leave(window) {
      if (!this.busy) await this.step();
      window.location.assign(this.link.return_url);
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
