#include "engine/lesson/reader.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "engine/lesson/check.h"
#include "engine/lesson/tasks/registry.h"
#include "tests/lesson/small_molecules.h"

using namespace moltact;

namespace {

// Eight lines of front matter; the body starts on line 9.
const std::string kReaderHead =
    "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: mix, water\nauthor: A\nlicence: L\n---\n";
const std::string kReaderStep = "## One step\n```scene\nmolecule: mix\n```\n";  // lines 9 to 12

std::vector<std::string> readerTexts(const std::vector<Problem>& problems) {
  std::vector<std::string> out;
  for (const Problem& p : problems) out.push_back(p.text());
  return out;
}
std::vector<std::string> readerErrors(const std::string& text) {
  return readerTexts(readLessonText("l.md", text).errors);
}
using Texts = std::vector<std::string>;

Lesson readerLesson(const std::string& body) {
  LessonReading read = readLessonText("l.md", kReaderHead + body);
  for (const Problem& p : read.errors) MESSAGE(p.text());
  REQUIRE(read.lesson);
  return *std::move(read.lesson);
}

}  // namespace

TEST_CASE("a misspelt key and a bare number are reported at once, at 14:1 and 19:7") {
  CHECK(readerErrors(kReaderHead + kReaderStep +
                     "```touch\nreech: all\n```\n```touch\nreach: all\nsay: S\nnear: 4\n```\n") ==
        Texts{"l.md:14:1: touch has no key 'reech'; did you mean 'reach'?", "l.md:19:7: '4' needs a unit: Å or nm"});
  CHECK(readerErrors(kReaderHead + kReaderStep + "```touch\nfell: crease\nsay: S\n```\n") ==
        Texts{"l.md:14:1: touch has no key 'fell'; did you mean 'feel'?"});
  CHECK(readerErrors(kReaderHead + kReaderStep + "```touch\nfeel: crease\nsaay: S\n```\n") ==
        Texts{"l.md:13:4: touch needs the key 'say'; add a line 'say: …'",
              "l.md:15:1: touch has no key 'saay'; did you mean 'say'?"});
}

TEST_CASE(
    "'hand: springs' without a body in the hand is reported; with one it is taken, and 'exact-body' is its fallback") {
  const std::string scene = "```scene\nmolecule: mix\n", end = "```\nText.\n";
  const Texts reported = readerErrors(kReaderHead + "## One\n" + scene + "hand: springs\n" + end);
  CHECK(std::any_of(reported.begin(), reported.end(), [](const std::string& t) {
    return t.find("the hand holds no body, which 'springs' needs") != std::string::npos;
  }));
  const auto handOf = [&](const std::string& keys) {
    const Lesson read = readerLesson("## One\n" + scene + keys + end);
    return read.steps.at(0).scene.touch.interaction;
  };
  CHECK(handOf("in-hand: all\nhand: springs\n") == "springs");
  CHECK(handOf("in-hand: all\n") == "exact-body");
  CHECK(handOf("") == "probe");
}

TEST_CASE("a fault behind a tab is reported at its second character") {
  const Texts reported = readerErrors(kReaderHead + kReaderStep + "```touch\n\tnonsense\n```\n");
  CHECK(std::any_of(reported.begin(), reported.end(),
                    [](const std::string& t) { return t.starts_with("l.md:14:2: 'nonsense'"); }));
}

