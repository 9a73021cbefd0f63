// Packing lessons: what is included, what is rejected, and that unpacking restores it.
#include "engine/pack/pack_lesson.h"

#include <doctest/doctest.h>

#include <filesystem>

#include "engine/lesson/glossary.h"
#include "engine/lesson/lesson_molecules.h"
#include "engine/lesson/reader.h"
#include "engine/pack/unpack.h"
#include "tests/lesson/small_picture.h"
#include "tests/pack/zip_maker.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

const std::string kHead = "---\ntitle: T\nminutes: 1\ngoals: G\nauthor: A\nlicence: L\nmolecules: ";

std::string lessonOn(const std::string& molecule, const std::string& text = "") {
  return kHead + molecule + "\n---\n## One\n```scene\nmolecule: " + molecule + "\n```\n" + text + "\n\nText.\n";
}

const std::string kThreeAtoms = "0 0 0 1.5\n3 0 0 1.5\n0 3 0 1.5\n";

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("links that lead out of the lesson's folder are refused at their place, those within it are packed") {
  const ScratchFolder scratch;
  fs::create_directory(scratch.path / "l");
  writeFile(scratch.path / "secret.txt", "of nobody's business");
  writeFile(scratch.path / "l" / "l.md", lessonOn("mine.xyzr", "[notes](notes.txt) [same](inside.txt)"));
  writeFile(scratch.path / "l" / "mine.xyzr", kThreeAtoms);
  writeFile(scratch.path / "l" / "real.txt", "mine");
  fs::create_symlink("real.txt", scratch.path / "l" / "inside.txt");
  fs::create_symlink("../secret.txt", scratch.path / "l" / "notes.txt");
  const PackedLesson packed = packLesson(scratch.path / "l" / "l.md");
  CHECK_FALSE(packed.pack);
  REQUIRE(packed.errors.size() == 1);
  CHECK(packed.errors[0].line == 13);
  CHECK(packed.errors[0].message ==
        "'notes.txt' cannot be packed: it is a link to a file outside of the lesson's folder");
  CHECK(packed.errors[0].remedy == "put a copy of the file in the place of the link");
  // The molecule and the translation are looked at as well.
  fs::remove(scratch.path / "l" / "notes.txt");
  writeFile(scratch.path / "l" / "notes.txt", "mine too");
  for (const char* name : {"mine.xyzr", "l.de.md"}) {
    const fs::path outside = scratch.path / name, there = scratch.path / "l" / name;
    writeFile(outside, std::string(name) == "l.de.md" ? lessonOn("mine.xyzr") : kThreeAtoms);
    fs::remove(there);
    fs::create_symlink(outside, there);
    CAPTURE(name);
    CHECK_FALSE(packLesson(scratch.path / "l" / "l.md").pack);
    fs::remove(there);
    fs::copy_file(outside, there);
    CHECK(packLesson(scratch.path / "l" / "l.md").pack);
  }
}

TEST_CASE("a lesson is packed with translation, molecule, picture, linked lesson and file, not with the library's") {
  const ScratchFolder scratch;
  writeFile(scratch.path / "l.md", lessonOn("mine.xyzr",
                                            "![ring](pictures/a%20ring.png)\n\n[on](next/n.md#one) [more](notes.pdf) "
                                            "[web](https://example.org)"));
  writeFile(scratch.path / "l.de.md", lessonOn("mine.xyzr"));
  writeFile(scratch.path / "other.md", lessonOn("argon"));
  writeFile(scratch.path / "mine.xyzr", kThreeAtoms);
  writeFile(scratch.path / "notes.pdf", "pdf");
  fs::create_directories(scratch.path / "pictures");
  fs::create_directories(scratch.path / "next");
  writeFile(scratch.path / "pictures/a ring.png", kRedPng);
  writeFile(scratch.path / "next/n.md", lessonOn("argon", "[back](../l.md) [mine](../mine.xyzr)"));
  const PackedLesson made = packLesson(scratch.path / "l.md");
  for (const Problem& p : made.errors) MESSAGE(p.text());
  REQUIRE(made.pack);
  CHECK(made.pack->files == Names{"l.de.md", "l.md", "mine.xyzr", "next/n.md", "notes.pdf", "pictures/a ring.png"});
  CHECK(made.pack->library == Names{"argon"});

  const Expected<PackFile> pack = PackFile::ofBytes("l.moltact", made.pack->bytes);
  REQUIRE(bool(pack));
  const fs::path lesson = *unpack(*pack, scratch.path / "packs");
  for (const std::string& name : made.pack->files)
    CHECK(bytesOf(lesson.parent_path() / name) == bytesOf(scratch.path / name));
  CHECK(packedLesson(lesson, "de").filename() == "l.de.md");
  CHECK(packedLesson(lesson, "fr").filename() == "l.md");
}

TEST_CASE("the words that the lessons of a folder share go with a lesson, in every language, and are found again") {
  const ScratchFolder scratch;
  writeFile(scratch.path / "l.md", lessonOn("argon", "A [hole](#word:pit)."));
  writeFile(scratch.path / "glossary.md", "- **pit**: Three.\n");
  writeFile(scratch.path / "glossary.de.md", "- **Grube**: Drei.\n");
  const PackedLesson made = packLesson(scratch.path / "l.md");
  REQUIRE(made.pack);
  CHECK(made.pack->files == Names{"glossary.de.md", "glossary.md", "l.md"});
  const fs::path lesson = *unpack(*PackFile::ofBytes("l.moltact", made.pack->bytes), scratch.path / "packs");
  CHECK(glossaryBeside(lesson, "").words.size() == 1);
}

