// node tests/web/sentences_test.js: the page's own sentences (app/web/sentences.js), and a third language with some of them.
"use strict";
const assert = require("node:assert"), fs = require("node:fs"), path = require("node:path"), vm = require("node:vm");
const file = path.join(__dirname, "../../app/web/sentences.js");
const {table, language, sentence} = vm.runInNewContext(fs.readFileSync(file, "utf8") +
  ";({table: kPageSentences, language: moltactLanguage, sentence: moltactSentence})");

const holes = (text) => (text.match(/\{\d\}/g) || []).sort().join();
for (const [code, texts] of Object.entries(table))
  for (const [key, text] of Object.entries(texts)) {
    assert.ok(Object.hasOwn(table.en, key), `${code}: "${key}" is no sentence of the page`);
    assert.strictEqual(holes(text), holes(table.en[key]), `${code}: "${key}" has other placeholders than the English`);
  }

// Every sentence that the page asks for exists.
const page = fs.readFileSync(path.join(__dirname, "../../app/web/page.js"), "utf8");
const asked = [...page.matchAll(/\b(?:say|sentence|agreed)\("([^"]+)"/g)].map((match) => match[1]);
assert.deepStrictEqual([...new Set(asked)].sort(), Object.keys(table.en).sort());

table.fr = {"fetch": "Charger"};
assert.strictEqual(language("fr-CA"), "fr");
assert.strictEqual(sentence("fr", "fetch"), "Charger");
assert.strictEqual(sentence("fr", "stopped", "why"), "Moltact has stopped: why");
assert.strictEqual(sentence("de", "asked to fetch", "a", "b.org"),
                   "Diese Seite soll a von b.org laden. Jener Server erfährt dann, dass du das tust.");
for (const other of ["pt-BR", "", undefined, "constructor", "__proto__"]) assert.strictEqual(language(other), "en");