TEST_CASE(
    "faults of touch blocks are reported: no task, two tasks, keys of other tasks, bad values, the "
    "place in Å counted in characters") {
  CHECK(
      readerErrors(kReaderHead + kReaderStep + "```touch\nsay: S\n```\n") ==
      Texts{"l.md:13:4: the touch block names no task; add a line that starts with reach, hold, press, feel, cross, "
            "avoid, compare, meet, trace, find, predict, same, fit, measure, order, rank, dock, pull, pass or contacts "
            "and a colon"});
  CHECK(readerErrors(kReaderHead + kReaderStep + "```touch\nreach: all\nhold: all\nsay: S\n```\n") ==
        Texts{"l.md:15:1: a touch block holds one task, but this one has 'reach' and 'hold'; write two touch blocks"});
  CHECK(readerErrors(kReaderHead + kReaderStep + "```touch\nreach: all\ncount: 3\nsay: S\n```\n") ==
        Texts{"l.md:15:1: touch has no key 'count'; that key belongs to 'feel', 'contacts'"});
  CHECK(readerErrors(kReaderHead + kReaderStep + "```touch\nhold: creese\nsay: S\n```\n") ==
        Texts{"l.md:14:7: 'hold' cannot be 'creese'; did you mean 'crease'?"});
  CHECK(readerErrors(kReaderHead + kReaderStep + "```touch\nreach: within 5 Å of (resnam X)\nsay: S\n```\n") ==
        Texts{"l.md:14:23: 'resnam' is no word of a selection; did you mean 'resname'?"});
  CHECK(readerErrors(kReaderHead + kReaderStep + "```touch\nhold: all\nfor: 0.01 s\nsay: S\nsay: T\nrubbish\n```\n") ==
        Texts{"l.md:15:6: '0.01 s' is too small; the smallest is 0.1 s",
              "l.md:17:1: 'say' is given twice; take one of the two out",
              "l.md:18:1: 'rubbish' is not a key and its value; write it as 'key: value'"});
  CHECK(readerErrors(kReaderHead + kReaderStep + "```touch\nfeel: pit\ncount: 3\nsay: S\n```\n") ==
        Texts{"l.md:15:8: 'count' belongs to 'feel: atoms'; take it out or write 'feel: atoms'"});
}

TEST_CASE("faults of front matter are reported: none, no end, missing and unknown keys, a level that is none") {
  CHECK(
      readerErrors("## S\n")[0] ==
      "l.md:1:1: the lesson has no front matter; begin the file with '---', 'title: …' and the other keys, and '---'");
  CHECK(readerErrors("---\ntitle: T\n")[0] == "l.md:1:1: the front matter has no end; close it with a line '---'");
  CHECK(readerErrors(
            "---\ntitel: T\nminutes: soon\nlevel: expert\ngoals: G\nmolecules: mix\nauthor: A\nlicence: L\n---\n" +
            kReaderStep) ==
        Texts{"l.md:1:1: front matter needs the key 'title'; add a line 'title: …'",
              "l.md:2:1: front matter has no key 'titel'; did you mean 'title'?",
              "l.md:3:10: 'soon' is not a number; write a whole number and nothing else, as in '10'",
              "l.md:4:8: 'level' cannot be 'expert'; known: beginner, intermediate, advanced"});
}

TEST_CASE(
    "faults of steps and scenes are reported: no steps, no scene, two scenes, the same name, an "
    "unknown molecule or method") {
  CHECK(readerErrors(kReaderHead) == Texts{"l.md:1:1: the lesson has no steps; start each step with a heading '## …'"});
  CHECK(readerErrors(kReaderHead + "## S\nText\n") ==
        Texts{"l.md:9:4: the first step has no scene; add a fenced block 'scene' with 'molecule: …'"});
  CHECK(readerErrors(kReaderHead + kReaderStep + "```scene\nprobe: 1 Å\n```\n") ==
        Texts{"l.md:13:4: a second scene in one step; start a new step, or put both into one block"});
  CHECK(readerErrors(kReaderHead + kReaderStep + "## One step\n") ==
        Texts{"l.md:13:4: two steps are called 'One step'; rename one; the other is on line 9"});
  CHECK(readerErrors(kReaderHead + "## S\n```scene\nmolecule: watr\nmethod: exakt\nprobe: 99 Å\n```\n") ==
        Texts{"l.md:11:11: 'watr' is not among the lesson's molecules; did you mean 'water'?",
              "l.md:12:9: 'method' cannot be 'exakt'; did you mean 'exact'?",
              "l.md:13:8: '99 Å' is too large; the largest is 20 Å"});
  CHECK(readerErrors(kReaderHead + "```scene\nmolecule: mix\n```\n" + kReaderStep)[0] ==
        "l.md:9:4: a scene block before the first step; put it below a heading '## …'");
}

TEST_CASE("faults of questions and links are reported: nothing right, one choice, nothing to answer, a dead link") {
  CHECK(readerErrors(kReaderHead + kReaderStep + "### Question: Q?\n- [ ] a\n- [ ] b\n") ==
        Texts{"l.md:13:5: this question has no right answer; mark the right choice with '[x]'"});
  CHECK(readerErrors(kReaderHead + kReaderStep + "### Question: Q?\n- [x] a\n") ==
        Texts{"l.md:13:5: this question has only one choice; add another line '- [ ] …'"});
  CHECK(readerErrors(kReaderHead + kReaderStep + "### Question: Q?\n") ==
        Texts{"l.md:13:5: this question has nothing to answer; add a list of choices '- [x] …' or an answer block"});
  CHECK(readerErrors(kReaderHead + kReaderStep + "See [there](#one-stop).\n") ==
        Texts{"l.md:13:13: the link '#one-stop' leads to no step; did you mean 'one-step'?"});
  CHECK(readerErrors(kReaderHead + kReaderStep + "- [x] a\n") ==
        Texts{"l.md:13:7: a task list outside a question; put '### Question: …' above it, or take out the '[ ]'"});
  CHECK(readerErrors(kReaderHead + kReaderStep + "```answer\nfree: yes\n```\n") ==
        Texts{"l.md:13:4: an answer block without a question; put '### Question: …' above it"});
}

