// A valid lesson with 165 mistakes of authors, one at a time, by kind: each is reported at its line, with a message
// that names the fault or the remedy.
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "engine/lesson/check.h"
#include "engine/lesson/checks.h"
#include "engine/lesson/tasks/registry.h"
#include "tests/lesson/small_molecules.h"

using namespace moltact;

namespace {

const std::string kGood = R"(---
title: A lesson
minutes: 2
level: beginner
language: en
goals:
- Feel a crease
molecules: mix
author: A. Author
licence: CC-BY-4.0
---

## First step

Text with a [link](#second-step).

```scene
molecule: mix
probe: 1.4 Å
view: side
show: atoms, probe
highlight: element O
```

```touch
reach: element O
called: the oxygen
say: Touch the oxygen.
praise: Good.
```

> [!TIP]
> A hint.

### Question: How many?

- [x] Four → Yes.
- [ ] Five → No.

> [!NOTE]
> Teacher: for you.

## Second step

More text.

```touch
hold: crease
for: 2 s
force: 0.2 N to 0.6 N
say: Hold it.
```

### Question: How long?

```answer
number: 1.5 Å
tolerance: 0.1 Å
right: Yes.
wrong: No.
```
)";

struct Mistake {
  const char* kind;
  std::string good, bad;  // the first text of the lesson is replaced by the second
  std::string words;      // words in the message at that line
  int below = 0;          // distance in lines of the reported line from the beginning of the texts
};

const std::vector<Mistake>& mistakes() {
  static const std::vector<Mistake> all{
      // Front matter.
      {"front matter", "---\ntitle", "title", "front matter"},
      {"front matter", "title: A lesson\n", "", "title", -1},
      {"front matter", "title: A lesson", "titel: A lesson", "title"},
      {"front matter", "title: A lesson", "title A lesson", "key: value"},
      {"front matter", "title: A lesson", "title:", "title"},
      {"front matter", "title: A lesson", "title: A lesson\ntitle: Another", "twice", 1},
      {"front matter", "minutes: 2", "minutes: ten", "ten"},
      {"front matter", "minutes: 2", "minutes: 10 min", "min"},
      {"front matter", "minutes: 2", "minutes: 0", "smallest"},
      {"front matter", "minutes: 2", "minutes: 10.5", "whole"},
      {"front matter", "minutes: 2", "minutes: 5000", "largest"},
      {"front matter", "level: beginner", "level: beginer", "beginner"},
      {"front matter", "level: beginner", "level: easy", "beginner"},
      {"front matter", "language: en", "language: english", "letters"},
      {"front matter", "goals:\n- Feel a crease\n", "", "goals", -5},
      {"front matter", "molecules: mix", "molecules: mix, mix", "twice"},
      {"front matter", "molecules: mix", "molecules: mxi", "mxi"},
      {"front matter", "molecules: mix", "molecules: mix, water", "water"},
      {"front matter", "author: A. Author\n", "", "author", -8},
      {"front matter", "licence: CC-BY-4.0", "license: CC-BY-4.0", "licence"},
      {"front matter", "CC-BY-4.0\n---", "CC-BY-4.0", "end", -9},
      {"front matter", "language: en", "language: en\nlocked: forse", "force", 1},
      {"front matter", "language: en", "language: en\nask: number", "name", 1},
      {"front matter", "language: en", "language: en\ncard: 3", "2 steps", 1},
      {"front matter", "language: en", "language: en\ncard: one", "whole", 1},
      {"front matter", "- Feel a crease", "Feel a crease", "key: value"},
      // Steps and headings.
      {"steps", "## First step", "# First step", "before the first step", 4},
      {"steps", "## First step", "##First step", "blank"},
      {"steps", "## Second step", "##Second step", "blank"},
      {"steps", "## Second step", "## First step", "two steps are called"},
      {"steps", "## Second step", "##", "a step without a name"},
      {"steps", "## Second step\n\nMore text.\n", "### Second step\n\n```scene\nprobe: 2 Å\n```\n", "'## Second step'",
       2},
      {"steps", "> [!NOTE]\n> Teacher: for you.\n",
       "### Next part\n\n```touch\nreach: element N\nsay: Touch it.\n```\n", "'## Next part'"},
      {"steps", "More text.", "More text.\n\n## Aside: Nobody comes here\n\nText.", "no link", 2},
      {"steps", "wrong: No.\n```\n", "wrong: No.\n```\n\n## Last\n", "nothing", 3},
      // Links and pictures.
      {"links", "#second-step", "#secnd-step", "second-step"},
      {"links", "#second-step", "other.md", "no file"},
      {"links", "#second-step", "/home/me/other.md", "this computer"},
      {"links", "#second-step", "ftp://x/y", "https"},
      {"links", "Text with", "![a ring](ring.png) Text with", "no file"},
      {"links", "Text with", "![](ring.png) Text with", "description"},
      {"links", "Text with", "![a ring]() Text with", "without a file"},
      {"links", "Text with", "![a ring](../ring.png) Text with", "folder"},
      {"links", "→ No.", "→ See [why](#nowhere).", "nowhere"},
      {"links", "say: Touch the oxygen.", "say: Touch it, see [why](#second-step).", "plain text"},
      {"links", "say: Touch the oxygen.", "say: Touch **it**.", "plain text"},
      {"links", "praise: Good.", "praise: See `this`.", "plain text"},
      // Fences.
      {"fences", "highlight: element O\n```", "highlight: element O", "no end", -5},
      {"fences", "```scene", "```sceen", "scene"},
      {"fences", "```touch\nhold", "```tuch\nhold", "touch"},
      {"fences", "```answer", "```anser", "answer"},
      {"fences", "```touch\nreach", "- item\n  ```touch\nreach", "", 1},
      {"fences", "say: Hold it.\n```", "say: Hold it.", "no end", -4},
      // Scenes.
      {"scenes", "molecule: mix\nprobe", "molecule: mx\nprobe", "mx"},
      {"scenes", "molecule: mix\nprobe", "molecule: mix.pdb\nprobe", "write 'mix'"},
      {"scenes", "molecule: mix\nprobe", "molecul: mix\nprobe", "molecule"},
      {"scenes", "molecule: mix\nprobe", "probe", "molecule", -1},
      {"scenes", "probe: 1.4 Å", "probe: 1.4", "unit"},
      {"scenes", "probe: 1.4 Å", "probe: 1,4 Å", "point"},
      {"scenes", "probe: 1.4 Å", "probe: 1.4 N", "length"},
      {"scenes", "probe: 1.4 Å", "probe: 140 Å", "largest"},
      {"scenes", "probe: 1.4 Å", "probe: -1 Å", "smallest"},
      {"scenes", "probe: 1.4 Å", "probe: water", "not a number"},
      {"scenes", "probe: 1.4 Å", "probe: 1.4 Å\nprobe: 2 Å", "twice", 1},
      {"scenes", "probe: 1.4 Å", "stiffness: 0.5", "unit"},
      {"scenes", "probe: 1.4 Å", "method: exat", "exact"},
      {"scenes", "probe: 1.4 Å", "force: yes", "on"},
      {"scenes", "probe: 1.4 Å", "style: catoon", "cartoon"},
      {"scenes", "probe: 1.4 Å", "style: surface 200%", ""},
      {"scenes", "probe: 1.4 Å", "colour: elements", "element"},
      {"scenes", "probe: 1.4 Å", "color: element", "colour"},
      {"scenes", "probe: 1.4 Å", "panels: none, touch", "alone"},
      {"scenes", "probe: 1.4 Å", "magnify: chain Q", "Q"},
      {"scenes", "probe: 1.4 Å", "hide: water and", ""},
      {"scenes", "view: side", "view: sied", "side"},
      {"scenes", "view: side", "view: residue 52", "facing residue 52"},
      {"scenes", "view: side", "view: resi 52+53", "facing residue 52 53"},
      {"scenes", "view: side", "view: residue 52+53", "facing residue 52 53"},
      {"scenes", "view: side", "view: facing residue 99", "99"},
      {"scenes", "show: atoms, probe", "show: atoms,, probe", "comma"},
      {"scenes", "show: atoms, probe", "show: atom, probe", "atoms"},
      {"scenes", "highlight: element O", "highlight: element Xx", "Xx"},
      {"scenes", "highlight: element O", "highlight: elemnt O", "element"},
      {"scenes", "highlight: element O", "highlight: chain C", "C"},
      {"scenes", "highlight: element O", "highlight: (element O", ""},
      {"scenes", "highlight: element O", "highlight: resi 52+53", ""},
      {"scenes", "highlight: element O", "highlight: residue 52 400", "400"},
      {"scenes", "highlight: element O", "highlight: within 5 of ligand", ""},
      {"scenes", "highlight: element O", "highlight:", "no value"},
      // Touch tasks.
      {"tasks", "reach: element O", "rech: element O", "reach"},
      {"tasks", "reach: element O\n", "", "names no task", -1},
      {"tasks", "reach: element O", "reach: element O\nhold: crease", "one task", 1},
      {"tasks", "reach: element O", "reach: element O\nuntil: 1 N", "press", 1},
      {"tasks", "reach: element O", "reach: element Q", "Q"},
      {"tasks", "reach: element O", "reach: residue 999", "999"},
      {"tasks", "reach: element O", "reach: oxygen", ""},
      {"tasks", "reach: element O", "reach: all or", ""},
      {"tasks", "say: Touch the oxygen.\n", "", "say", -3},
      {"tasks", "say: Touch the oxygen.", "say: Touch the oxygen.\nsay: Again.", "twice", 1},
      {"tasks", "praise: Good.", "prase: Good.", "praise"},
      {"tasks", "reach: element O", "reach: element O\nnear: 4", "unit", 1},
      {"tasks", "reach: element O", "reach: element O\nwrong: water", "->", 1},
      {"tasks", "reach: element O", "reach: element O\nwrong: watr -> That is water.", "water", 1},
      {"tasks", "reach: element O", "reach: element O\nwrong: water ->", "sentence", 1},
      {"tasks", "reach: element O", "reach: element O\nside: chain Q", "Q", 1},
      {"tasks", "hold: crease", "hold: creese", "crease"},
      {"tasks", "hold: crease", "hold: pits", "pit"},
      {"tasks", "for: 2 s", "for: 2", "unit"},
      {"tasks", "for: 2 s", "for: 2 sec", "s"},
      {"tasks", "for: 2 s", "for: 2 N", "time"},
      {"tasks", "for: 2 s", "for: 0.01 s", "smallest"},
      {"tasks", "for: 2 s", "for 2 s", "key: value"},
      {"tasks", "force: 0.2 N to 0.6 N", "force: 0.2 N", "range"},
      {"tasks", "force: 0.2 N to 0.6 N", "force: 0.6 N to 0.2 N", "smaller"},
      {"tasks", "force: 0.2 N to 0.6 N", "force: 0.2 N - 0.6 N", "range"},
      {"tasks", "hold: crease\n", "cross: element O\nto: element O\n", "in common", 1},
      {"tasks", "hold: crease\nfor: 2 s\nforce: 0.2 N to 0.6 N", "cross: element O", "to", -1},
      {"tasks", "hold: crease\nfor: 2 s\nforce: 0.2 N to 0.6 N", "same: anywhere", "differs"},
      {"tasks", "hold: crease\nfor: 2 s\nforce: 0.2 N to 0.6 N", "same: anywhere\nprobe: 1.4 Å", "same", 1},
      {"tasks", "hold: crease\nfor: 2 s\nforce: 0.2 N to 0.6 N", "same: atom 0\nplace: atom 0", "same atoms", 1},
      {"tasks", "hold: crease\nfor: 2 s\nforce: 0.2 N to 0.6 N", "same: anywhere\nprobe: 2 Å\ntrials: 4\nright: 5",
       "trials", 3},
      {"tasks", "hold: crease\nfor: 2 s\nforce: 0.2 N to 0.6 N", "compare: places\nof: atom 0", "two places", 1},
      {"tasks", "hold: crease\nfor: 2 s\nforce: 0.2 N to 0.6 N", "compare: exact, mesh", ""},
      {"tasks", "hold: crease\nfor: 2 s\nforce: 0.2 N to 0.6 N", "trace: crease", "of"},
      {"tasks", "hold: crease\nfor: 2 s\nforce: 0.2 N to 0.6 N", "trace: atom 0 then", "then"},
      {"tasks", "hold: crease\nfor: 2 s\nforce: 0.2 N to 0.6 N", "trace: atom 0 then atom 1\nattempts: 2", "lifts", 1},
      {"tasks", "hold: crease\nfor: 2 s\nforce: 0.2 N to 0.6 N", "press: crease", "until", -1},
      {"tasks", "hold: crease\nfor: 2 s\nforce: 0.2 N to 0.6 N", "feel: crease, spere", "sphere"},
      {"tasks", "hold: crease\nfor: 2 s\nforce: 0.2 N to 0.6 N", "find: atom 0\nguesses: 0", "smallest", 1},
      {"tasks", "hold: crease\nfor: 2 s\nforce: 0.2 N to 0.6 N", "fit: atom 4\nleast: 3 Å\nmost: 2 Å", "least", 2},
      {"tasks", "hold: crease\nfor: 2 s\nforce: 0.2 N to 0.6 N", "fit: atom 4", "every probe"},
      {"tasks", "hold: crease\nfor: 2 s\nforce: 0.2 N to 0.6 N", "fit: atom 4\nway: through", "ring"},
      {"tasks", "hold: crease\nfor: 2 s\nforce: 0.2 N to 0.6 N", "measure: atom 0", "to", -1},
      {"tasks", "hold: crease\nfor: 2 s\nforce: 0.2 N to 0.6 N", "order: atom 0\nfirst: the small one", "two places"},
      {"tasks", "hold: crease\nfor: 2 s\nforce: 0.2 N to 0.6 N", "order: atom 0 then atom 0\nfirst: it", "same atoms"},
      // Questions and answers.
      {"questions", "### Question: How many?", "### Question:", "without words"},
      {"questions", "- [x] Four", "- [ ] Four", "no right answer", -2},
      {"questions", "- [ ] Five → No.\n", "", "only one choice", -3},
      {"questions", "- [ ] Five → No.", "- [x] Five → No.", "every choice", -3},
      {"questions", "- [ ] Five → No.", "- Five → No.", "[ ]"},
      {"questions", "- [ ] Five → No.", "- [ ] Four → No.", "twice"},
      {"questions", "- [ ] Five → No.", "- [ ] Five", "feedback"},
      {"questions", "- [ ] Five → No.", "- [ ] → No.", "empty"},
      {"questions", "- [x] Four → Yes.\n- [ ] Five → No.\n", "", "nothing to answer", -2},
      {"questions", "### Question: How many?", "### Frage: How many?", "task list", 2},
      {"questions", "- [x] Four", "-[x] Four", "blank"},
      {"questions", "- [ ] Five", "- []Five", "blank"},
      {"questions", "### Question: How long?\n", "### Question: How long?\n\n- [x] One → A.\n- [ ] Two → B.\n", "both"},
      {"questions", "number: 1.5 Å\n", "", "number", -1},
      {"questions", "number: 1.5 Å", "number: 1.5 Å\ntext: yes", "one of", -1},
      {"questions", "tolerance: 0.1 Å", "tolerance: 0.1", "units"},
      {"questions", "tolerance: 0.1 Å\n", "", "tolerance", -1},
      {"questions", "tolerance: 0.1 Å", "tolerance: -0.1 Å", "minus"},
      {"questions", "number: 1.5 Å\ntolerance: 0.1 Å", "free: yes\ntolerance: 1", "number", 1},
      {"questions", "right: Yes.", "model: It is so.", "free"},
      {"questions", "right: Yes.", "rigt: Yes.", "right"},
      // Notes and text.
      {"notes", "> Teacher: for you.", "> teacher: for you.", "Teacher:", -1},
      {"notes", "> Teacher: for you.", "> For the teacher: for you.", "Teacher:", -1},
      {"notes", "> Teacher: for you.", "> Techer: for you.", "Teacher:", -1},
      {"notes", "[!TIP]", "[!HINT]", "TIP"},
      {"notes", "> [!TIP]\n> A hint.", "> [!TIP]", "empty"},
      {"notes", "More text.", "More <b>text</b>.", "HTML"},
      {"notes", "More text.", "<!-- a remark\n\nMore text.", "no end"},
      {"notes", "More text.", "More text \xF0\x9F\xA7\xAC.", "no sign"},
      {"notes", "More text.", "More text with a \xFF byte.", "UTF-8"},
  };
  return all;
}

Expected<std::shared_ptr<const Molecule>> onlyMix(const NamedMolecule& named) {
  if (named.name == "mix") return std::make_shared<const Molecule>(mixedMolecule());
  return Problem{{}, 0, 0, "there is no molecule '" + named.name + "'", "choose another"};
}

}  // namespace

