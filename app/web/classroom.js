// A student's side of a live class (docs/live-class.md), in a page that `moltact class` serves: the name, and the lines of
// the attempts, which go to the class's server as they are written. page.js loads this text only in such a page. The files
// of the attempts in the browser are the queue: what the server has not acknowledged is read from them again.
"use strict";

const moltactClassroom = (() => {
  const kPoll_ms = 2000, kRetry_ms = 3000, kGone_ms = 20000, kWait_ms = 10000, kShown_ms = 5000;
  const kPicture_ms = 500, kPictureWide = 640, kPictureHigh = 480, kMostPicture = 48 << 10, kQualities = [0.7, 0.5, 0.3];
  const kHere_ms = 250, kLeave_ms = 3000, kMostKeys = 9;
  const kMostBytes = 200000, kMostLines = 2000, kClosing_bytes = 60000;

  const kSentences = {
    en: {
      "welcome": "Join the class",
      "your name": "Your name",
      "what is seen": "Your teacher sees this name and what you do in the lesson, and can show predictions to the class without names. Name and work are kept on your teacher’s computer and in this browser.",
      "join": "Join",
      "animal": "Take an animal’s name",
      "go on as": "Go on as {0}",
      "someone else": "I am someone else",
      "which lesson": "Which lesson?",
      "full": "The class is full. Ask your teacher.",
      "over": "The class has ended, and nobody can join it any more.",
      "no answer": "The class does not answer. Try again.",
      "lost": "The class’s computer does not answer. Go on: your work is kept here and sent later.",
      "back": "The class’s computer answers again and has all of your work.",
      "unknown": "This class does not know this browser. Load the page again to join.",
      "gone": "This class is no longer served here. Your work is kept in this browser. Ask your teacher.",
      "refused": "The class’s computer takes no more of your work; it is kept in this browser. Tell your teacher.",
      "ended": "The class has ended. All of your work has arrived. What you do now stays in this browser.",
      "ended, some kept": "The class has ended. Some of your work is only in this browser. Tell your teacher.",
      "other tab": "You go on with this lesson in another tab. Close this one.",
      "many": "Many students join now. Wait a moment.",
      "hello": "You are {0}.",
      "scene asked": "Your teacher asks: may the class see your scene on the projector? It shows the molecule and your probe as you see them, and no answers, until you leave this step. You can stop it at any time.",
      "scene, with name": "Yes, with my name",
      "scene, without name": "Yes, without my name",
      "scene, no": "No",
      "scene shown": "The class can see your scene.",
      "scene, stop": "Stop",
    },
    de: {
      "welcome": "An der Klasse teilnehmen",
      "your name": "Dein Name",
      "what is seen": "Deine Lehrkraft sieht diesen Namen und was du in der Lektion tust, und kann der Klasse Vorhersagen ohne Namen zeigen. Name und Arbeit bleiben auf dem Computer deiner Lehrkraft und in diesem Browser.",
      "join": "Teilnehmen",
      "animal": "Einen Tiernamen nehmen",
      "go on as": "Als {0} weitermachen",
      "someone else": "Ich bin jemand anderes",
      "which lesson": "Welche Lektion?",
      "full": "Die Klasse ist voll. Frag deine Lehrkraft.",
      "over": "Die Klasse ist beendet, niemand kann mehr teilnehmen.",
      "no answer": "Die Klasse antwortet nicht. Versuch es noch einmal.",
      "lost": "Der Computer der Klasse antwortet nicht. Mach weiter: Deine Arbeit bleibt hier und wird später gesendet.",
      "back": "Der Computer der Klasse antwortet wieder und hat deine ganze Arbeit.",
      "unknown": "Diese Klasse kennt diesen Browser nicht. Lade die Seite neu, um teilzunehmen.",
      "gone": "Diese Klasse gibt es hier nicht mehr. Deine Arbeit bleibt in diesem Browser. Frag deine Lehrkraft.",
      "refused": "Der Computer der Klasse nimmt keine Arbeit von dir mehr an; sie bleibt in diesem Browser. Sag es deiner Lehrkraft.",
      "ended": "Die Klasse ist beendet. Deine ganze Arbeit ist angekommen. Was du jetzt tust, bleibt in diesem Browser.",
      "ended, some kept": "Die Klasse ist beendet. Ein Teil deiner Arbeit ist nur in diesem Browser. Sag es deiner Lehrkraft.",
      "other tab": "Du machst in einem anderen Tab mit dieser Lektion weiter. Schließe diesen hier.",
      "many": "Gerade nehmen viele teil. Warte einen Moment.",
      "hello": "Du bist {0}.",
      "scene asked": "Deine Lehrkraft fragt: Darf die Klasse deine Szene am Beamer sehen? Sie zeigt das Molekül und deine Sonde, wie du sie siehst, und keine Antworten, bis du diesen Schritt verlässt. Du kannst es jederzeit beenden.",
      "scene, with name": "Ja, mit meinem Namen",
      "scene, without name": "Ja, ohne meinen Namen",
      "scene, no": "Nein",
      "scene shown": "Die Klasse kann deine Szene sehen.",
      "scene, stop": "Beenden",
    },
  };

  const kStyle = `
    #class-join { position: absolute; inset: 0; z-index: 2; display: flex; align-items: center; justify-content: center; padding: 1.5em;
      background: radial-gradient(circle at 30% 20%, #eaf3fb, #f4f5f7 60%); overflow: auto; }
    #class-join form { width: min(26em, 100%); background: #fff; border: 1px solid #d9dfe6; border-radius: 16px; padding: 1.8em 2em 1.6em;
      box-shadow: 0 .6em 2.4em #1d243018; }
    #class-join h1 { font-size: 1.55em; margin: 0 0 .7em; letter-spacing: -.01em; }
    #class-join label { display: block; font-weight: 600; margin-bottom: .35em; }
    #class-join input { font: inherit; font-size: 1.15em; width: 100%; box-sizing: border-box; padding: .6em .8em; border: 1.5px solid #8894a8;
      border-radius: 10px; }
    #class-join p { color: #5a6675; margin: .6em 0 1.1em; line-height: 1.45; }
    #class-join p.fault { color: #b4480a; font-weight: 600; }
    #class-join button { font: inherit; font-weight: 600; width: 100%; padding: .75em 1em; margin-top: .6em; border-radius: 10px; cursor: pointer;
      border: 1.5px solid #2a6fdb; background: #fff; color: #1f5bb8; text-align: center; }
    #class-join button.first { background: #2a6fdb; color: #fff; }
    #class-join button:hover { filter: brightness(.96); }
    #class-join :focus-visible { outline: 3px solid #2a6fdb66; outline-offset: 2px; }
    #class-said { position: absolute; z-index: 2; right: .5em; bottom: .25em; max-width: calc(100% - 3em); padding: .15em .9em;
      border-radius: 1em; background: #1d2430; color: #fff; font-size: .82em; line-height: 1.45; pointer-events: none; }
    #class-said[hidden] { display: none; }
    #class-scene { position: absolute; z-index: 2; left: 50%; top: .6em; transform: translateX(-50%); box-sizing: border-box;
      width: min(34em, calc(100% - 1.2em)); padding: .9em 1.1em; border-radius: 12px; background: #fff; color: #1d2430;
      border: 1px solid #d9dfe6; box-shadow: 0 .4em 1.8em #1d243030; line-height: 1.4; }
    #class-scene.showing { width: auto; display: flex; align-items: center; gap: 1em; padding: .35em .5em .35em 1em; background: #b4480a;
      color: #fff; border: 0; white-space: nowrap; }
    #class-scene p { margin: 0; }
    #class-scene .answers { display: flex; flex-wrap: wrap; gap: .5em; margin-top: .7em; }
    #class-scene button { font: inherit; font-weight: 600; padding: .5em .9em; border-radius: 9px; cursor: pointer; border: 1.5px solid #2a6fdb;
      background: #fff; color: #1f5bb8; }
    #class-scene.showing button { border-color: #fff; color: #8f3808; padding: .3em .8em; }
    #class-scene button:hover { filter: brightness(.96); }
    #class-scene :focus-visible { outline: 3px solid #2a6fdb66; outline-offset: 2px; }`;

  const guarded = (storage) => ({
    get(key) { try { return storage().getItem(key); } catch { return null; } },
    set(key, text) { try { storage().setItem(key, text); } catch { /* the browser blocks it: a new student next time */ } },
  });
  const store = guarded(() => localStorage);

  function sentencesOf(locale) {
    const code = (locale || "").toLowerCase().split("-")[0];
    const table = Object.hasOwn(kSentences, code) ? kSentences[code] : kSentences.en;
    return (key, ...pieces) => (table[key] ?? kSentences.en[key]).replace(/\{(\d)\}/g, (_, k) => String(pieces[k]));
  }

  async function post(path, body, more = {}) {
    const signal = more.keepalive ? undefined : AbortSignal.timeout(kWait_ms);
    const reply = await fetch(path, {method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify(body),
                                     credentials: "omit", cache: "no-store", signal, ...more});
    let json = {};
    try { json = await reply.json(); } catch { /* a sentence for people */ }
    return {status: reply.status, json};
  }

  // ---- lines ------------------------------------------------------------------------------------------------------------

  // The complete lines of a growing file from the byte `at` on, as many as fit into one request: [lines, bytes after them].
  function linesFrom(bytes, at, most_bytes = kMostBytes, most_lines = kMostLines) {
    const lines = [], decoder = new TextDecoder();
    const first = at;
    for (let end = bytes.indexOf(10, at); end >= 0 && lines.length < most_lines; end = bytes.indexOf(10, at)) {
      if (lines.length && end + 1 - first > most_bytes) break;
      lines.push(decoder.decode(bytes.subarray(at, end)));
      at = end + 1;
    }
    return [lines, at];
  }

  // The byte behind the first `count` lines; -1 if there are not so many.
  function behind(bytes, count) {
    let at = 0;
    for (let k = 0; k < count; ++k) {
      const end = bytes.indexOf(10, at);
      if (end < 0) return -1;
      at = end + 1;
    }
    return at;
  }

  // The attempt's name at the server. With `other` keys, the first was taken by lines that this page does not have.
  const keyOf = (file, other = 0) =>
      file.replace(/\.jsonl$/, "").replace(/[^A-Za-z0-9_-]/g, "-").slice(0, 98) + (other ? "-" + (other + 1) : "");

  // FNV-1a, 32 bits, of a line in UTF-8; as lineMark() of engine/classroom/class_room.h.
  function markOf(line) {
    let out = 0x811c9dc5;
    for (const byte of new TextEncoder().encode(line)) out = Math.imul(out ^ byte, 0x01000193) >>> 0;
    return out;
  }

  // One page sends for a student. A page that begins asks older ones of the same student to store what they have and to stop.
  // `ready` resolves when they have, or do not answer; leave() is called when a newer page asks.
  function turnOf(name, Channel = globalThis.BroadcastChannel, here_ms = kHere_ms, leave_ms = kLeave_ms) {
    const turn = {ready: Promise.resolve(), taken: false, leave: async () => {}};
    if (!Channel) return turn;
    const channel = new Channel(name), own = String(Math.random());
    turn.ready = new Promise((done) => {
      let timer = setTimeout(done, here_ms);
      channel.onmessage = async ({data}) => {
        if (data.to === own && data.say === "here") {
          clearTimeout(timer);
          timer = setTimeout(done, leave_ms);
        } else if (data.to === own && data.say === "left") {
          clearTimeout(timer);
          done();
        } else if (data.say === "begin" && !turn.taken) {
          turn.taken = true;
          channel.postMessage({say: "here", to: data.from});
          try { await turn.leave(); } catch (error) { console.warn("the class: " + error); }
          channel.postMessage({say: "left", to: data.from});
        }
      };
    });
    channel.postMessage({say: "begin", from: own});
    return turn;
  }

  // Sends what is new. `page`: files() lists the attempts' names; read(name) gives the bytes that the browser has stored, so
  // that the server never has more than a page that is loaded again, and read(name, true) all; held(table) and
  // said(key, stays) tell what the class says.
  class Sender {
    constructor(token, page, ask = post) {
      this.token = token;
      this.page = page;
      this.ask = ask;
      this.places = new Map();  // by file: {have: acknowledged lines, at: the byte behind them}; missing before the first answer
      this.others = new Map();  // by file: how many keys were found taken
      this.lost = this.gone = this.busy = this.ended = this.over = this.few = false;
      this.wait_until_ms = 0;
    }

    key(file) { return keyOf(file, this.others.get(file) || 0); }

    // The first file with something to send, and what.
    next(most_bytes, all) {
      for (const file of this.page.files()) {
        const place = this.places.get(file);
        if (!place) return {file, from: 0, lines: [], behind: 0};  // asks how much the server has
        if (place.refused) continue;
        const bytes = this.page.read(file, all);
        if (bytes.length <= place.at) continue;
        const [lines, after] = linesFrom(bytes, place.at, most_bytes);
        if (lines.length) return {file, from: place.have, lines, behind: after};
      }
      return null;
    }

    // One round: everything that waits. Returns "all" if the server has all of it, "lost" if it does not answer, "gone" if
    // another one answers, "later" if it has asked to wait.
    async round() {
      for (let first = true;; first = false) {
        const batch = this.next(this.few ? 1 : undefined);
        if (!batch && !first) return "all";
        const body = {token: this.token};
        if (batch) Object.assign(body, {attempt: this.key(batch.file), from: batch.from, lines: batch.lines});
        const {status, json} = await this.ask("lines", body);
        if (this.over) return "all";  // another tab has gone on meanwhile
        if (status === 403 && json.unknown) { this.over = true; this.page.said("unknown", true); return "lost"; }
        if (status === 404) return "gone";
        if (status === 429 || status === 503) return "later";
        if (status === 413 && batch && batch.lines.length > 1 && !this.few) { this.few = true; continue; }
        this.few = false;
        if (json.held) this.page.held(json.held);
        if (status === 200) this.page.scene?.(json.scene ?? null);
        if (json.ended !== undefined) this.ended = json.ended === true;
        if (!batch) return status === 200 ? "all" : "lost";
        if (Number.isInteger(json.have)) this.take(batch, status, json);
        else if (status >= 400 && status < 500 && ![403, 408, 409, 410].includes(status)) this.refuse(batch.file, {have: 0, at: 0});
        else return "lost";
      }
    }

    refuse(file, place) {
      this.places.set(file, {...place, refused: true});
      this.page.said("refused", true);
    }

    take(batch, status, json) {
      const bytes = this.page.read(batch.file, true), at = behind(bytes, json.have);
      // Lines that are not those of this file, as of a page that stored them and was killed before, or of another tab. The
      // first line is not compared: the server writes another name into it.
      const last = json.have > 1 && at >= 0 ? linesFrom(bytes, behind(bytes, json.have - 1), 1)[0][0] : null;
      if (at < 0 || (last !== null && Number.isInteger(json.last) && json.last !== markOf(last))) {
        const others = (this.others.get(batch.file) || 0) + 1;
        if (others >= kMostKeys) return this.refuse(batch.file, {have: json.have, at: bytes.length});
        this.others.set(batch.file, others);
        this.places.delete(batch.file);
        return;
      }
      this.places.set(batch.file, {have: json.have, at});
      if (status === 400 || status === 507) this.refuse(batch.file, {have: json.have, at});
    }

    async step(now_ms = Date.now()) {
      if (this.busy || this.over || now_ms < this.wait_until_ms) return;
      this.busy = true;
      let got = "lost";
      try {
        got = await this.round();
      } catch (error) {
        console.warn("the class: " + error);
      }
      this.busy = false;
      if (this.over) return;
      const all = got === "all", gone = got === "gone";
      this.wait_until_ms = all ? 0 : now_ms + (gone ? kGone_ms : kRetry_ms);
      if (got === "later") return;
      // Also what the browser has not yet stored has to arrive first.
      if (all && this.ended && this.next(undefined, true)) return;
      if (all && this.ended) {
        this.over = true;
        this.page.said([...this.places.values()].some((place) => place.refused) ? "ended, some kept" : "ended", true);
      } else if (all === this.lost || (!all && gone !== this.gone)) {
        this.page.said(all ? "back" : got, !all);
        if (!all) this.page.held({});  // who loses the server goes on, also where the class waits
      }
      this.lost = !all;
      this.gone = gone;
    }

    // The page closes: what fits into a request that outlives it, also what is not yet stored.
    last() {
      const batch = this.over ? null : this.next(kClosing_bytes, true);
      if (!batch || !batch.lines.length) return;
      const body = {token: this.token, attempt: this.key(batch.file), from: batch.from, lines: batch.lines};
      if (new TextEncoder().encode(JSON.stringify(body)).length > kClosing_bytes) return;
      this.ask("lines", body, {keepalive: true}).catch(() => {});
    }
  }

  // ---- the scene, for the class to see ------------------------------------------------------------------------------------

  // The teacher's question and the student's answer; then pictures, until the student stops, the step is left or the class
  // says that it is over. `page`: ask(answer) shows the question, showing(stop) that the class can see the scene, quiet()
  // neither; place() gives {lesson, step}, or null; picture() resolves to base64, "" if the scene may not be seen now.
  class SceneShare {
    constructor(token, page, ask = post) {
      this.token = token;
      this.page = page;
      this.ask = ask;
      this.asked = this.answered = this.shown = 0;  // the numbers of questions
      this.place = null;
      this.busy = false;
    }

    // What the class's computer says with each answer: {ask: number}, {show: number} or null.
    heard(scene) {
      const asked = scene?.ask || 0, show = scene?.show || 0;
      if (asked && asked > this.answered) {
        if (asked !== this.asked) {
          this.asked = asked;
          this.page.ask((yes, named) => this.answer(asked, yes, named));
        }
      } else if (this.asked && !asked) {
        this.asked = 0;
        if (!this.shown) this.page.quiet();
      }
      if (this.shown && show !== this.shown && !this.busy && !asked) this.over();
      // What a page agreed to before it was loaded again, or what it did not hear the answer of, is not shown.
      if (show && show !== this.shown && !this.busy) this.send({scene: show, say: "stop"});
    }

    over() {
      this.shown = 0;
      this.page.quiet();
    }

    async send(body) {
      try { return await this.ask("scene", {token: this.token, ...body}); } catch { return {status: 0, json: {}}; }
    }

    async answer(number, yes, named) {
      this.answered = number;
      this.asked = 0;
      this.page.quiet();
      this.place = this.page.place();
      this.busy = true;
      const {status} = await this.send({scene: number, say: yes && this.place ? "yes" : "no", named: Boolean(named), ...this.place});
      this.busy = false;
      if (status !== 200 || !yes || !this.place) return;
      this.shown = number;
      this.page.showing(() => this.stop());
    }

    // Nothing more is sent from this moment on, whether or not the class's computer hears it.
    async stop() {
      const number = this.shown;
      this.over();
      if (number) await this.send({scene: number, say: "stop"});
    }

    async step() {
      if (!this.shown || this.busy) return;
      const number = this.shown, at = this.page.place();
      if (!at || at.lesson !== this.place.lesson || at.step !== this.place.step) return this.stop();
      this.busy = true;
      const picture = await this.page.picture();
      // Meanwhile the student may have stopped it.
      const reply = this.shown === number ? await this.send({scene: number, ...at, picture}) : {status: 0};
      this.busy = false;
      if (this.shown === number && [403, 404, 410].includes(reply.status)) this.over();
    }
  }

  // A picture of a part of the canvas, small enough for the class's computer; "" if it does not become so small.
  async function smallPicture(canvas, [x, y, wide, high], document) {
    const scale = Math.min(1, kPictureWide / wide, kPictureHigh / high);
    const small = document.createElement("canvas");
    small.width = Math.max(1, Math.round(wide * scale));
    small.height = Math.max(1, Math.round(high * scale));
    small.getContext("2d").drawImage(canvas, x, y, wide, high, 0, 0, small.width, small.height);
    for (const quality of kQualities) {
      const text = small.toDataURL("image/jpeg", quality), at = text.indexOf(",") + 1;
      if (text.startsWith("data:image/jpeg") && (text.length - at) * 3 / 4 <= kMostPicture) return text.slice(at);
    }
    return "";
  }

  // The question and the mark that the class can see the scene, over the view.
  function sceneBox(say) {
    let box = null;
    const show = (look, text, ...buttons) => {
      box?.remove();
      box = element("div", {id: "class-scene", className: look}, element("p", {textContent: text}), ...buttons);
      box.setAttribute("role", look ? "status" : "alertdialog");
      box.setAttribute("aria-label", text);
      document.body.append(box);
    };
    const button = (key, act) => {
      const out = element("button", {type: "button", textContent: say(key)});
      out.addEventListener("click", act);
      return out;
    };
    return {
      ask: (answer) => show("", say("scene asked"), element("div", {className: "answers"}, button("scene, with name", () => answer(true, true)),
                                                            button("scene, without name", () => answer(true, false)),
                                                            button("scene, no", () => answer(false, false)))),
      showing: (stop) => show("showing", say("scene shown"), button("scene, stop", stop)),
      quiet: () => { box?.remove(); box = null; },
    };
  }

  // ---- joining ------------------------------------------------------------------------------------------------------------

  function element(name, content = {}, ...children) {
    const out = Object.assign(document.createElement(name), content);
    out.append(...children);
    return out;
  }

  // The students of this browser, the latest first: [{name, token, number}]. Nobody is dropped: with the token the page also
  // finds the work that it has not sent.
  function studentsIn(text) {
    let kept = null;
    try { kept = JSON.parse(text || "null"); } catch { /* damaged */ }
    return (Array.isArray(kept) ? kept : [kept]).filter((one) => one && one.token && one.name && Number.isInteger(one.number));
  }
  function withStudent(students, student) {
    return [student, ...students.filter((one) => one.token !== student.token)];
  }

  // Asks for the name and, of several lessons, for one. Resolves to {name, token, number, lesson, say, turn} when no other
  // tab sends for this student.
  function join(facts, window, locale) {
    const say = sentencesOf(locale), kept_key = "moltact/class/" + facts.code;
    document.head.append(element("style", {textContent: kStyle}));
    const form = element("form"), over = element("div", {id: "class-join"}, form);
    const students = studentsIn(store.get(kept_key));
    let student = null;
    document.body.append(over);
    return new Promise((done) => {
      const finish = async (lesson) => {
        over.remove();
        store.set(kept_key, JSON.stringify(withStudent(studentsIn(store.get(kept_key)), student)));
        const turn = turnOf(kept_key + "/" + student.number);
        await turn.ready;
        done({...student, lesson, say, turn});
      };
      const joined = () => {
        if (facts.lessons.length > 1) askLesson();
        else finish(facts.lessons.length ? 0 : -1);
      };
      const show = (...parts) => { form.replaceChildren(...parts); form.querySelector("input, button")?.focus(); };
      const button = (key, look, act, ...pieces) => {
        const out = element("button", {type: "button", className: look, textContent: say(key, ...pieces)});
        out.addEventListener("click", act);
        return out;
      };

      function askLesson() {
        const rows = facts.lessons.map((lesson, k) => {
          const row = element("button", {type: "button", textContent: lesson.title});
          row.addEventListener("click", () => finish(k));
          return row;
        });
        form.onsubmit = (event) => event.preventDefault();
        show(element("h1", {textContent: say("which lesson")}), element("p", {textContent: say("hello", student.name)}), ...rows);
      }

      function askName(fault = "") {
        const name = element("input", {id: "class-name", maxLength: 40, autocomplete: "off", spellcheck: false});
        const enter = async (wanted) => {
          for (const one of form.querySelectorAll("button")) one.disabled = true;
          let key = "no answer";
          try {
            let {status, json} = await post("join", {name: wanted});
            while (status === 429) {
              form.querySelector("p").textContent = say("many");
              await new Promise((done) => setTimeout(done, 1000 + 2000 * Math.random()));
              ({status, json} = await post("join", {name: wanted}));
            }
            if (status === 200) {
              student = {name: json.name, token: json.token, number: json.number};
              store.set(kept_key, JSON.stringify(withStudent(studentsIn(store.get(kept_key)), student)));
              return joined();
            }
            key = status === 410 ? "over" : status === 409 ? "full" : key;
          } catch (error) { console.warn("the class: " + error); }
          askName(key);
        };
        const first = element("button", {type: "submit", className: "first", textContent: say("join")});
        form.onsubmit = (event) => {
          event.preventDefault();
          if (name.value.trim()) enter(name.value);
          else name.focus();
        };
        show(element("h1", {textContent: say("welcome")}),
             element("label", {htmlFor: "class-name", textContent: say("your name")}), name,
             ...(fault ? [element("p", {className: "fault", role: "alert", textContent: say(fault)})] : []),
             element("p", {textContent: say("what is seen")}), first, button("animal", "", () => enter("")));
      }

      function askWhether() {
        form.onsubmit = (event) => event.preventDefault();
        show(element("h1", {textContent: say("welcome")}),
             ...students.map((one, k) => button("go on as", k ? "" : "first", () => { student = one; joined(); }, one.name)),
             button("someone else", "", () => askName()));
      }
      if (students.length) askWhether();
      else askName();
    });
  }

  // Begins to send. `page` as of Sender, but said(), which is a line over the view here; leave() stores everything and
  // then no more, because another tab goes on.
  function begin(student, page, window) {
    const line = element("div", {id: "class-said", hidden: true});
    line.setAttribute("role", "status");
    document.body.append(line);
    let timer = 0;
    const said = (key, stays) => {
      clearTimeout(timer);
      line.textContent = student.say(key, student.name);
      line.hidden = false;
      if (!stays) timer = setTimeout(() => { line.hidden = true; }, kShown_ms);
    };
    const scene = new SceneShare(student.token, {...sceneBox(student.say), place: page.place, picture: page.picture});
    const sender = new Sender(student.token, {...page, said, scene: (heard) => scene.heard(heard)});
    setInterval(() => scene.step(), kPicture_ms);
    student.turn.leave = async () => {
      sender.over = true;
      scene.stop();
      sender.page.held({});
      await page.leave();
      document.body.append(element("div", {id: "class-join"}, element("form", {}, element("h1", {textContent: student.say("other tab")}))));
    };
    if (student.turn.taken) student.turn.leave();
    // Not all pages of a class at the same moment.
    setTimeout(() => { sender.step(); setInterval(() => sender.step(), kPoll_ms); }, Math.random() * kPoll_ms);
    window.addEventListener("pagehide", () => sender.last());
    window.addEventListener("online", () => { sender.wait_until_ms = 0; sender.step(); });
    said("hello", false);
    return sender;
  }

  return {join, begin, Sender, SceneShare, smallPicture, linesFrom, behind, keyOf, markOf, turnOf, studentsIn, withStudent, sentencesOf, kSentences};
})();
