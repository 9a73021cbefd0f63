// The findings of `moltact check` for single texts. The molecule is the ten-atom one of small_molecules.h.
#include "engine/lesson/check.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "engine/lesson/lesson_files.h"
#include "engine/lesson/lesson_molecules.h"
#include "tests/lesson/small_molecules.h"
#include "tests/lesson/small_picture.h"

using namespace moltact;

namespace {

namespace fs = std::filesystem;

// Eight lines of front matter; the body starts on line 9.
const std::string kHead = "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: mix\nauthor: A\nlicence: L\n---\n";
const std::string kStep = "## One step\n```scene\nmolecule: mix\n```\nText.\n";  // lines 9 to 13

Expected<std::shared_ptr<const Molecule>> onlyMix(const NamedMolecule& named) {
  const std::string& name = named.name;
  if (name == "mix") return std::make_shared<const Molecule>(mixedMolecule());
  return Problem{{}, 0, 0, "there is no molecule '" + name + "'", "choose another"};
}

using Texts = std::vector<std::string>;
Texts texts(const std::vector<Problem>& problems) {
  Texts out;
  for (const Problem& p : problems) out.push_back(p.text());
  return out;
}
Texts errors(const std::string& text) { return texts(checkLesson("l.md", text, onlyMix).errors); }
Texts warnings(const std::string& text) { return texts(checkLesson("l.md", text, onlyMix).warnings); }

struct Folder {
  fs::path path = fs::temp_directory_path() / ("moltact-check-" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((path / name).parent_path());
    std::ofstream(path / name, std::ios::binary) << text;
  }
};

}  // namespace

TEST_CASE("a lesson without faults has no errors, and a student can begin it") {
  const LessonCheck check = checkLesson("l.md", kHead + kStep, onlyMix);
  CHECK(check.errors.empty());
  CHECK(check.warnings.empty());
  CHECK(check.lesson.has_value());
}

TEST_CASE(
    "a simulated molecule of 501 atoms, more than a page simulates, is a warning, one of 500 is none; 801 "
    "atoms, too many for 1000 steps per second, are another") {
  const auto warned = [](std::size_t atoms) {
    Molecule molecule = mixedMolecule();
    std::vector<Atom> many(molecule.atoms.begin(), molecule.atoms.end());
    std::vector<Sphere> spheres(molecule.spheres.begin(), molecule.spheres.end());
    many.resize(atoms, many.back());
    spheres.resize(atoms, spheres.back());
    molecule.atoms = std::move(many);
    molecule.spheres = std::move(spheres);
    const auto shared = std::make_shared<const Molecule>(std::move(molecule));
    const auto large = [&](const NamedMolecule&) -> Expected<std::shared_ptr<const Molecule>> { return shared; };
    return texts(
        checkLesson("l.md", kHead + "## One step\n```scene\nmolecule: mix\nsimulation: mix.xml\n```\nText.\n", large)
            .warnings);
  };
  CHECK(warned(500).empty());
  CHECK(warned(501) ==
        Texts{"l.md:12:13: a page in a browser simulates at most 500 atoms: it shows this molecule, of 501, at rest; "
              "take a part of it, or have students use the desktop program"});
  CHECK(warned(800).size() == 1);
  REQUIRE(warned(801).size() == 2);
  CHECK(warned(801)[0] ==
        "l.md:12:13: a molecule of 801 atoms makes fewer than 1000 steps per second on two cores: its answer to the "
        "hand comes late; take a part of it, of at most 800 atoms, or measure on your computers: moltact simulate run");
}

