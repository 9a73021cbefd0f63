// moltact kit as teachers call it: which file is written, in which language, with or without the answers.
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace {

namespace fs = std::filesystem;

struct KitFolder {
  fs::path path = fs::temp_directory_path() / ("moltact-kit-command-" + std::to_string(::getpid()));
  KitFolder() { fs::create_directories(path); }
  ~KitFolder() { fs::remove_all(path); }
  std::string text(const std::string& name) const {
    std::ifstream in(path / name, std::ios::binary);
    return {(std::istreambuf_iterator<char>(in)), {}};
  }
};

struct KitRun {
  int status = -1;
  std::string out;  ///< both streams together
};

KitRun runKit(const fs::path& folder, const std::string& arguments) {
  KitRun run;
  const std::string line = "cd '" + folder.string() +
                           "' && MOLTACT_HOME='" MOLTACT_SOURCE_DIR "' '" MOLTACT_BINARY "' kit " + arguments + " 2>&1";
  FILE* pipe = ::popen(line.c_str(), "r");
  REQUIRE(pipe);
  for (int c; (c = std::fgetc(pipe)) != EOF;) run.out += char(c);
  run.status = WEXITSTATUS(::pclose(pipe));
  return run;
}

bool pageHas(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

const std::string kKitLesson =
    "---\ntitle: T\ngoals: G\nmolecules: argon\nauthor: A\nlicence: L\n---\n## One\n```scene\nmolecule: argon\n```\n"
    "Text.\n";

}  // namespace

TEST_CASE("a lesson named by its name gives its kit in the language asked for, in a folder that is made") {
  const KitFolder folder;
  const KitRun english = runKit(folder.path, "first-touch");
  CHECK(english.status == 0);
  CHECK(english.out == "first-touch.kit.html is written\n");
  CHECK(pageHas(folder.text("first-touch.kit.html"), "<h2>Key to the exit ticket</h2>"));
  const KitRun german = runKit(folder.path, "first-touch --language de -o paper/here");
  CHECK(german.out == "paper/here/first-touch.de.kit.html ist geschrieben\n");
  const std::string page = folder.text("paper/here/first-touch.de.kit.html");
  CHECK(pageHas(page, "<html lang=\"de\">"));
  CHECK(pageHas(page, "<h2>Lösungen der Abschlusskarte</h2>"));
  CHECK(pageHas(page, "<h2>Vor dem Berühren</h2>"));
  CHECK_FALSE(pageHas(page, "Before you touch"));
}

TEST_CASE("a German file without --language gives a German page in every part, also on an English system") {
  const KitFolder folder;
  const KitRun run = runKit(folder.path, "'" MOLTACT_SOURCE_DIR "/lessons/left-or-right.de.md'");
  CHECK(run.status == 0);
  CHECK(pageHas(folder.text("left-or-right.de.kit.html"), "<h2>Lösungen der Abschlusskarte</h2>"));
}

TEST_CASE("--students writes a worksheet without the teacher's page") {
  const KitFolder folder;
  CHECK(runKit(folder.path, "first-touch --students").out == "first-touch.worksheet.html is written\n");
  const std::string page = folder.text("first-touch.worksheet.html");
  CHECK(pageHas(page, "Exit ticket"));
  CHECK_FALSE(pageHas(page, "Key to the exit ticket"));
  CHECK_FALSE(pageHas(page, "class=\"sheet teacher\""));
  CHECK_FALSE(pageHas(page, "<p class=\"right\""));
}

TEST_CASE("a folder gives a kit for each lesson, a lesson without a kit file the derived parts and a note") {
  const KitFolder folder;
  fs::create_directories(folder.path / "mine");
  for (const char* name : {"a", "b"}) std::ofstream(folder.path / "mine" / (std::string(name) + ".md")) << kKitLesson;
  const KitRun run = runKit(folder.path, "mine");
  CHECK(run.status == 0);
  CHECK(pageHas(run.out, "moltact: note: mine/a.md: the lesson has no teacher's kit"));
  CHECK(pageHas(run.out, "a.kit.html is written\n"));
  CHECK(pageHas(run.out, "b.kit.html is written\n"));
  CHECK(pageHas(folder.text("a.kit.html"), "<li>G</li>"));
  CHECK_FALSE(pageHas(folder.text("a.kit.html"), "class=\"ticket\""));
}

TEST_CASE("a lesson with errors, a missing file and a folder that cannot be made end with a message") {
  const KitFolder folder;
  std::ofstream(folder.path / "bad.md") << "---\ntitle: T\n---\nNothing.\n";
  const KitRun bad = runKit(folder.path, "bad.md");
  CHECK(bad.status == 1);
  CHECK(pageHas(bad.out, "bad.md has errors, so no kit was written"));
  CHECK(runKit(folder.path, "no-such-lesson").status == 1);
  CHECK(runKit(folder.path, "").status != 0);
  std::ofstream(folder.path / "file") << "x";
  const KitRun blocked = runKit(folder.path, "first-touch -o file/in");
  CHECK(blocked.status == 1);
  CHECK(pageHas(blocked.out, "choose another folder"));
}
