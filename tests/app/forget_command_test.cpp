// `moltact forget` as a process, against the files of a home folder.
#include <doctest/doctest.h>

#include "tests/app/command_place.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;
using test::CommandPlace;
using test::Run;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string attemptOf(const std::string& student) {
  AttemptHeader header = sampleHeader();
  header.student = student;
  std::string out = lineOf(header);
  for (const AttemptEvent& e : sampleEvents()) out += lineOf(e);
  return out;
}

// A home with two attempts by Ada and one by Bo, in which nobody of another name is mentioned.
struct Home : CommandPlace {
  const fs::path attempts = folder / "share" / "moltact" / "attempts";
  Home() {
    fs::create_directories(attempts);
    writeFile(attempts / "1.jsonl", attemptOf("Ada"));
    writeFile(attempts / "2.jsonl", attemptOf("Ada"));
    writeFile(attempts / "3.jsonl", attemptOf("Cy"));
  }
  Run forget(const std::string& arguments) const {
    return run("forget " + arguments, "export XDG_DATA_HOME='" + (folder / "share").string() + "';");
  }
};

}  // namespace

TEST_CASE(
    "forget lists 2 attempts and deletes nothing; with --yes it deletes them, and a second time there is nothing") {
  const Home home;
  const Run listed = home.forget("Ada");
  CHECK(listed.status == 0);
  CHECK(has(listed.out, "attempts:\n  " + (home.attempts / "1.jsonl").string() + "\n  " +
                            (home.attempts / "2.jsonl").string() + "\n"));
  CHECK(has(listed.out, "Nothing is deleted yet"));
  CHECK(fs::exists(home.attempts / "1.jsonl"));
  const Run done = home.forget("Ada --yes");
  CHECK(done.status == 0);
  CHECK(done.err.empty());
  CHECK(has(done.out, "All of this is deleted."));
  CHECK_FALSE(fs::exists(home.attempts / "1.jsonl"));
  CHECK_FALSE(fs::exists(home.attempts / "2.jsonl"));
  CHECK(fs::exists(home.attempts / "3.jsonl"));
  const Run again = home.forget("Ada --yes");
  CHECK(again.status == 1);
  CHECK(has(again.err, "there is nothing of 'Ada' to delete"));
}

TEST_CASE("forget removes a guess from the attempts of others, and deletes a report that report itself has written") {
  const Home home;
  REQUIRE(home.run("report share --html class.html --csv class.csv --gradebook marks.csv").status == 0);
  REQUIRE(home.run("report share --anonymous --html codes.html").status == 0);
  const Run done = home.forget("Bo . --yes");  // Bo has only predicted, in all three attempts
  CHECK(done.status == 0);
  CHECK(has(done.out, "attempts of others, which lose this student's predictions:\n"));
  CHECK(has(done.out, "reports that name the student:\n  ./class.html\n"));
  CHECK_FALSE(fs::exists(home.folder / "class.html"));
  CHECK(fs::exists(home.folder / "marks.csv"));  // a row for each student with an attempt
  CHECK(fs::exists(home.folder / "codes.html"));
  for (const char* attempt : {"1.jsonl", "2.jsonl", "3.jsonl"})
    CHECK_FALSE(has(bytesOf(home.attempts / attempt), "\"Bo\""));
  CHECK(home.run("report share --csv after.csv").status == 0);
}

TEST_CASE("forget without a name, without results or with a name in other letters says what to do") {
  const Home home;
  CHECK(home.forget("").status == 2);
  CHECK(has(home.forget("' '").err, "name the student"));
  const Run alike = home.forget("ada");
  CHECK(alike.status == 1);
  CHECK(has(alike.err, "there are also attempts of 'Ada', which is another name"));
  CHECK(has(home.forget("Ada no-such-folder").err, "there is no such file or folder"));
  CHECK(has(home.run("forget Ada", "export XDG_DATA_HOME=/nowhere;").err, "there are no results on this computer"));
}

}  // namespace moltact
