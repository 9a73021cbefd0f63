// moltact check as authors and editors call it.
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "app/commands/source_excerpt.h"

using moltact::sourceExcerpt;

namespace {

namespace fs = std::filesystem;

struct Folder {
  fs::path path = fs::temp_directory_path() / ("moltact-check-command-" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path / name, std::ios::binary) << text;
  }
};

struct Run {
  int status = -1;
  std::string out;  ///< both streams together
};

/// Runs `moltact ARGUMENTS` in a folder.
Run runMoltact(const fs::path& folder, const std::string& arguments) {
  Run run;
  const std::string line = "cd '" + folder.string() +
                           "' && MOLTACT_HOME='" MOLTACT_SOURCE_DIR "' '" MOLTACT_BINARY "' " + arguments + " 2>&1";
  FILE* pipe = ::popen(line.c_str(), "r");
  REQUIRE(pipe);
  for (int c; (c = std::fgetc(pipe)) != EOF;) run.out += char(c);
  run.status = WEXITSTATUS(::pclose(pipe));
  return run;
}

const std::string kGood =
    "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: argon\nauthor: A\nlicence: L\n---\n"
    "## One\n```scene\nmolecule: argon\n```\nText.\n";

}  // namespace

TEST_CASE("a lesson with three faults gives each with its line and a caret, and exit status 1") {
  const Folder folder;
  folder.write("l.md", kGood + "```touch\nreech: all\n```\nÅ [on](#two)\n```touch\n\treach: protein\n\tsay: S\n```\n");
  const Run run = runMoltact(folder.path, "check l.md");
  CHECK(run.status == 1);
  CHECK(run.out ==
        "l.md:15:1: error: touch has no key 'reech'; did you mean 'reach'?\nreech: all\n^\n"
        "l.md:17:8: error: the link '#two' leads to no step; steps: one\nÅ [on](#two)\n       ^\n"
        "l.md:19:9: error: protein is not in argon; name atoms that it has\n\treach: protein\n\t       ^\n"
        "1 lesson checked: 3 errors\n");
}

TEST_CASE("a folder with a good lesson, one with a warning and a README passes, and says what it passed over") {
  const Folder folder;
  folder.write("a.md", kGood);
  folder.write("b.md", kGood + "```scenes\n```\n");
  folder.write("README.md", "# Lessons\n");
  const Run run = runMoltact(folder.path, "check .");
  CHECK(run.status == 0);
  CHECK(run.out ==
        "./a.md: note: the lesson has no teacher's kit; write what only you can know into ./kits/a.md; "
        "docs/teachers-kit.md tells how\n"
        "./a.md: 1 min for the core, 1 min with all steps\n"
        "./b.md:14:4: warning: 'scenes' is not a block of a lesson and is shown unchanged; did you mean "
        "'scene'?\n```scenes\n   ^\n"
        "./b.md: note: the lesson has no teacher's kit; write what only you can know into ./kits/b.md; "
        "docs/teachers-kit.md tells how\n"
        "./b.md: 1 min for the core, 1 min with all steps\n"
        "./README.md: no lesson, passed over\n2 lessons checked: no errors, 1 warning\n");
}

TEST_CASE(
    "of files that are named one by one, as a shell does for *.md, a glossary is checked as one and "
    "a README is passed over; another file without anything of a lesson is reported") {
  const Folder folder;
  folder.write("a.md", kGood);
  folder.write("glossary.md", "- **pit**: Three atoms at once.\n");
  folder.write("glossary.de.md", "- **Mulde**: Drei Atome zugleich.\n");
  folder.write("README.md", "# Lessons\n");
  const Run run = runMoltact(folder.path, "check *.md");
  CHECK(run.status == 0);
  CHECK(run.out ==
        "a.md: note: the lesson has no teacher's kit; write what only you can know into kits/a.md; "
        "docs/teachers-kit.md tells how\n"
        "a.md: 1 min for the core, 1 min with all steps\n"
        "README.md: no lesson, passed over\n1 lesson checked: no errors\n");
  CHECK(runMoltact(folder.path, "check glossary.md").out == "0 lessons checked: no errors\n");
  folder.write("glossary.md", "- **pit** Three atoms at once.\n");
  const Run wrong = runMoltact(folder.path, "check glossary.md");
  CHECK(wrong.status == 1);
  CHECK(wrong.out.starts_with("glossary.md:1:"));
  folder.write("notes.md", "# Notes\n");
  CHECK(runMoltact(folder.path, "check notes.md").status == 1);
}

