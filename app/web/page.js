// The page around the program: unpacks it, stores its files, receives input, requests frames, and describes the canvas
// in words. The functions _moltact_… are those of app/ui/shell/window_web.cpp.
(async () => {
  "use strict";
  const byId = (id) => document.getElementById(id);
  const canvas = byId("view"), said = byId("said"), keyboard = byId("keyboard");
  const spoken = moltactLanguage(navigator.language);
  const sentence = (key, ...pieces) => moltactSentence(spoken, key, ...pieces);
  const say = (key, ...pieces) => { said.textContent = sentence(key, ...pieces); said.hidden = false; };

  // ---- what came with the page ------------------------------------------------------------------------------------

  async function unpacked(id, compressed = true) {
    const text = byId(id).textContent;
    byId(id).remove();
    const packed = Uint8Array.fromBase64 ? Uint8Array.fromBase64(text)
                                         : Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    if (!compressed) return packed;
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  }

  function folderOf(path) { return path.slice(0, path.lastIndexOf("/")); }

  function put(FS, path, bytes) {
    FS.mkdirTree(folderOf(path));
    FS.writeFile(path, bytes);
  }

  function putFiles(FS, run) {
    const head = new DataView(run.buffer, run.byteOffset).getUint32(0, true);
    let at = 4 + head;
    for (const [path, size] of JSON.parse(new TextDecoder().decode(run.subarray(4, at)))) {
      put(FS, path, run.subarray(at, at + size));
      at += size;
    }
  }

  // ---- what is kept: the files under the person's folder, in IndexedDB -----------------------------------------------

  const kHome = "/home/web_user", kSoon_ms = 250;
  const keeper = {
    // The name of the storage. In a learning platform each learner of a computer has a storage of his own.
    name: "moltact", last: "moltact/last",
    base: null, known: new Map(), timer: 0, failing: false, FS: null, changes: 0, left: 0,

    ask(request) {
      return new Promise((done, failed) => {
        request.onsuccess = () => done(request.result);
        request.onerror = () => failed(request.error);
      });
    },

    async load(FS) {
      this.FS = FS;
      try {
        const opening = indexedDB.open(this.name, 1);
        opening.onupgradeneeded = () => opening.result.createObjectStore("files");
        this.base = await this.ask(opening);
        const files = this.base.transaction("files").objectStore("files");
        const [names, contents] = await Promise.all([this.ask(files.getAllKeys()), this.ask(files.getAll())]);
        names.forEach((name, k) => {
          put(FS, name, contents[k]);
          this.known.set(name, this.mark(name));
        });
      } catch (error) {
        this.failed(error);
      }
      this.take();
    },

    // A browser may end a hidden page before a database transaction completes. The last change is therefore also
    // written to localStorage, which is synchronous, until the database has stored it.
    leave(fresh, gone) {
      const text = (bytes) => { let out = ""; for (const b of bytes) out += String.fromCharCode(b); return btoa(out); };
      try {
        const files = fresh.map((path) => [path, text(this.FS.readFile(path))]);
        localStorage.setItem(this.last, JSON.stringify({ files, gone }));
        this.left = this.changes;
      } catch (error) {
        // localStorage is unavailable or too small: only the database stores it.
      }
    },

    take() {
      try {
        const last = JSON.parse(localStorage.getItem(this.last) || "null");
        if (!last) return;
        for (const [path, text] of last.files) put(this.FS, path, Uint8Array.from(atob(text), (c) => c.charCodeAt(0)));
        for (const path of last.gone) if (this.FS.analyzePath(path).exists) this.FS.unlink(path);
        this.changed();
      } catch (error) {
        console.warn("what was kept last cannot be read: " + error);
      }
    },

    mark(name) {
      const is = this.FS.stat(name);
      return is.size + " " + Number(is.mtime);
    },

    all(folder, into) {
      for (const name of this.FS.readdir(folder)) {
        if (name === "." || name === "..") continue;
        const path = folder + "/" + name;
        if (this.FS.isDir(this.FS.stat(path).mode)) this.all(path, into);
        else if (!name.startsWith(".moltact-")) into.push(path);
      }
      return into;
    },

    changed() {
      if (!this.timer) this.timer = setTimeout(() => this.save(), kSoon_ms);
    },

    // `last`: the page may end after this call.
    save(last = false) {
      clearTimeout(this.timer);
      this.timer = 0;
      if (!this.base) return Promise.resolve();
      const marks = new Map(this.all(kHome, []).map((path) => [path, this.mark(path)]));
      const fresh = [...marks].filter(([path, mark]) => this.known.get(path) !== mark).map(([path]) => path);
      const gone = [...this.known.keys()].filter((path) => !marks.has(path));
      if (!fresh.length && !gone.length) return Promise.resolve();
      const number = ++this.changes;
      if (last) this.leave(fresh, gone);
      return new Promise((done) => {
        try {
          const change = this.base.transaction("files", "readwrite");
          const files = change.objectStore("files");
          for (const path of fresh) files.put(this.FS.readFile(path), path);
          for (const path of gone) files.delete(path);
          change.oncomplete = () => {
            this.known = marks;
            this.failing = false;
            if (number >= this.left) this.drop();
            done();
          };
          change.onabort = () => { this.failed(change.error); done(); };
        } catch (error) {
          this.failed(error);
          done();
        }
      });
    },

    drop() {
      try { localStorage.removeItem(this.last); } catch (error) { /* there is none */ }
    },

    // How many bytes of a file the database has; all, if nothing can be stored.
    stored(path) {
      if (!this.base || this.failing) return Infinity;
      return Number((this.known.get(path) || "0").split(" ")[0]);
    },

    // Stores what is there, and then nothing more: another tab goes on with the same files.
    async leaveToOther() {
      await this.save();
      this.base = null;
    },

    failed(error) {
      if (this.failing) return;  // report only once
      this.failing = true;
      const full = error && error.name === "QuotaExceededError";
      if (program) program._moltact_storage_fault(full ? 1 : 0);
      else this.early = true;
    },
  };

  // ---- words: messages for screen readers, and the text on the screen ---------------------------------------------------

  const kMaxNews = 60;
  function news(line) {
    const p = document.createElement("p");
    p.textContent = line;
    const log = byId("news");
    log.append(p);
    while (log.childElementCount > kMaxNews) log.firstElementChild.remove();
  }

  // The buttons in the text are not <button> elements, because their words could not be selected.
  let words_shown = "";
  const selecting = () => !getSelection().isCollapsed && byId("words").contains(getSelection().anchorNode);
  function mirror() {
    const now = program.ccall("moltact_words", "string", [], []);
    if (now === words_shown || selecting() || reading()) return;
    words_shown = now;
    const parts = JSON.parse(now).map(([text, x, y]) => {
      const part = document.createElement("p");
      part.textContent = text;
      if (x >= 0) {
        part.setAttribute("role", "button");
        part.tabIndex = -1;  // keys go through the canvas; a screen reader activates the element here
        part.addEventListener("click", () => { if (!selecting()) tap(x, y); });
      }
      return part;
    });
    byId("page").replaceChildren(...parts);
  }

  // Ctrl+A shows the text and selects all of it; Escape or the canvas hides it. Meanwhile it is not updated, because
  // the selection would move under the pointer.
  const reading = () => byId("words").classList.contains("read");
  function read(on) {
    if (on) mirror();
    byId("words").classList.toggle("read", on);
    if (on) {
      byId("words").focus({preventScroll: true});
      getSelection().selectAllChildren(byId("page"));
    } else {
      getSelection().removeAllRanges();
      canvas.focus({preventScroll: true});
    }
  }

  // ---- frames --------------------------------------------------------------------------------------------------------

  const kIdle_ms = 200, kSettle = 3, kWords_ms = 500;
  let program = null, settle = kSettle, drawn_ms = 0, words_ms = 0, state = 1;
  const stir = () => { settle = kSettle; };
  const ratio = () => window.devicePixelRatio || 1;

  function frame(now_ms) {
    requestAnimationFrame(frame);
    const width = Math.max(1, Math.round(canvas.clientWidth * ratio()));
    const height = Math.max(1, Math.round(canvas.clientHeight * ratio()));
    const resized = canvas.width !== width || canvas.height !== height;
    if (!resized && !(state & 1) && settle <= 0 && now_ms - drawn_ms < kIdle_ms) return;
    if (resized) { canvas.width = width; canvas.height = height; stir(); }
    if (settle > 0) --settle;
    const dt_s = drawn_ms ? (now_ms - drawn_ms) / 1000 : 1 / 60;
    drawn_ms = now_ms;
    program._moltact_fingers(performance.now() / 1000);
    hid.deal(dt_s);
    state = program._moltact_frame(width, height, ratio(), dt_s);
    ++page.frames;
    if (now_ms - words_ms > kWords_ms) { words_ms = now_ms; mirror(); }
  }

  // ---- mouse, fingers, pens --------------------------------------------------------------------------------------------

  const kButtons = [0, 2, 1];  // of the page: left, middle, right; of the program: left, right, middle
  const place = (event) => [event.offsetX * ratio(), event.offsetY * ratio()];
  const now_s = () => performance.now() / 1000;

  function hearPointers() {
    canvas.addEventListener("pointerdown", (event) => {
      stir();
      if (reading()) read(false);
      canvas.focus({preventScroll: true});
      canvas.setPointerCapture(event.pointerId);
      event.preventDefault();
      if (event.pointerType === "touch") return program._moltact_finger_down(event.pointerId, ...place(event), now_s());
      program._moltact_pointer(...place(event));
      program._moltact_button(kButtons[event.button] ?? 0, 1);
      if (event.pointerType === "pen") program._moltact_pen(event.pressure);
    });
    canvas.addEventListener("pointermove", (event) => {
      stir();
      if (event.pointerType === "touch") return program._moltact_finger_move(event.pointerId, ...place(event), now_s());
      program._moltact_pointer(...place(event));
      if (event.pointerType === "pen" && event.buttons & 1) program._moltact_pen(event.pressure);
    });
    canvas.addEventListener("pointerup", (event) => {
      stir();
      if (event.pointerType === "touch") program._moltact_finger_up(event.pointerId, now_s());
      else program._moltact_button(kButtons[event.button] ?? 0, 0);
      if (state & 2) keyboard.focus({preventScroll: true});
    });
    canvas.addEventListener("pointercancel", (event) => {
      stir();
      if (event.pointerType === "touch") program._moltact_finger_up(event.pointerId, now_s());
      else program._moltact_focus_lost();
    });
    canvas.addEventListener("pointerleave", (event) => {
      if (event.pointerType !== "touch" && !event.buttons) { stir(); program._moltact_pointer_left(); }
    });
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => {
      stir();
      event.preventDefault();
      const notch = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 100 : event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 3 : 1;
      program._moltact_wheel(-event.deltaX / notch, -event.deltaY / notch);
    }, {passive: false});
  }

  async function tap(x, y) {
    program._moltact_pointer(x, y);
    stir();
    program._moltact_button(0, 1);
    program._moltact_button(0, 0);
  }

  // ---- keys and text ---------------------------------------------------------------------------------------------------

  const kBrowsers = new Set(["F5", "F12"]);  // left to the browser

  const tellKey = (code, writes, down) =>
    program.ccall("moltact_key", "number", ["string", "string", "number"], [code, writes, down]);
  // The key's own character; a letter is the same with Shift and Ctrl.
  function written(event) {
    if ([...event.key].length !== 1 || event.getModifierState("AltGraph") || event.altKey) return "";
    const small = event.key.toLowerCase();
    return small !== event.key.toUpperCase() || !event.shiftKey ? small : "";
  }

  function hearKeys() {
    // The canvas, and the field for on-screen keyboards.
    addEventListener("keydown", (event) => {
      if (event.target instanceof HTMLButtonElement || byId("ask").open || byId("code-form").open || kBrowsers.has(event.code)) return;
      stir();
      const command = event.ctrlKey || event.metaKey;
      if (command && event.key.toLowerCase() === "a" && !(state & 2)) {
        event.preventDefault();
        return read(true);
      }
      if (reading()) {
        if (event.code === "Escape") read(false);
        return;
      }
      if (command && (event.code === "KeyV" || event.code === "KeyR")) return;  // pasting is a separate event
      const taken = tellKey(event.code, written(event), 1);
      if ([...event.key].length === 1 && !(command && !event.getModifierState("AltGraph")) && event.target !== keyboard)
        program.ccall("moltact_text", null, ["string"], [event.key]);
      if (taken && event.target !== keyboard) event.preventDefault();
    });
    addEventListener("keyup", (event) => {
      stir();
      tellKey(event.code, "", 0);
    });
    keyboard.addEventListener("input", () => {
      stir();
      program.ccall("moltact_text", null, ["string"], [keyboard.value]);
      keyboard.value = "";
    });
    addEventListener("paste", (event) => {
      stir();
      program.ccall("moltact_clipboard", null, ["string"], [event.clipboardData.getData("text")]);
      for (const down of [1, 0]) tellKey("KeyV", "v", down);
      event.preventDefault();
    });
    addEventListener("blur", () => { stir(); program._moltact_focus_lost(); });
    document.addEventListener("visibilitychange", () => {
      stir();
      if (document.hidden) { program._moltact_focus_lost(); keeper.save(true); }
    });
    addEventListener("pagehide", () => keeper.save(true));
    document.addEventListener("fullscreenchange", () => program._moltact_full_screen(document.fullscreenElement ? 1 : 0));
  }

  // ---- files of the person's own -----------------------------------------------------------------------------------------

  const kOwn = kHome + "/.local/share/moltact/lessons/", kPassing = "/tmp/moltact/";
  const open = (file) => { stir(); program.ccall("moltact_open", null, ["string"], [file]); };

  async function take(files) {
    // Opens the last file, because lessons may need the molecules beside them. A pack is unpacked, so the pack itself
    // is not stored.
    let last = "";
    for (const file of [...files].sort((a, b) => a.name.endsWith(".md") - b.name.endsWith(".md"))) {
      const pack = file.name.toLowerCase().endsWith(".moltact");
      last = (pack ? kPassing : kOwn) + file.name.replace(/[\\/\0]/g, "_");
      put(program.FS, last, new Uint8Array(await file.arrayBuffer()));
    }
    if (!last) return;
    keeper.changed();
    open(last);
  }

  // A page of a study that assigns by a draw (moltact study): the code decides which of its packs the student gets. Each
  // code has a storage of its own, so that no student of a shared computer finds the lessons of another group.
  let code = "";
  async function joinStudy() {
    const draw = byId("study-draw");
    if (!draw) return;
    const study = JSON.parse(draw.textContent), key = "moltact/study/" + study.study;
    const group = (text) => Object.hasOwn(study.codes, text) ? study.codes[text] : null;
    try { code = sessionStorage.getItem(key) || ""; } catch { /* blocked */ }
    if (!group(code)) {
      said.hidden = true;
      const form = byId("code-form"), field = form.querySelector("input");
      form.querySelector("p").textContent = sentence("your code");
      form.querySelector("button").textContent = sentence("begin");
      form.showModal();
      code = await new Promise((done) => {
        form.oncancel = (event) => event.preventDefault();
        form.querySelector("form").onsubmit = (event) => {
          event.preventDefault();
          const given = field.value.trim().toUpperCase();
          if (group(given)) done(given);
          else form.querySelector("p").textContent = sentence("no such code", given);
        };
      });
      form.close();
      try { sessionStorage.setItem(key, code); } catch { /* blocked */ }
    }
    byId("pack-bytes-" + group(code)).id = "pack-bytes";
    keeper.last = "moltact/last/" + (keeper.name = `moltact study ${study.study} ${code}`);
  }

  // A lesson embedded in the page (moltact pack --html).
  async function takeAlong() {
    const along = byId("pack-bytes");
    if (!along) return false;
    const file = kPassing + along.dataset.name;
    put(program.FS, file, await unpacked("pack-bytes", false));
    if (code) program.ccall("moltact_code", null, ["string"], [code]);
    if (platform.link) openInPlatform(file);
    else open(file);
    return true;
  }

  // ---- the learning platform, in a page that was packed for one -----------------------------------------------------------

  const kNoPlatform = 2, kPlatformFailed = 3;
  const platform = {kind: byId("pack-bytes")?.dataset.platform, link: null, news: null};
  async function joinPlatform() {
    if (!platform.kind) return;
    const script = document.createElement("script");
    script.textContent = byId("platform-script").textContent + ";globalThis.moltactPlatform = moltactPlatform;";
    document.head.append(script);
    try {
      platform.link = await moltactPlatform.find(platform.kind, byId("pack-bytes").dataset.lesson, window);
      if (!platform.link) platform.news = kNoPlatform;
    } catch (error) {
      console.warn("the learning platform: " + error);
      platform.news = kPlatformFailed;
    }
    // Where the platform failed, the learner is unknown: a storage apart from the own work of the page's address.
    const name = platform.link ? platform.link.storage : platform.news === kPlatformFailed ? "moltact/failed" : null;
    if (name) keeper.last = "moltact/last/" + (keeper.name = name);
  }

  function openInPlatform(file) {
    const reporter = new moltactPlatform.Reporter(platform.link, {
      record: (limit, from) => program.ccall("moltact_platform_record", "string", ["number", "number"], [limit, from]),
      news: (what) => { stir(); program._moltact_platform_news(what); },
    });
    page.leavePlatform = () => reporter.leave(window);
    if (platform.link.return_url) program._moltact_platform_returns();
    program.ccall("moltact_platform_open", null, ["string", "string"], [file, reporter.suspended]);
    stir();
    reporter.begin(window);
    globalThis.moltactReporter = reporter;  // for debugging
  }

  // ---- the live class, in a page that a class serves --------------------------------------------------------------------------

  const classroom = {facts: byId("class-facts"), student: null};
  async function joinClass() {
    if (!classroom.facts) return;
    const script = document.createElement("script");
    script.textContent = byId("classroom-script").textContent + ";globalThis.moltactClassroom = moltactClassroom;";
    document.head.append(script);
    classroom.facts = JSON.parse(classroom.facts.textContent);
    classroom.student = await moltactClassroom.join(classroom.facts, window, navigator.language);
    // Each student of a computer has a storage apart from the own work of the page's address.
    keeper.last = "moltact/last/" + (keeper.name = `moltact/class/${classroom.facts.code}/${classroom.student.number}`);
  }

  async function beginClass() {
    const {student, facts} = classroom, kAttempts = kHome + "/.local/share/moltact/attempts";
    program.ccall("moltact_class_begin", null, ["string"], [student.name]);
    const {FS} = program;
    let held = {};
    const sceneOf = () => JSON.parse(program.ccall("moltact_class_scene", "string", [], []) || "null");
    globalThis.moltactSender = moltactClassroom.begin(student, {  // named for debugging
      files: () => FS.analyzePath(kAttempts).exists ? FS.readdir(kAttempts).filter((name) => name.endsWith(".jsonl")).sort() : [],
      read(name, all) {
        const bytes = FS.readFile(kAttempts + "/" + name);
        return all ? bytes : bytes.subarray(0, keeper.stored(kAttempts + "/" + name));
      },
      leave: () => keeper.leaveToOther(),
      place() {
        const scene = sceneOf();
        return scene && {lesson: scene.lesson, step: scene.step};
      },
      async picture() {
        const at = document.hidden ? null : sceneOf()?.at;
        return at ? moltactClassroom.smallPicture(canvas, at, document) : "";
      },
      held(table) {
        const hold = (lesson, step) => program.ccall("moltact_class_hold", null, ["string", "number"], [lesson, step]);
        for (const lesson of Object.keys(held)) if (!Object.hasOwn(table, lesson)) hold(lesson, -1);
        for (const [lesson, step] of Object.entries(table)) if (held[lesson] !== step) hold(lesson, step);
        if (JSON.stringify(held) !== JSON.stringify(table)) stir();
        held = table;
      },
    }, window);
    if (student.lesson < 0) return;
    const reply = await fetch("lesson/" + student.lesson, {credentials: "omit"});
    if (!reply.ok) throw new Error(reply.status + " " + reply.statusText);
    const file = kPassing + facts.lessons[student.lesson].id.replace(/[^\w-]/g, "_") + ".moltact";
    put(FS, file, new Uint8Array(await reply.arrayBuffer()));
    open(file);
  }

  function hearFiles() {
    const mark = byId("drop");
    addEventListener("dragover", (event) => { event.preventDefault(); mark.hidden = false; });
    addEventListener("dragleave", (event) => { if (!event.relatedTarget) mark.hidden = true; });
    addEventListener("drop", (event) => {
      event.preventDefault();
      mark.hidden = true;
      take(event.dataTransfer.files);
    });
    byId("chooser").addEventListener("change", (event) => take(event.target.files));
  }

  // ---- what the address asks for: nothing leaves the page without a yes --------------------------------------------------

  function agreed(key, ...pieces) {
    const ask = byId("ask"), [yes, no] = ask.querySelectorAll("button");
    ask.querySelector("p").textContent = sentence(key, ...pieces);
    yes.textContent = sentence("fetch");
    no.textContent = sentence("do not fetch");
    return new Promise((done) => {
      yes.onclick = () => { ask.close(); done(true); };
      no.onclick = ask.oncancel = () => { ask.close(); done(false); };
      ask.showModal();
    });
  }

  async function asked() {
    const query = new URLSearchParams(location.search);
    const lesson = query.get("lesson"), molecule = query.get("molecule");
    let url = null, name = "";
    if (molecule && /^[0-9][0-9A-Za-z]{3}$/.test(molecule)) {
      // The program's own molecules need no download.
      if (program.FS.analyzePath("/moltact/molecules/" + molecule.toLowerCase() + ".pdb").exists)
        return open(molecule.toLowerCase());
      name = molecule.toLowerCase() + ".cif";
      url = new URL("https://files.rcsb.org/download/" + molecule.toUpperCase() + ".cif");
    } else if (lesson) {
      try { url = new URL(lesson, location.href); } catch { return; }
      if (!/^https?:$/.test(url.protocol)) return;
      name = (url.pathname.split("/").pop() || "lesson").replace(/[^\w.-]/g, "_");
      if (!/\.(md|moltact)$/i.test(name)) name += ".md";
    }
    if (!url) return;
    if (!await agreed("asked to fetch", name, url.host)) return;
    try {
      const reply = await fetch(url, {credentials: "omit", referrerPolicy: "no-referrer"});
      if (!reply.ok) throw new Error(reply.status + " " + reply.statusText);
      await take([new File([await reply.blob()], name)]);
    } catch (error) {
      program.ccall("moltact_fault", null, ["string", "string"], [url.href, String(error.message || error)]);
      stir();
    }
  }

  // ---- what the program asks of the page ---------------------------------------------------------------------------------

  const kCursors = {"-1": "none", 0: "default", 1: "text", 3: "ns-resize", 4: "ew-resize", 7: "pointer"};
  const page = {
    frames: 0,
    copy(text) { if (navigator.clipboard) navigator.clipboard.writeText(text).catch(() => {}); },
    cursor(shape) { canvas.style.cursor = kCursors[shape] || "default"; },
    fullScreen(on) {
      if (on && !document.fullscreenElement) document.documentElement.requestFullscreen().catch(() => {});
      if (!on && document.fullscreenElement) document.exitFullscreen();
    },
    choose() { byId("chooser").click(); },
    fingers: () => matchMedia("(any-pointer: coarse)").matches,
    vibrate(ms) { if (navigator.vibrate) navigator.vibrate(ms); },
    // Offers a file of the program to the user as a download.
    give(path, name) {
      const link = document.createElement("a");
      link.href = URL.createObjectURL(new Blob([program.FS.readFile(path)], {type: "application/octet-stream"}));
      link.download = name;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 60000);
    },
  };

  // ---- the start -----------------------------------------------------------------------------------------------------------

  if (typeof WebAssembly !== "object" || typeof DecompressionStream !== "function")
    return say("too old");
  const joining = joinClass();
  const hid = moltactDevices(stir);
  const simulations = moltactSimulations(unpacked, stir);
  try {
    const [bytes, files] = await Promise.all([unpacked("program-bytes"), unpacked("file-bytes")]);
    const made = await createMoltact({
      canvas, page, keeper, hid, simulations, wasmBinary: bytes, noInitialRun: true, print: news, printErr: (line) => console.warn(line),
      onAbort: (why) => say("stopped", why),
    });
    putFiles(made.FS, files);
    made.FS.mkdirTree(kHome);
    await Promise.all([joinPlatform(), joining]);
    await joinStudy();
    await Promise.all([keeper.load(made.FS), hid.begin()]);
    document.documentElement.lang = spoken;
    if (made.callMain([]) !== 0)
      return say("no WebGL");
    program = made;
    if (keeper.early) program._moltact_storage_fault(0);
    if (platform.news) program._moltact_platform_news(platform.news);
    globalThis.moltact = program;  // for debugging
    hearPointers();
    hearKeys();
    hearFiles();
    said.hidden = true;
    canvas.focus({preventScroll: true});
    requestAnimationFrame(frame);
    if (classroom.student) await beginClass();
    else if (!await takeAlong()) asked();
  } catch (error) {
    console.error(error);
    say("not started", error);
  }
})();