TEST_CASE(
    "a lesson's name gives its language; an ending that is not a language is a warning, a "
    "contradiction an error") {
  CHECK(lessonName("a/first-touch.de.md").id == "first-touch");
  CHECK(lessonName("a/first-touch.de.md").language == "de");
  CHECK(lessonName("first-touch.md").language.empty());
  CHECK(lessonName("first.touch.md").id == "first.touch");
  CHECK(lessonName("first.touch.md").language.empty());
  const auto reported = [](const char* name, const std::string& keys) {
    const LessonCheck check = checkLesson(name, "---\n" + keys + kHead.substr(4) + kStep, onlyMix);
    Texts out = texts(check.errors), more = texts(check.warnings);
    out.insert(out.end(), more.begin(), more.end());
    return out;
  };
  CHECK(reported("l.de.md", "").empty());
  CHECK(reported("l.de.md", "language: de\n").empty());
  CHECK(reported("l.md", "language: de\n").empty());
  CHECK(reported("l.de.md", "language: en\n") ==
        Texts{"l.de.md:2:11: the file's name says that the lesson is in 'de', its "
              "front matter in 'en'; let both say the same"});
  CHECK(reported("l.md", "language: deutsch\n") ==
        Texts{"l.md:2:11: 'deutsch' is no language's code; write its two letters: en, de"});
  CHECK(
      reported("l.old.md", "") ==
      Texts{
          "l.old.md:1:1: 'old' at the end of the file's name is no language; name a lesson in another language by its "
          "two letters: first-touch.de.md"});
}

TEST_CASE("of the files of a lesson the one in the language is taken, else the one of no language, else the first") {
  const std::vector<fs::path> all{"x/a.de.md", "x/a.md", "x/b.md", "x/c.de.md", "x/c.fr.md", "y/a.md"};
  CHECK(inLanguage(all, "de") == std::vector<fs::path>{"x/a.de.md", "x/b.md", "x/c.de.md", "y/a.md"});
  CHECK(inLanguage(all, "en") == std::vector<fs::path>{"x/a.md", "x/b.md", "x/c.de.md", "y/a.md"});
  CHECK(inLanguage(all, "fr") == std::vector<fs::path>{"x/a.md", "x/b.md", "x/c.fr.md", "y/a.md"});
}

TEST_CASE(
    "characters that the window cannot write are reported with their line: Chinese, Hebrew and a "
    "smile, not Greek or Cyrillic") {
  CHECK(warnings(kHead + kStep + "α-Helix, Ж, 20 Å, “so” – 3 ≤ 4 → 5₂\n").empty());
  CHECK(warnings(kHead + kStep + "Two \u4E2D and \u4E2D\u6587\n\nthen \U0001F600\n\nand \u05E9\n") ==
        Texts{"l.md:14:5: the window's fonts have no sign for '\u4E2D' (U+4E2D), '\u6587' (U+6587); it is shown as "
              "'?': write it "
              "otherwise",
              "l.md:16:6: the window's fonts have no sign for '\U0001F600' (U+1F600); it is shown as '?': write it "
              "otherwise",
              "l.md:18:5: the window cannot set the script of '\u05E9' (U+05E9); it sets signs from left to right, "
              "each for "
              "itself"});
}

TEST_CASE("an unknown key, a bare number, an empty selection and an unused molecule are reported in one go") {
  CHECK(errors("---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: mix, water\nauthor: A\nlicence: L\nlisense: M\n---\n" +
               kStep + "```touch\nreach: ligand BTX\nnear: 4\nsay: S\n```\n") ==
        Texts{"l.md:5:17: there is no molecule 'water'; choose another",
              "l.md:5:17: no scene uses 'water'; take it out, or add a scene with 'molecule: water'",
              "l.md:8:1: front matter has no key 'lisense'; did you mean 'licence'?",
              "l.md:16:15: ligand 'BTX' is not in mix (ligands: HEM); name atoms that it has",
              "l.md:17:7: '4' needs a unit: Å or nm"});
}

TEST_CASE("a selection behind 'facing' is reported at its own column, and a name that selects nothing is a warning") {
  CHECK(errors(kHead + "## A\n```scene\nmolecule: mix\nview: facing  chain C\n```\nText.\n") ==
        Texts{"l.md:12:21: chain 'C' is not in mix (chains: A, B); name atoms that it has"});
  CHECK(warnings(kHead + "## A\n```scene\nmolecule: mix\nhighlight: resname HEM HEX\n```\nText.\n") ==
        Texts{"l.md:12:24: residue name 'HEX' is not in mix (names: ASP, DA, HEM, HOH, ZN); did you mean 'HEM'?"});
}