TEST_CASE("an unknown fence is a warning and is shown; bytes that are not UTF-8 are reported at their column") {
  const LessonReading read = readLessonText("l.md", kReaderHead + kReaderStep + "```scenes\nx\n```\n");
  CHECK(read.lesson);
  CHECK(readerTexts(read.warnings) ==
        Texts{"l.md:13:4: 'scenes' is not a block of a lesson and is shown unchanged; did you mean 'scene'?"});
  CHECK(readerErrors(kReaderHead + "## Å \xFF") ==
        Texts{"l.md:9:6: this is not UTF-8 text; save the file in the encoding UTF-8"});
  CHECK(readerErrors("") == Texts{"l.md:1:1: the file is empty; start from the text of another lesson"});
}

TEST_CASE("missing files and folders are reported") {
  CHECK(readLesson("/nowhere/l.md").errors[0].text() ==
        "/nowhere/l.md: there is no such file; check its name and folder");
  CHECK(readLesson(MOLTACT_SOURCE_DIR).errors[0].message == "this is not a file");
}

TEST_CASE(
    "text keeps bold, italic, code and links; tips, teacher notes, lists and pictures become blocks in their order") {
  const Lesson l = readerLesson(kReaderStep +
                                "A **bold** and *slanted* `code` [link](#one-step).\n\n> [!TIP]\n> Help\n> more\n\n> "
                                "[!NOTE]\n> Teacher: Secret\n\n"
                                "- a\n- b\n  1. c\n\n![A ring](ring.png)\n");
  const auto& blocks = l.steps[0].blocks;
  REQUIRE(blocks.size() == 5);
  const RichText& text = std::get<Paragraph>(blocks[0]).text;
  REQUIRE(text.size() == 9);
  CHECK(plainText(text) == "A bold and slanted code link.");
  CHECK((text[1].bold && text[3].italic && text[5].code));
  CHECK(text[7].link == "#one-step");
  CHECK(text[7].place.line == 13);
  CHECK(plainText(std::get<Tip>(blocks[1]).paragraphs.at(0)) == "Help more");
  CHECK(plainText(std::get<TeacherNote>(blocks[2]).paragraphs.at(0)) == "Secret");
  const auto& items = std::get<ListBlock>(blocks[3]).items;
  REQUIRE(items.size() == 3);
  CHECK((items[2].depth == 1 && items[2].number == 1));
  CHECK(std::get<Image>(blocks[4]).path == "ring.png");
  CHECK(std::get<Image>(blocks[4]).description == "A ring");
}

TEST_CASE("a scene without a molecule changes only what it says; one with a molecule starts again") {
  const Lesson l = readerLesson(
      "## A\n```scene\nmolecule: mix\nprobe: 0.2 nm\nstiffness: 300 N/m\nforce: off\n```\n"
      "## B\n## C\n```scene\nprobe: 1 Å\nview: facing ligand\n```\n## D\n```scene\nmolecule: water\n```\n");
  CHECK(l.steps[0].scene.touch.probe_A == 2.0);
  CHECK(l.steps[0].scene.touch.stiffness_N_per_mm == doctest::Approx(0.3));
  CHECK((l.steps[1].scene.touch.probe_A == 2.0 && !l.steps[1].states_scene));
  CHECK((l.steps[2].scene.touch.probe_A == 1.0 && !l.steps[2].scene.touch.force_on &&
         l.steps[2].scene.molecule == "mix"));
  CHECK((l.steps[2].scene.view.side.empty() && l.steps[2].scene.view.facing.text() == "ligand"));
  const SceneSpec& d = l.steps[3].scene;
  CHECK((d.touch.probe_A == 1.4 && d.touch.force_on && d.touch.stiffness_N_per_mm == doctest::Approx(0.5)));
  CHECK((d.view.side == "side" && !d.view.facing.given()));
  CHECK(d.show == Texts{"atoms", "probe", "force", "target", "hip", "facets"});
}