TEST_CASE("--json prints one document with place, severity, message and remedy of each problem, and exits with 1") {
  const Folder folder;
  folder.write("l.md",
               kGood + "```touch\nreach: all\nsay: S\nnear: 4\n```\n### Question: Q?\n- [x] a\n- [ ] b → No.\n");
  const Run run = runMoltact(folder.path, "check l.md gone.md --json");
  CHECK(run.status == 1);
  const auto json = nlohmann::json::parse(run.out);
  CHECK(json["lessons"] == 1);
  CHECK(json["errors"] == 2);
  CHECK(json["warnings"] == 1);
  REQUIRE(json["problems"].size() == 3);
  CHECK(json["problems"][0] == nlohmann::json{{"file", "l.md"},
                                              {"line", 17},
                                              {"column", 7},
                                              {"severity", "error"},
                                              {"message", "'4' needs a unit: Å or nm"},
                                              {"remedy", ""}});
  CHECK(json["problems"][1]["severity"] == "warning");
  CHECK(json["problems"][1]["line"] == 20);
  CHECK(json["problems"][2]["file"] == "gone.md");
  CHECK(json["problems"][2]["line"] == 0);
}

TEST_CASE("a folder without lessons, a missing file and no argument at all end with a message") {
  const Folder folder;
  CHECK(runMoltact(folder.path, "check .").out ==
        ".: error: there is no lesson in this folder; name a folder with lessons, files that end in .md\n0 lessons "
        "checked: 1 error\n");
  CHECK(runMoltact(folder.path, "check gone.md").status == 1);
  CHECK(runMoltact(folder.path, "check").status == 2);
}

TEST_CASE("the caret is aligned after tabs, two-byte characters, wide characters and combining characters") {
  CHECK(sourceExcerpt("abc", 2) == "abc\n ^\n");
  CHECK(sourceExcerpt("abc", 4) == "abc\n   ^\n");
  CHECK(sourceExcerpt("abc", 99) == "abc\n   ^\n");
  CHECK(sourceExcerpt("", 1) == "\n^\n");
  CHECK(sourceExcerpt("\tÅ x", 4) == "\tÅ x\n\t  ^\n");
  CHECK(sourceExcerpt("分子x", 3) == "分子x\n    ^\n");
  CHECK(sourceExcerpt("A\xCC\x8Ax", 3) == "A\xCC\x8Ax\n ^\n");
  CHECK(sourceExcerpt("a\x1B[2Jx", 6) == "a?[2Jx\n     ^\n");
}

TEST_CASE("of a line of 300 letters, 96 round the caret are shown") {
  const std::string line = std::string(149, 'a') + "X" + std::string(150, 'b');
  CHECK(sourceExcerpt(line, 150) ==
        "…" + std::string(64, 'a') + "X" + std::string(31, 'b') + "…\n" + std::string(65, ' ') + "^\n");
  CHECK(sourceExcerpt(line, 1) == std::string(96, 'a') + "…\n^\n");
}

TEST_CASE("a new lesson is written once, passes the check, and is not overwritten") {
  const Folder folder;
  const Run made = runMoltact(folder.path, "new-lesson 'Haem pockets' --folder mine");
  CHECK(made.status == 0);
  CHECK(made.out.starts_with("mine/haem-pockets.md is written."));
  CHECK(runMoltact(folder.path, "check mine").out ==
        "mine/haem-pockets.md: note: the lesson has no teacher's kit; write what only you can know into "
        "mine/kits/haem-pockets.md; docs/teachers-kit.md tells how\n"
        "mine/haem-pockets.md: 2 min for the core, 2 min with all steps\n1 lesson checked: no errors\n");
  folder.write("mine/haem-pockets.md", "my work");
  const Run again = runMoltact(folder.path, "new-lesson haem-pockets --folder mine");
  CHECK(again.status == 1);
  CHECK(again.out == "moltact: mine/haem-pockets.md is there already and stays as it is; choose another name\n");
  CHECK(fs::file_size(folder.path / "mine/haem-pockets.md") == 7);
  CHECK(runMoltact(folder.path, "new-lesson ../x").status == 1);
  CHECK(runMoltact(folder.path, "new-lesson '?'").status == 1);
}

TEST_CASE("what a teacher's kit lacks is a note with its line, counts as no error, and stands in --json") {
  const Folder folder;
  folder.write("a.md", kGood);
  fs::create_directories(folder.path / "kits");
  folder.write("kits/a.md",
               "## Prior knowledge\n- A\n## What touch shows\n- B\n## Limits of the model\n- C\n## What to ask\n"
               "- [One](../a.md#one): Why? *So.*\n## Exit ticket\n### Question: Q?\n- [x] a\n- [ ] b\n");
  const Run run = runMoltact(folder.path, "check .");
  CHECK(run.status == 0);
  CHECK(run.out ==
        "./kits/a.md: note: the exit ticket has 1 question; write three below '## Exit ticket'\n"
        "./kits/a.md:12:7: note: this choice does not say which misconception it stands for; write → after it, and the "
        "misconception\n"
        "./a.md: 1 min for the core, 1 min with all steps\n1 lesson checked: no errors\n");
  const auto json = nlohmann::json::parse(runMoltact(folder.path, "check . --json").out);
  CHECK(json["errors"] == 0);
  CHECK(json["problems"].empty());
  REQUIRE(json["notes"].size() == 2);
  CHECK(json["notes"][1]["line"] == 12);
}