TEST_CASE("an aside that no reachable step links to is an error; links from asides that can be reached count") {
  CHECK(errors(kHead + kStep + "## Aside: More\nText.\n") ==
        Texts{"l.md:14:4: no link leads to this aside, so no student can come to it; link to it from another step: "
              "[More](#aside-more)"});
  CHECK(errors(kHead + kStep +
               "See [more](#aside-more).\n## Aside: More\nSee [yet](#aside-yet-more).\n## Aside: Yet more\nText.\n")
            .empty());
  // Two asides that lead only to each other.
  CHECK(errors(kHead + kStep +
               "## Aside: More\nSee [yet](#aside-yet-more).\n## Aside: Yet more\nSee [more](#aside-more).\n")
            .size() == 2);
  CHECK(errors(kHead + "## Aside: One\n```scene\nmolecule: mix\n```\nText [here](#aside-one).\n")[0] ==
        "l.md:9:4: the first step is an aside; start with a step that every student sees: '## …'");
}

TEST_CASE("a step without a word, a choice without feedback and one that is there twice are reported") {
  CHECK(errors(kHead + "## A\n```scene\nmolecule: mix\n```\n") ==
        Texts{"l.md:9:4: this step says nothing to the student; write a sentence below its heading"});
  CHECK(
      warnings(kHead + kStep + "### Question: Q?\n- [x] a → Yes.\n- [ ] b\n") ==
      Texts{"l.md:16:7: this choice has no feedback; write → after it and tell the student why it is right or wrong"});
  CHECK(errors(kHead + kStep + "### Question: Q?\n- [x] a → Yes.\n- [ ] a → No.\n") ==
        Texts{"l.md:16:7: this choice is there twice; take one of the two out; the other is on line 15"});
  CHECK(errors(kHead + kStep + "### Question: Q?\n```answer\ntext: ,\n```\n") ==
        Texts{"l.md:16:7: this question has no right answer; write the words that count as right"});
}

TEST_CASE("methods that are to be compared while they are locked are an error") {
  const std::string task = "```touch\ncompare: exact, paper\nsay: S\n```\n";
  CHECK(errors(kHead + kStep + task).empty());
  CHECK(errors(kHead + "## A\n```scene\nmolecule: mix\nlocked: method\n```\n" + task) ==
        Texts{"l.md:15:10: the student cannot switch methods here, for they are locked; take 'method' out of 'locked', "
              "or this task"});
}

TEST_CASE(
    "fenced blocks and comments without an end are reported where they begin, and what they swallow "
    "is not judged") {
  CHECK(errors(kHead + "## A\n```scene\nmolecule: mix\n\nText.\n\n## B\n[x](#nowhere)\n") ==
        Texts{"l.md:10:1: this fenced block has no end, so what follows it is not read; close it with a line of its "
              "own: ```"});
  CHECK(errors(kHead + "## A\n```scene\nmolecule: mix\n\n```touch\nreach: all\nsay: S\n```\n[x](#nowhere)\n") ==
        Texts{"l.md:10:1: this fenced block has no end, so what follows it is not read; close it with a line of its "
              "own: ```"});
  CHECK(errors(kHead + kStep + "~~~~\ncode\n```\n") == Texts{"l.md:14:1: this fenced block has no end, so what follows "
                                                             "it is not read; close it with a line of its own: ```"});
  CHECK(errors(kHead + kStep + "~~~~\n```\ncode\n~~~~\n").empty());
  CHECK(errors(kHead + kStep + "\n<!-- a note\n\n## B\n") ==
        Texts{"l.md:15:1: this comment has no end, so nothing below it is shown; close it with '-->'"});
}

TEST_CASE("front matter without its end is reported, and the lesson behind it is still checked") {
  CHECK(errors("---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: mix\nauthor: A\nlicence: L\n\nHello: there.\n\n" +
               kStep + "```touch\nreach: all\nsay: S\nnear: 4\n```\n") ==
        Texts{"l.md:1:1: the front matter has no end; close it with a line '---'",
              "l.md:19:7: '4' needs a unit: Å or nm"});
}