TEST_CASE("what a scene magnifies continues until a scene says otherwise, 'none' or another molecule") {
  const Lesson l = readerLesson(
      "## A\n```scene\nmolecule: mix\nmagnify: ligand\n```\n## B\n```scene\nprobe: 1 Å\n```\n"
      "## C\n```scene\nmagnify: none\n```\n## D\n```scene\nmagnify: residue 52\n```\n## E\n```scene\nmolecule: "
      "water\n```\n");
  CHECK(l.steps[0].scene.magnify.text() == "ligand");
  CHECK(l.steps[1].scene.magnify.text() == "ligand");
  CHECK_FALSE(l.steps[2].scene.magnify.given());
  CHECK(l.steps[3].scene.magnify.text() == "residue 52");
  CHECK_FALSE(l.steps[4].scene.magnify.given());
  CHECK(readerErrors(kReaderHead + "## S\n```scene\nmolecule: mix\nmagnify: noen\n```\n") ==
        Texts{"l.md:12:10: 'magnify' cannot be 'noen'; did you mean 'none'?"});
}

TEST_CASE(
    "a scene locks what it and the front matter name; the next molecule's scene only what the front matter names") {
  const std::string head =
      "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: mix, water\nauthor: A\nlicence: L\nlocked: method\n---\n";
  const LessonReading read = readLessonText(
      "l.md",
      head +
          "## A\n```scene\nmolecule: mix\nforce: off\npanels: none\nlocked: force, panels\n```\n"
          "## B\n```scene\nprobe: 1 Å\n```\n## C\n```scene\nlocked: all\n```\n## D\n```scene\nmolecule: water\n```\n");
  REQUIRE(read.lesson);
  const auto& steps = read.lesson->steps;
  CHECK((steps[0].scene.locks("method") && steps[0].scene.locks("force") && steps[0].scene.locks("panels") &&
         !steps[0].scene.locks("probe")));
  CHECK(steps[0].scene.panels == Texts{"none"});
  CHECK((steps[1].scene.locks("force") && !steps[1].scene.locks("probe")));
  CHECK(steps[2].scene.locks("probe"));
  CHECK((steps[3].scene.locks("method") && !steps[3].scene.locks("force")));
  CHECK(readerErrors(kReaderHead + "## S\n```scene\nmolecule: mix\npanels: none, touch\nlocked: forse\n```\n") ==
        Texts{"l.md:12:9: 'none' stands alone; take it out, or the other panels",
              "l.md:13:9: 'locked' cannot be 'forse'; did you mean 'force'?"});
}

TEST_CASE(
    "a question has its prompt, its right choices, feedback after either arrow and the step that the feedback leads "
    "to") {
  const Lesson l =
      readerLesson(kReaderStep +
                   "### Question: Which `one`?\nThink.\n- [x] This → Yes: [on](#one-step)\n- [ ] That -> No\n\nAfter.\n"
                   "### Question: How long?\n```answer\nnumber: 1.4 Å\ntolerance: 0.1 Å\n```\n");
  REQUIRE(l.steps[0].questions.size() == 2);
  const Question& q = l.steps[0].questions[0];
  CHECK(q.id == "which-one");
  CHECK(plainText(q.title) == "Which one?");
  CHECK(plainText(q.prompt.at(0)) == "Think.");
  REQUIRE(q.choices.size() == 2);
  CHECK((q.choices[0].right && !q.choices[1].right));
  CHECK(plainText(q.choices[0].text) == "This");
  CHECK(plainText(q.choices[0].feedback) == "Yes: on");
  CHECK(q.choices[0].link == "#one-step");
  CHECK(plainText(q.choices[1].feedback) == "No");
  REQUIRE(l.steps[0].questions[1].answer);
  CHECK(l.steps[0].questions[1].answer->number == doctest::Approx(1.4));
  CHECK(l.steps[0].questions[1].answer->unit == "Å");
}

