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
      if (body.from > have.length) status = 409;
      else if (have.length + body.lines.length > it.limit) status = 507;
      else have.push(...body.lines.slice(have.length - body.from));
      json.have = have.length;
    }
    if (it.lose_answer) { it.lose_answer = false; throw new Error("the answer is lost"); }
    return {status, json};
  };
  return it;
}
function student(at, files) {
  const said = [], held = [];
  const sender = new page.Sender("token", {files: () => Object.keys(files), read: (name) => bytes(files[name]),
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

  // A large attempt goes in pieces below the server's limit.
  const large = server(), much = student(large, {"a.jsonl": Array.from({length: 900}, (_, k) => JSON.stringify({k, x: "y".repeat(1000)}) + "\n").join("")});
  let most = 0;
  const ask = large.ask;
  large.ask = much.sender.ask = (where, body) => { most = Math.max(most, JSON.stringify(body).length); return ask(where, body); };
  await much.sender.step(1);
  assert.strictEqual(large.kept.get("a").length, 900);
  assert.ok(most < 500000 && most > 100000, String(most));
})().catch((error) => { console.error(error); process.exit(1); });