TEST_CASE("links and pictures are looked up beside the lesson; web addresses are left alone") {
  const Folder folder;
  folder.write("ring.png", kRedPng);
  folder.write("sub/a b.txt", "");
  folder.write("other.md", kHead + kStep);
  const auto reported = [&](const std::string& body) {
    Texts out;
    for (const Problem& p : checkLesson((folder.path / "l.md").string(), kHead + kStep + body, onlyMix).errors)
      out.push_back(std::to_string(p.line) + ":" + std::to_string(p.column) + " " + p.message + "; " + p.remedy);
    return out;
  };
  CHECK(reported("![A ring](ring.png) [a](sub/a%20b.txt) [b](other.md) [c](other.md#one-step) "
                 "[d](https://example.org/x.md#y) [e](mailto:a@b.c)\n")
            .empty());
  CHECK(reported("Å ![A ring](rong.png)\n") ==
        Texts{"14:3 the picture 'rong.png' leads to no file; did you mean 'ring.png'?"});
  CHECK(reported("See **[this](other.md#one-stop)**.\n") ==
        Texts{"14:14 there is no step '#one-stop' in other.md; did you mean 'one-step'?"});
  CHECK(reported("[a](sub/none.txt)\n") ==
        Texts{"14:5 the link 'sub/none.txt' leads to no file; put it there, or mend its "
              "name; it is looked for in the lesson's folder"});
  CHECK(reported("[a](/etc/hosts)\n") ==
        Texts{"14:5 the link '/etc/hosts' leads to a place of this computer only; put the "
              "file beside the lesson and write its name"});
  CHECK(reported("[a](ftp://x.org/y)\n")[0].starts_with(
      "14:5 the link 'ftp://x.org/y' leads to nothing that a lesson can show"));
}

TEST_CASE("a molecule is looked up beside the lesson, then in the library; a broken file is reported with its line") {
  const Folder folder;
  folder.write("mine.xyzr", "0 0 0 1.5\n");
  folder.write("bad.xyzr", "0 0 0 1.5\n0 0 zero 1.5\n");
  LessonMolecules molecules;
  const fs::path lesson = folder.path / "l.md";
  REQUIRE(molecules.find(lesson, "mine.xyzr"));
  CHECK((*molecules.find(lesson, "mine.xyzr"))->atoms.size() == 1);
  // The file as it is now counts, not as it was.
  folder.write("mine.xyzr", "0 0 0 1.5\n3 0 0 1.5\n");
  fs::last_write_time(folder.path / "mine.xyzr", fs::file_time_type::clock::now() + std::chrono::hours(1));
  CHECK((*molecules.find(lesson, "mine.xyzr"))->atoms.size() == 2);
  CHECK(*molecules.find(lesson, "1ubq") == *molecules.find(lesson, "1ubq"));
  CHECK(molecules.find(lesson, "bad.xyzr")
            .problem()
            .message.starts_with("the molecule's file cannot be used: bad.xyzr, line 2: "));
  CHECK(molecules.find(lesson, "1ubk").problem().text() ==
        "there is no molecule '1ubk' in the library nor beside the lesson; did you mean '1ubq'? 'moltact fetch 1ubk' "
        "downloads an entry of the PDB");
  CHECK(molecules.find(lesson, "sub/x.pdb").problem().message == "there is no file 'sub/x.pdb' beside the lesson");
}

TEST_CASE(
    "in a folder, Markdown with front matter or a block of a lesson is a lesson, in its folders too, hidden ones not") {
  const Folder folder;
  folder.write("b.md", "---\n");
  folder.write("a.md", "# No front matter\n\n```touch\n");
  folder.write("deep/er/c.MD", "---\n");
  folder.write("README.md", "# Read me\n");
  folder.write(".git/d.md", "---\n");
  folder.write("notes.txt", "---\n");
  const LessonFolder found = lessonsIn(folder.path);
  CHECK_FALSE(found.fault);
  CHECK(found.lessons ==
        std::vector<fs::path>{folder.path / "a.md", folder.path / "b.md", folder.path / "deep/er/c.MD"});
  CHECK(found.others == std::vector<fs::path>{folder.path / "README.md"});
  CHECK(lessonsIn(folder.path / ".git" / "none").fault->message.starts_with("the folder cannot be read"));
}

TEST_CASE("each way of reading a molecule's file is kept by itself") {
  LessonMolecules molecules;
  const NamedMolecule wet("1ubq", {.waters = true});
  CHECK((*molecules.find("l.md", "1ubq"))->atoms.size() == 602);
  CHECK((*molecules.find("l.md", wet))->atoms.size() == 660);
  CHECK(*molecules.find("l.md", wet) == *molecules.find("l.md", wet));
}
