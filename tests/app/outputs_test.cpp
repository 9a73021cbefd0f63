// Every command that writes, with an output that is one of its inputs or another of its outputs. Oracle: the bytes
// before.
#include <doctest/doctest.h>

#include <filesystem>
#include <vector>

#include "tests/app/command_place.h"
#include "tests/results/sample_attempt.h"

namespace moltact::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLesson =
    "---\ntitle: Haem\nminutes: 5\ngoals: G\nmolecules: mine.xyzr\nauthor: A. Teacher\nlicence: CC-BY-4.0\nask: "
    "code\n---\n## One\n```scene\nmolecule: mine.xyzr\n```\n```touch\nreach: all\nsay: Touch it.\n```\n"
    "### Question: Q?\n- [x] yes → Right.\n- [ ] no → No.\n";

struct Place : CommandPlace {
  Place() {
    writeFile(folder / "l.md", kLesson);
    writeFile(folder / "l.de.md", kLesson);
    writeFile(folder / "mine.xyzr", "0 0 0 1.5\n3 0 0 1.5\n");
    writeFile(folder / "edition.html", "<html><!--a lesson comes here--><script>program</script></html>");
    fs::copy_file(MOLTACT_SOURCE_DIR "/molecules/1ubq.pdb", folder / "m.pdb");
    fs::copy_file(MOLTACT_SOURCE_DIR "/molecules/1ubq.pdb", folder / "other.pdb");
    fs::create_symlink("m.pdb", folder / "link.pdb");
    fs::create_symlink("m.pdb", folder / "link.glb");
    writeFile(folder / "a.jsonl", sampleFile());
    fs::create_directories(folder / "results" / "deep");
    writeFile(folder / "results" / "deep" / "b.jsonl", sampleFile());
    fs::create_hard_link(folder / "a.jsonl", folder / "hard.csv");
    std::string path = "x,y,z\n";
    for (int k = 0; k < 400; ++k) path += "0,0," + std::to_string(40 - 0.1 * k) + "\n";
    writeFile(folder / "path.csv", path);
    writeFile(folder / "hand.txt", path.substr(6));
    fs::create_directories(folder / "data" / "moltact" / "molecules");
    fs::copy_file(MOLTACT_SOURCE_DIR "/molecules/1ubq.pdb", folder / "data/moltact/molecules/5ADH.cif.gz");
    fs::create_symlink("dangling.csv", folder / "dangling-link.csv");
    fs::create_directory(folder / "sub");
  }
};

struct Case {
  std::string arguments, file;  ///< the file that must stay as it is
};

std::vector<Case> inputs() {
  return {
      {"pack l.md -o l.md", "l.md"},
      {"pack l.md -o ./sub/../l.md", "l.md"},
      {"pack l.md -o l.de.md", "l.de.md"},
      {"pack l.md -o mine.xyzr", "mine.xyzr"},
      {"pack l.md --html --page edition.html -o edition.html", "edition.html"},
      {"report a.jsonl --csv a.jsonl", "a.jsonl"},
      {"report a.jsonl --html a.jsonl", "a.jsonl"},
      {"report a.jsonl --gradebook a.jsonl", "a.jsonl"},
      {"report a.jsonl --csv hard.csv", "a.jsonl"},
      {"report a.jsonl results --csv results/deep/b.jsonl", "results/deep/b.jsonl"},
      {"render m.pdb --size 64x64 --out m.pdb", "m.pdb"},
      {"render m.pdb --size 64x64 --out link.pdb", "m.pdb"},
      {"render link.pdb --size 64x64 --out m.pdb", "m.pdb"},
      {"render m.pdb --beside other.pdb --size 64x64 --out other.pdb", "other.pdb"},
      {"render m.pdb --then other.pdb --size 64x64 --out other.pdb", "other.pdb"},
      {"replay m.pdb --path path.csv --out path.csv", "path.csv"},
      {"replay m.pdb --path path.csv --out m.pdb", "m.pdb"},
      {"export m.pdb link.glb", "m.pdb"},
      {"device record simulated m.pdb --seconds 0.2 --overwrite --out m.pdb", "m.pdb"},
      {"device path r.recording --out r.recording", "r.recording"},
      {"bench hands --quick --methods penalty --recording hand.txt --molecule 1ubq --markdown hand.txt", "hand.txt"},
      {"bench hands --quick --methods penalty --recording hand.txt --molecule 1ubq --json hand.txt", "hand.txt"},
      {"fetch 5adh --again --url \"file://$PWD/data/moltact/molecules/5ADH.cif.gz\"",
       "data/moltact/molecules/5ADH.cif.gz"},
      {"m.pdb --screenshot m.pdb", "m.pdb"},
      {"m.pdb --state-text link.pdb", "m.pdb"}};
}

}  // namespace

TEST_CASE("no command writes onto a file that it reads, by its name, a link, a hard link or another path") {
  const Place place;
  REQUIRE(place.run("device record simulated 1ubq --seconds 0.2 --out r.recording").status == 0);
  for (const Case& c : inputs()) {
    CAPTURE(c.arguments);
    const std::string before = contents(place.folder / c.file);
    REQUIRE_FALSE(before.empty());
    const Run run = place.run(c.arguments, "export XDG_DATA_HOME=\"$PWD/data\";");
    CHECK(run.status == 1);
    CAPTURE(run.err);
    CHECK((run.err.find("; name another file") != std::string::npos));
    CHECK(contents(place.folder / c.file) == before);
  }
}

TEST_CASE("two outputs of a command never share a file, whether it is there, is not yet or is behind a dangling link") {
  const Place place;
  writeFile(place.folder / "there.csv", "older");
  for (const char* arguments :
       {"report a.jsonl --csv x.csv --html x.csv", "report a.jsonl --csv x.csv --gradebook sub/../x.csv",
        "report a.jsonl --csv there.csv --html ./there.csv",
        "report a.jsonl --csv dangling-link.csv --html dangling.csv",
        "bench feel --quick --methods penalty --json x.csv --markdown x.csv"}) {
    CAPTURE(arguments);
    const Run run = place.run(arguments);
    CHECK(run.status == 1);
    CHECK_MESSAGE(run.err.find("would be written to this one file; name a file of its own") != std::string::npos,
                  run.err);
    CHECK_FALSE(fs::exists(place.folder / "x.csv"));
    CHECK_FALSE(fs::exists(place.folder / "dangling.csv"));
    CHECK(contents(place.folder / "there.csv") == "older");
  }
}

TEST_CASE("outputs that are no ordinary files may be shared, and files that were not read may be replaced") {
  const Place place;
  CHECK(place.run("report a.jsonl --csv /dev/null --html /dev/null").status == 0);
  writeFile(place.folder / "old.csv", "older");
  CHECK(place.run("report a.jsonl --csv old.csv").status == 0);
  CHECK(contents(place.folder / "old.csv") != "older");
  CHECK(place.run("report results --csv a.jsonl").status == 0);  // an attempt, but not one of these
  CHECK(contents(place.folder / "a.jsonl").starts_with("\xEF\xBB\xBFstudent,"));
}

}  // namespace moltact::test