TEST_CASE(
    "of 165 mistakes in a good lesson, by six kinds, each is reported at its line with words that "
    "lead to what mends it") {
  const LessonCheck good = checkLesson("l.md", kGood, onlyMix);
  for (const Problem& p : good.errors) FAIL_CHECK(p.text());
  for (const Problem& p : good.warnings) FAIL_CHECK(p.text());
  std::map<std::string, std::pair<int, int>> reported;  // of each kind: correctly reported, total
  for (const Mistake& m : mistakes()) {
    CAPTURE(m.kind);
    CAPTURE(m.bad);
    std::string text = kGood;
    const std::size_t at = text.find(m.good);
    REQUIRE(at != std::string::npos);
    const auto line = std::size_t(1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n') + m.below);
    text.replace(at, m.good.size(), m.bad);
    const LessonCheck check = checkLesson("l.md", text, onlyMix);
    std::vector<Problem> all = check.errors;
    all.insert(all.end(), check.warnings.begin(), check.warnings.end());
    bool right = false;
    std::string said;
    for (const Problem& p : all) {
      right = right || (p.line == line && (p.message + "; " + p.remedy).find(m.words) != std::string::npos);
      said += p.text() + '\n';
    }
    INFO("expected at line " << line << ": " << m.words << "; told:\n" << said);
    CHECK(right);
    reported[m.kind].first += right;
    ++reported[m.kind].second;
  }
  int all = 0;
  for (const auto& [kind, counts] : reported) all += counts.second;
  CHECK(all == 165);
}

TEST_CASE(
    "every key of plain text, of all tasks and of each kind, warns about Markdown that would be "
    "shown literally") {
  std::size_t keys = 0;
  const auto reported = [](std::string_view kind, std::string_view key) {
    Lesson lesson;
    Step& step = lesson.steps.emplace_back();
    TaskSpec& task = step.tasks.emplace_back();
    task.kind = kind;
    Value value;
    value.place = {.line = 7, .column = 6};
    value.text = "Touch **it**.";
    task.values.set(key, value);
    checks::Findings findings;
    checks::steps(lesson, findings);
    REQUIRE(findings.warnings.size() == 1);
    CHECK(findings.warnings[0].line == 7);
    CHECK(findings.warnings[0].column == 12);
  };
  for (const TaskKind& kind : taskKinds())
    for (const std::span<const KeySpec> of : {std::span<const KeySpec>(kind.keys), std::span(keysOf(KeyBlock::Touch))})
      for (const KeySpec& key : of) {
        CAPTURE(std::string(kind.name));
        CAPTURE(std::string(key.name));
        if (key.type != ValueType::Text) continue;
        ++keys;
        reported(kind.name, key.name);
      }
  CHECK(keys >= 3 * taskKinds().size() + 3);
}