TEST_CASE("the molecule beside a scene's own is packed as that one is") {
  const ScratchFolder scratch;
  writeFile(
      scratch.path / "l.md",
      kHead + "mine.xyzr, other.xyzr\n---\n## One\n```scene\nmolecule: mine.xyzr\nbeside: other.xyzr\n```\nText.\n");
  writeFile(scratch.path / "mine.xyzr", kThreeAtoms);
  writeFile(scratch.path / "other.xyzr", kThreeAtoms);
  const PackedLesson made = packLesson(scratch.path / "l.md");
  for (const Problem& p : made.errors) MESSAGE(p.text());
  REQUIRE(made.pack);
  CHECK(made.pack->files == Names{"l.md", "mine.xyzr", "other.xyzr"});
}

TEST_CASE("packing twice gives the same bytes, also when the files were written again at another time") {
  const ScratchFolder scratch;
  writeFile(scratch.path / "l.md", lessonOn("mine.xyzr"));
  writeFile(scratch.path / "mine.xyzr", kThreeAtoms);
  const PackedLesson one = packLesson(scratch.path / "l.md");
  REQUIRE(one.pack);
  fs::remove(scratch.path / "mine.xyzr");
  writeFile(scratch.path / "mine.xyzr", kThreeAtoms);
  fs::last_write_time(scratch.path / "l.md", fs::file_time_type::clock::now() - std::chrono::hours(5000));
  fs::permissions(scratch.path / "l.md", fs::perms::owner_all);
  CHECK(packLesson(scratch.path / "l.md").pack->bytes == one.pack->bytes);
}

TEST_CASE("a lesson with a fault is not packed, nor is one whose translation or linked lesson has one") {
  const ScratchFolder scratch;
  writeFile(scratch.path / "l.md", lessonOn("argon", "[on](n.md)"));
  writeFile(scratch.path / "n.md", lessonOn("no-such-molecule"));
  PackedLesson made = packLesson(scratch.path / "l.md");
  CHECK_FALSE(made.pack);
  REQUIRE_FALSE(made.errors.empty());
  CHECK(fs::path(made.errors.front().file).filename() == "n.md");
  CHECK(made.errors.front().line == 7);

  writeFile(scratch.path / "n.md", lessonOn("argon"));
  writeFile(scratch.path / "l.de.md", lessonOn("argon", "![no](gone.png)"));
  made = packLesson(scratch.path / "l.md");
  CHECK_FALSE(made.pack);
  REQUIRE(made.errors.size() == 1);
  CHECK(fs::path(made.errors.front().file).filename() == "l.de.md");

  CHECK_FALSE(packLesson(scratch.path / "none.md").pack);
}

TEST_CASE("what lies outside the lesson's folder, and a hidden file, are refused at their place") {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path / "lessons";
  fs::create_directories(folder);
  writeFile(scratch.path / "out.xyzr", kThreeAtoms);
  writeFile(scratch.path / "out.png", kRedPng);
  writeFile(folder / ".hidden.png", kRedPng);
  for (const std::string& text : {lessonOn("../out.xyzr"), lessonOn((scratch.path / "out.xyzr").string()),
                                  lessonOn("argon", "![p](../out.png)"), lessonOn("argon", "![p](.hidden.png)")}) {
    writeFile(folder / "l.md", text);
    const PackedLesson made = packLesson(folder / "l.md");
    CAPTURE(text);
    CHECK_FALSE(made.pack);
    REQUIRE_FALSE(made.errors.empty());
    const std::string& message = made.errors.front().message;
    CHECK((message.find("cannot be packed") != std::string::npos ||
           message.find("no pack can hold it") != std::string::npos));
    CHECK(made.errors.front().line > 7);
  }
}

TEST_CASE("a file that differs from another only in capitals is refused: on some computers they would be one") {
  const ScratchFolder scratch;
  writeFile(scratch.path / "l.md", lessonOn("argon", "![a](ring.png)\n\n![b](Ring.png)"));
  writeFile(scratch.path / "ring.png", kRedPng);
  writeFile(scratch.path / "Ring.png", kRedPng);
  const PackedLesson made = packLesson(scratch.path / "l.md");
  REQUIRE(made.errors.size() == 1);
  CHECK(made.errors.front().message == "'Ring.png' and 'ring.png' would be one file on some computers");
  CHECK(made.errors.front().line == 15);
}

TEST_CASE("a molecule beside the lesson is found by its id, as one that was downloaded is packed") {
  const ScratchFolder scratch;
  writeFile(scratch.path / "l.md", lessonOn("9xyz"));
  writeFile(scratch.path / "9XYZ.xyzr", kThreeAtoms);
  const Expected<MoleculeKey> key = lessonMolecule(scratch.path / "l.md", NamedMolecule("9xyz"));
  REQUIRE_MESSAGE(bool(key), key.problem().text());
  CHECK(key->file == scratch.path / "9XYZ.xyzr");
  const PackedLesson made = packLesson(scratch.path / "l.md");
  REQUIRE(made.pack);
  CHECK(made.pack->files == Names{"9XYZ.xyzr", "l.md"});
}

}  // namespace moltact
