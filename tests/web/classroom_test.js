// node tests/web/classroom_test.js: the page's side of a live class (app/web/classroom.js) against a server written here
// that loses connections, answers and itself.
"use strict";
const assert = require("node:assert"), fs = require("node:fs"), path = require("node:path"), vm = require("node:vm");
const source = fs.readFileSync(path.join(__dirname, "../../app/web/classroom.js"), "utf8");
const page = vm.runInNewContext(source + ";moltactClassroom",
                                {localStorage: {}, console: {warn() {}}, TextEncoder, TextDecoder, AbortSignal, setTimeout, clearTimeout});
const bytes = (text) => new TextEncoder().encode(text);
const same = (a, b) => assert.deepStrictEqual(JSON.parse(JSON.stringify(a)), b);

// Every sentence exists in both languages with the same placeholders, and every one that the script asks for exists.
const holes = (text) => (text.match(/\{\d\}/g) || []).sort().join();
const {en, de} = page.kSentences;
assert.deepStrictEqual(Object.keys(de), Object.keys(en));
for (const key of Object.keys(en)) assert.strictEqual(holes(de[key]), holes(en[key]), key);
const asked = [...source.matchAll(/\b(?:say|said|button|askName)\("([^"]+)"/g)].map((match) => match[1]);
for (const key of asked) assert.ok(Object.hasOwn(en, key), key);
assert.strictEqual(page.sentencesOf("de-AT")("go on as", "Otter"), "Als Otter weitermachen");
for (const other of ["fr", "", undefined, "constructor"]) assert.strictEqual(page.sentencesOf(other)("join"), "Join");

// Lines are whole, within the limit, and at least one.
const three = bytes('{"a":1}\n{"b":"ü"}\n{"c":3}\n{"half":');
same(page.linesFrom(three, 0), [['{"a":1}', '{"b":"ü"}', '{"c":3}'], 27]);
same(page.linesFrom(three, 0, 10), [['{"a":1}'], 8]);
same(page.linesFrom(three, 0, 1), [['{"a":1}'], 8]);
same(page.linesFrom(three, 0, 1000, 2), [['{"a":1}', '{"b":"ü"}'], 19]);
assert.strictEqual(page.markOf(""), 0x811c9dc5);
assert.strictEqual(page.markOf("a"), 0xe40c292c);       // FNV-1a's published values of "a" and "foobar"
assert.strictEqual(page.markOf("foobar"), 0xbf9cf968);
assert.strictEqual(page.keyOf("a.jsonl", 1), "a-2");
assert.ok(page.keyOf("x".repeat(200), 8).length <= 100);
same(page.linesFrom(three, 27), [[], 27]);
assert.strictEqual(page.behind(three, 2), 19);
assert.strictEqual(page.behind(three, 4), -1);
assert.strictEqual(page.keyOf("first touch-2026.1.jsonl"), "first-touch-2026-1");

// A server that keeps lines as ClassRoom::take does.
function server() {
  const kept = new Map();
  const it = {kept, down: false, lose_answer: false, ended: false, held: {}, unknown: false, asks: 0, limit: Infinity};
  it.ask = async (where, body) => {
    ++it.asks;
    if (it.down) throw new Error("no connection");
    if (it.unknown) return {status: 403, json: {unknown: true}};
    const json = {ended: it.ended, held: it.held};
    let status = 200;
    if (body.attempt) {
      const have = kept.get(body.attempt) || [];
      kept.set(body.attempt, have);
      const first = have.length - body.from;
      if (first < 0 || (first > 0 && first < body.lines.length)) status = 409;
      else if (!first && have.length + body.lines.length > it.limit) status = 507;
      else have.push(...body.lines.slice(have.length - body.from));
      json.have = have.length;
      if (have.length) json.last = page.markOf(have.at(-1));
    }
    if (it.lose_answer) { it.lose_answer = false; throw new Error("the answer is lost"); }
    return {status, json};
  };
  return it;
}
function student(at, files, stored = {}) {
  const said = [], held = [];
  const read = (name, all) => bytes(files[name]).subarray(0, all ? Infinity : stored[name] ?? Infinity);
  const sender = new page.Sender("token", {files: () => Object.keys(files), read,
                                           said: (key) => said.push(key), held: (table) => held.push(table)}, at.ask);
  return {sender, said, held, files};
}
const line = (k) => JSON.stringify({kind: "still", t: k}) + "\n";

(async () => {
  const at = server(), one = student(at, {"a.jsonl": line(0) + line(1) + '{"kind":"st'});
  let now_ms = 1000;
  const step = (more_ms = 5000) => one.sender.step(now_ms += more_ms);
  await step();
  assert.strictEqual(at.kept.get("a").length, 2);
  one.files["a.jsonl"] = line(0) + line(1) + line(2);
  await step();
  same(at.kept.get("a"), [line(0), line(1), line(2)].map((l) => l.trim()));
  assert.strictEqual(one.said.length, 0);
  at.held = {bumps: 1};
  await step();
  same(one.held.at(-1), {bumps: 1});

  // The server is lost: said once; the attempt goes on; all arrives, once, when it is back.
  at.down = true;
  for (let k = 3; k < 300; ++k) { one.files["a.jsonl"] += line(k); await step(1000); }
  same(one.said, ["lost"]);
  same(one.held.at(-1), {});
  const asks = at.asks;
  await one.sender.step(now_ms + 10);  // not at once again
  assert.strictEqual(at.asks, asks);
  at.down = false;
  await step();
  same(one.said, ["lost", "back"]);
  same(one.held.at(-1), {bumps: 1});
  assert.strictEqual(at.kept.get("a").length, 300);

  // An answer is lost after the server had the lines: they come again and count once.
  one.files["a.jsonl"] += line(300);
  at.lose_answer = true;
  await step();
  await step();
  assert.strictEqual(at.kept.get("a").length, 301);
  assert.strictEqual(at.kept.get("a")[300], line(300).trim());

  // A server that has fewer lines than it acknowledged (another folder) gets them from where it is.
  at.kept.get("a").length = 100;
  one.files["a.jsonl"] += line(301);
  await step();
  assert.strictEqual(at.kept.get("a").length, 302);

  // A page that is loaded again asks what is there and sends the rest.
  const again = student(at, {...one.files, "b.jsonl": line(7)});
  again.files["a.jsonl"] += line(302);
  await again.sender.step(1);
  assert.strictEqual(at.kept.get("a").length, 303);
  same(at.kept.get("b"), [line(7).trim()]);

  // What the class holds, and its end: only when all has arrived.
  at.held = {bumps: 2};
  await again.sender.step(2);
  same(again.held.at(-1), {bumps: 2});
  at.ended = true;
  again.files["b.jsonl"] += line(8);
  await again.sender.step(3);
  same(again.said, ["ended"]);
  assert.strictEqual(at.kept.get("b").length, 2);
  const over = at.asks;
  await again.sender.step(1e6);
  assert.strictEqual(at.asks, over);

  // A closing page sends what fits.
  const left = server(), closing = student(left, {"a.jsonl": line(0)});
  closing.sender.last();  // nothing is known of the file yet
  assert.strictEqual(left.asks, 0);
  closing.sender.places.set("a.jsonl", {have: 0, at: 0});
  closing.sender.last();
  same(left.kept.get("a"), [line(0).trim()]);

  // A class that does not know the student, and one that takes no more.
  const stranger = student(Object.assign(server(), {unknown: true}), {"a.jsonl": line(0)});
  await stranger.sender.step(1);
  same(stranger.said, ["unknown"]);
  const full = student(Object.assign(server(), {limit: 1}), {"a.jsonl": line(0) + line(1), "b.jsonl": line(5)});
  await full.sender.step(1);
  same(full.said, ["refused"]);
  assert.strictEqual(full.sender.next(), null);

  // A page that was killed after the server had five lines of which the browser had stored three, and that has written two
  // others since: all five of the page arrive, the first three twice.
  const killed = server(), back = student(killed, {"a.jsonl": line(0) + line(1) + line(2) + line(30) + line(40)});
  killed.kept.set("a", [0, 1, 2, 3, 4].map((k) => line(k).trim()));
  await back.sender.step(1);
  same(killed.kept.get("a"), [0, 1, 2, 3, 4].map((k) => line(k).trim()));
  same(killed.kept.get("a-2"), [0, 1, 2, 30, 40].map((k) => line(k).trim()));
  back.files["a.jsonl"] += line(50);
  await back.sender.step(2e5);
  same(killed.kept.get("a-2").at(-1), line(50).trim());
  assert.strictEqual(killed.kept.get("a").length, 5);
  // The same page before it has written more, and again after it was loaded a second time.
  const sooner = student(killed, {"b.jsonl": line(0)});
  killed.kept.set("b", [line(0).trim(), line(1).trim()]);
  await sooner.sender.step(1);
  same(killed.kept.get("b-2"), [line(0).trim()]);
  const third = student(killed, {"b.jsonl": line(0) + line(9)});
  await third.sender.step(1);
  same(killed.kept.get("b"), [line(0).trim(), line(1).trim()]);
  same(killed.kept.get("b-2"), [line(0).trim(), line(9).trim()]);
  // Two pages of a browser without BroadcastChannel write the same attempt: no line of either is missing.
  const both = server(), left_tab = student(both, {"a.jsonl": line(0) + line(1)}), right_tab = student(both, {"a.jsonl": line(0) + line(1)});
  await left_tab.sender.step(1);
  await right_tab.sender.step(1);
  left_tab.files["a.jsonl"] += line(2);
  right_tab.files["a.jsonl"] += line(3) + line(4);
  await left_tab.sender.step(1e5);
  await right_tab.sender.step(1e5);
  left_tab.files["a.jsonl"] += line(5);
  await left_tab.sender.step(2e5);
  const all_lines = [...both.kept.values()].flat();
  for (const k of [2, 3, 4, 5]) assert.ok(all_lines.includes(line(k).trim()), String(k));
  // Only what the browser has stored is sent, but by a page that closes.
  const careful = server(), stored = {"a.jsonl": line(0).length};
  const slow = student(careful, {"a.jsonl": line(0) + line(1)}, stored);
  await slow.sender.step(1);
  same(careful.kept.get("a"), [line(0).trim()]);
  slow.sender.last();
  assert.strictEqual(careful.kept.get("a").length, 2);
  const loaded = student(careful, {"a.jsonl": line(0) + line(1)}, stored);  // the last line came back, and is not yet stored
  await loaded.sender.step(1);
  same([...careful.kept.keys()], ["a"]);

  // Answers without a number of lines: a file that cannot be read is left out, a server that asks to wait is not lost, and
  // one that has another class is said to be gone, until the class is back.
  const answers = (status, json = {}) => Object.assign(server(), {ask: async () => ({status, json})});
  for (const status of [400, 413, 415]) {
    const odd = student(answers(status), {"a.jsonl": line(0)});
    await odd.sender.step(1);
    same(odd.said, ["refused"]);
    assert.strictEqual(odd.sender.next(), null);
  }
  for (const status of [429, 503]) {
    const busy = student(answers(status), {"a.jsonl": line(0)});
    await busy.sender.step(1);
    same(busy.said, []);
    assert.ok(busy.sender.wait_until_ms > 1000);
  }
  const other = student(answers(404), {"a.jsonl": line(0)});
  await other.sender.step(1);
  same(other.said, ["gone"]);
  await other.sender.step(1e5);
  same(other.said, ["gone"]);
  other.sender.ask = server().ask;
  await other.sender.step(2e5);
  same(other.said, ["gone", "back"]);
  // The end of a class is not "all has arrived" if something was refused.
  const some = student(Object.assign(server(), {limit: 1, ended: true}), {"a.jsonl": line(0) + line(1)});
  await some.sender.step(1);
  same(some.said, ["refused", "ended, some kept"]);
  // Nor before the browser has stored its last lines, which then arrive.
  const late = server(), late_stored = {"a.jsonl": line(0).length}, later = student(late, {"a.jsonl": line(0) + line(1)}, late_stored);
  late.ended = true;
  await later.sender.step(1);
  same(later.said, []);
  late_stored["a.jsonl"] = Infinity;
  await later.sender.step(1e5);
  same(later.said, ["ended"]);
  assert.strictEqual(late.kept.get("a").length, 2);
  // A body that is too large by a line is sent line by line.
  const small = server(), few = student(small, {"a.jsonl": line(0) + line(1) + line(2)}), take = small.ask;
  few.sender.ask = async (where, body) => body.lines?.length > 1 ? {status: 413, json: {}} : take(where, body);
  await few.sender.step(1);
  assert.strictEqual(small.kept.get("a").length, 3);

  // One tab per student: the older one stores, leaves and is answered for; without another tab nobody waits long.
  const channels = new Set();
  class Channel {
    constructor(name) { this.name = name; channels.add(this); }
    postMessage(data) { for (const one of channels) if (one !== this && one.name === this.name) queueMicrotask(() => one.onmessage?.({data})); }
  }
  const events = [];
  const older = page.turnOf("class/7", Channel, 20, 2000);
  await older.ready;
  older.leave = async () => { await new Promise((done) => setTimeout(done, 60)); events.push("stored"); };
  const stranger_tab = page.turnOf("class/8", Channel, 20, 2000);
  await stranger_tab.ready;
  assert.ok(!older.taken);
  const newer = page.turnOf("class/7", Channel, 20, 2000);
  await newer.ready;
  events.push("ready");
  same(events, ["stored", "ready"]);
  assert.ok(older.taken && !newer.taken);

  // All students of a browser are kept, the latest first; what an earlier version kept is one of them.
  const anna = {name: "Anna", token: "t1", number: 1}, ben = {name: "Ben", token: "t2", number: 2};
  same(page.studentsIn(null), []);
  same(page.studentsIn("{broken"), []);
  same(page.studentsIn(JSON.stringify(anna)), [anna]);
  same(page.withStudent(page.studentsIn(JSON.stringify([anna])), ben), [ben, anna]);
  same(page.withStudent([ben, anna], anna), [anna, ben]);

  // The scene, for the class to see. A class's computer that asks and takes pictures, and a page at a step.
  const sharing = () => {
    const it = {box: "", place: {lesson: "bumps", step: 1}, picture: "abc", sent: [], status: 200, answer: null, stop: null};
    it.share = new page.SceneShare("token", {
      ask(answer) { it.box = "asked"; it.answer = answer; }, showing(stop) { it.box = "showing"; it.stop = stop; }, quiet() { it.box = ""; },
      place: () => it.place, picture: async () => it.picture,
    }, async (where, body) => {
      assert.strictEqual(where, "scene");
      it.sent.push(body);
      if (it.status === 0) throw new Error("no connection");
      return {status: it.status, json: {}};
    });
    return it;
  };
  const here = {lesson: "bumps", step: 1};
  const seen = sharing();
  seen.share.heard(null);
  await seen.share.step();
  same(seen.sent, []);  // nothing without a question
  seen.share.heard({ask: 4});
  seen.share.heard({ask: 4});
  assert.strictEqual(seen.box, "asked");
  await seen.share.step();
  same(seen.sent, []);  // nothing before the answer
  await seen.answer(true, true);
  same(seen.sent.pop(), {token: "token", scene: 4, say: "yes", named: true, ...here});
  assert.strictEqual(seen.box, "showing");
  seen.share.heard({ask: 4});  // an answer of the class's computer from before
  assert.strictEqual(seen.box, "showing");
  await seen.share.step();
  same(seen.sent.pop(), {token: "token", scene: 4, ...here, picture: "abc"});
  seen.picture = "";  // in the dark
  await seen.share.step();
  same(seen.sent.pop(), {token: "token", scene: 4, ...here, picture: ""});
  seen.share.heard({show: 4});
  seen.status = 429;
  await seen.share.step();
  seen.status = 0;  // a lost connection does not end it
  await seen.share.step();
  assert.strictEqual(seen.box, "showing");
  seen.status = 200;
  // The student stops: nothing more goes, and not the picture that was under way.
  seen.sent.length = 0;
  seen.stop();
  await seen.share.step();
  same(seen.sent, [{token: "token", scene: 4, say: "stop"}]);
  assert.strictEqual(seen.box, "");
  const slowly = sharing();
  slowly.share.heard({ask: 1});
  await slowly.answer(true, false);
  assert.strictEqual(slowly.sent.pop().named, false);
  let made = null;
  slowly.share.page.picture = () => new Promise((done) => { made = done; });
  const under_way = slowly.share.step();
  await Promise.all([slowly.stop(), new Promise((done) => setTimeout(done, 1))]);
  made("abc");
  await under_way;
  assert.ok(slowly.sent.every((body) => body.picture === undefined));
  // No; the step is left; the class's computer or the teacher ends it; a question that lapses.
  const no = sharing();
  no.share.heard({ask: 1});
  await no.answer(false);
  same(no.sent, [{token: "token", scene: 1, say: "no", named: false, ...here}]);
  no.share.heard({ask: 1});
  assert.strictEqual(no.box, "");
  no.share.heard({ask: 2});
  assert.strictEqual(no.box, "asked");
  no.share.heard(null);
  assert.strictEqual(no.box, "");
  for (const end of [(it) => { it.place = {lesson: "bumps", step: 2}; }, (it) => { it.place = null; }, (it) => { it.status = 410; },
                     (it) => it.share.heard(null)]) {
    const ends = sharing();
    ends.share.heard({ask: 1});
    await ends.answer(true, false);
    end(ends);
    await ends.share.step();
    ends.sent.length = 0;
    await ends.share.step();
    same(ends.sent, []);
    assert.strictEqual(ends.box, "");
  }
  // A page that is loaded again, or has not heard that its yes has arrived, shows nothing.
  for (const heard of [false, true]) {
    const again_loaded = sharing();
    if (heard) {
      again_loaded.share.heard({ask: 1});
      again_loaded.status = 0;
      await again_loaded.answer(true, true);
      again_loaded.status = 200;
    }
    again_loaded.share.heard({show: 1});
    same(again_loaded.sent.pop(), {token: "token", scene: 1, say: "stop"});
    assert.strictEqual(again_loaded.box, "");
  }
  // A picture becomes smaller, in size and then in quality, until it fits.
  const canvases = [];
  const drawn = (length_at) => ({createElement: () => {
    const it = {getContext: () => ({drawImage: (...at) => { it.at = at; }}),
                toDataURL: (kind, quality) => "data:" + kind + ";base64," + "A".repeat(length_at(quality))};
    canvases.push(it);
    return it;
  }});
  const picture_of = (length_at) => page.smallPicture("canvas", [10, 20, 1280, 600], drawn(length_at));
  assert.strictEqual((await picture_of(() => 1000)).length, 1000);
  same([canvases[0].width, canvases[0].height, ...canvases[0].at.slice(1)], [640, 300, 10, 20, 1280, 600, 0, 0, 640, 300]);
  assert.strictEqual((await picture_of((quality) => 100000 * quality)).length, 50000);
  assert.strictEqual(await picture_of(() => 70000), "");

  // A large attempt goes in pieces below the server's limit.
  const large = server(), much = student(large, {"a.jsonl": Array.from({length: 900}, (_, k) => JSON.stringify({k, x: "y".repeat(1000)}) + "\n").join("")});
  let most = 0;
  const ask = large.ask;
  large.ask = much.sender.ask = (where, body) => { most = Math.max(most, JSON.stringify(body).length); return ask(where, body); };
  await much.sender.step(1);
  assert.strictEqual(large.kept.get("a").length, 900);
  assert.ok(most < 500000 && most > 100000, String(most));
})().catch((error) => { console.error(error); process.exit(1); });