TEST_CASE("Windows line ends and a byte order mark change no place and no text") {
  std::string text = "\xEF\xBB\xBF" + kReaderHead + kReaderStep + "```touch\nreach: all\nsay: S\nnear: 4\n```\n";
  std::string windows;
  for (const char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  CHECK(readerErrors(windows) == Texts{"l.md:16:7: '4' needs a unit: Å or nm"});
}

TEST_CASE("empty selections and molecules that are not there are reported at their place in the lesson") {
  const Lesson l = readerLesson(
      "## A\n```scene\nmolecule: mix\nhighlight: chain C\n```\n```touch\nreach: ligand BTX\nsay: S\n```\n"
      "```touch\ncross: all\nto: ligand\nsay: S\n```\n## B\n```scene\nmolecule: water\n```\n");
  int asked = 0;
  const auto found =
      checkAgainstMolecules(l, [&](const NamedMolecule& named) -> Expected<std::shared_ptr<const Molecule>> {
        const std::string& name = named.name;
        ++asked;
        if (name != "mix") return Problem{{}, 0, 0, "there is no molecule '" + name + "'", "choose another"};
        return std::make_shared<const Molecule>(mixedMolecule());
      });
  CHECK(asked == 2);
  CHECK(
      readerTexts(found) ==
      Texts{"l.md:5:17: there is no molecule 'water'; choose another",
            "l.md:12:18: chain 'C' is not in mix (chains: A, B); name atoms that it has",
            "l.md:15:15: ligand 'BTX' is not in mix (ligands: HEM); name atoms that it has",
            "l.md:20:5: the start and the end of the crossing have atoms in common; choose atoms that are only in one",
            "l.md:25:11: there is no molecule 'water'; choose another"});
}

TEST_CASE("every key has a meaning that ends in a full stop, and every fallback is a good value of its key") {
  std::vector<KeySpec> all;
  for (const KeyBlock b :
       {KeyBlock::FrontMatter, KeyBlock::Step, KeyBlock::Scene, KeyBlock::Touch, KeyBlock::Answer, KeyBlock::Facts})
    all.insert(all.end(), keysOf(b).begin(), keysOf(b).end());
  for (const TaskKind& k : taskKinds()) {
    CHECK(k.keys.front().name == k.name);
    // In a touch block the name of a kind begins a task.
    for (const KeySpec& key : k.keys) CHECK((key.name == k.name || !findTaskKind(key.name)));
    all.insert(all.end(), k.keys.begin(), k.keys.end());
  }
  for (const KeySpec& k : all) {
    CAPTURE(k.name);
    CHECK(k.meaning.ends_with('.'));
    if (!k.fallback.empty()) CHECK(parseValue(k, k.fallback));
  }
}

TEST_CASE("a slug is what Git hosts make of a heading") {
  CHECK(slug("Two atoms and a crease") == "two-atoms-and-a-crease");
  CHECK(slug(" What's 4 Å? ") == "whats-4-Å");
}

TEST_CASE("model, assembly and waters continue from scene to scene; a scene that names its molecule resets them") {
  const Lesson l = readerLesson(
      "## A\n```scene\nmolecule: mix\nmodel: 2\nassembly: 1\n```\nText.\n## B\n```scene\nwaters: yes\n```\nText.\n"
      "## C\n```scene\nassembly: none\n```\nText.\n## D\n```scene\nmolecule: mix\n```\nText.\n");
  REQUIRE(l.steps.size() == 4);
  CHECK(l.steps[0].scene.molecule == NamedMolecule("mix", {.model = 2, .assembly = "1"}));
  CHECK(l.steps[1].scene.molecule == NamedMolecule("mix", {.model = 2, .waters = true, .assembly = "1"}));
  CHECK(l.steps[2].scene.molecule == NamedMolecule("mix", {.model = 2, .waters = true}));
  CHECK(l.steps[3].scene.molecule == NamedMolecule("mix"));
  CHECK(l.steps[0].scene != l.steps[3].scene);
}

TEST_CASE("a way of reading that the molecule's file does not have is reported where it is written, once") {
  const Lesson l =
      readerLesson("## A\n```scene\nmolecule: mix\n```\nText.\n## B\n```scene\nassembly: 9\n```\nText.\n## C\nText.\n");
  const auto found =
      checkAgainstMolecules(l, [&](const NamedMolecule& named) -> Expected<std::shared_ptr<const Molecule>> {
        if (!named.reading.assembly.empty()) return Problem{{}, 0, 0, "there is no assembly 9", "take another"};
        return std::make_shared<const Molecule>(mixedMolecule());
      });
  REQUIRE(found.size() == 1);
  CHECK(l.steps[1].scene.places.reading.line == found[0].line);
  CHECK(found[0].text().ends_with("there is no assembly 9; take another"));
}
