// cmi5: the session with the platform's record store, in statements of xAPI (docs/learning-platforms.md). Stands before
// platform.js in the page, and takes from it what all platforms share.
"use strict";

const moltactCmi5 = ({kWait_ms, stateOf, store, session, randomId, cut, iso, marked, storageOf}) => {
  const kAdl = "http://adlnet.gov/expapi/verbs/", kCmi5 = "https://w3id.org/xapi/cmi5/context/categories/";
  const kTypes = "http://adlnet.gov/expapi/activities/", kProgress = "https://w3id.org/xapi/cmi5/result/extensions/progress";
  const kMisconceptions = "urn:uuid:5d1c4f0e-6a8b-8c3e-9f27-0b7a51e4c629#misconceptions";
  const kAttempt = "urn:uuid:5d1c4f0e-6a8b-8c3e-9f27-0b7a51e4c629#attempt";
  const kMastery = "https://w3id.org/xapi/cmi5/context/extensions/masteryscore";
  const kStateId = "moltact";

  // Where the platform wants the learner back; null for anything but an address of the web.
  function returnAddress(text) {
    try {
      const url = new URL(text);
      return ["http:", "https:"].includes(url.protocol) ? url.href : null;
    } catch { return null; }
  }

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
      this.return_url = returnAddress(this.launch.returnURL);
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
        if (typeof mastery === "number" && record.score !== null) {
          const judged = this.defined(record.score >= mastery ? "passed" : "failed",
                                      {success: record.score >= mastery, score: {scaled: record.score}, duration: iso(session_s)}, "moveon");
          judged.context.extensions = {...judged.context.extensions, [kMastery]: mastery};
          this.add(judged);
        }
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

  return Cmi5;
};
