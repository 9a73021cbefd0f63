// Deleting one student from a folder of real files, and names taken out of texts.
#include "engine/results/forget_student.h"

#include <doctest/doctest.h>

#include <array>
#include <map>
#include <set>
#include <string>

#include "engine/platform/append_file.h"
#include "engine/results/anonymous_text.h"
#include "engine/results/attempt_file.h"
#include "engine/results/class_csv.h"
#include "engine/results/class_files.h"
#include "engine/results/class_page.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

// An attempt of `student`, in which `guesser` made a prediction and the last answer is `written`.
std::string fileOf(const std::string& student, const std::string& guesser = "Bo",
                   const std::string& written = "a bump") {
  AttemptHeader header = sampleHeader();
  header.student = student;
  std::string out = lineOf(header);
  for (AttemptEvent event : sampleEvents()) {
    if (auto* made = std::get_if<Predicted>(&event.what)) made->student = guesser;
    if (auto* answer = std::get_if<Answered>(&event.what); answer && !answer->written.empty()) {
      answer->written = written;
      answer->right = false;
    }
    out += lineOf(event);
  }
  return out;
}

std::set<std::string> filesBelow(const fs::path& folder) {
  std::set<std::string> out;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) out.insert(entry.path().lexically_relative(folder).generic_string());
  return out;
}

struct School {
  ScratchFolder scratch;
  School() {
    fs::create_directories(scratch.path / "monday" / "ada");
    write("monday/ada/1.jsonl", fileOf("Ada L"));
    write("monday/2.jsonl", fileOf("Ada L", "Cy"));
    write("monday/bo.jsonl", fileOf("Bo", "Ada L"));
    write("monday/cy.jsonl", fileOf("Cy", "Bo"));
    write("monday/adam.jsonl", fileOf("Adam Li", "Bo", "Ada Li is not ada."));
    write("monday/lower.jsonl", fileOf("ada l"));
    write("monday/told.jsonl", fileOf("Di", "Bo", "I asked ada l, who knew."));
    write("monday/nobody.jsonl", fileOf(""));
    write("monday/groove ada l.recording", "bytes");
    write("monday/groove adal.recording", "bytes");
    write("notes.txt", "Ada L was ill.");
    write("class.jsonl", "{\"student\":\"Ada L\"}\n");
    write("table.csv", "name,mark\r\nAda L,3\r\n");
    const std::array<fs::path, 1> all{scratch.path / "monday"};
    const ClassSummary named = readClass(all).summary, codes = readClass(all, {.anonymous = true}).summary;
    write("class.html", classPage(named, {}, "today"));
    write("class.csv", classCsv(named));
    write("marks.csv", gradebookCsv(named));
    write("codes.html", classPage(codes, {}, "today"));
    write("codes.csv", classCsv(codes));
  }
  void write(const std::string& name, const std::string& bytes) const { writeFile(scratch.path / name, bytes); }
  StudentTraces traces(const std::string& student) const {
    const std::array<fs::path, 1> all{scratch.path};
    return tracesOf(student, all);
  }
};

std::set<std::string> namesOf(const School& school, const std::vector<fs::path>& files) {
  std::set<std::string> out;
  for (const fs::path& file : files) out.insert(file.lexically_relative(school.scratch.path).generic_string());
  return out;
}

}  // namespace

TEST_CASE(
    "of 18 files in a folder and its subfolders, the 2 attempts, 1 recording and 3 reports of one student are found, 1 "
    "attempt with a prediction, and 4 texts to be looked at; alike names stay apart") {
  const School school;
  const StudentTraces found = school.traces("Ada L");
  CHECK(namesOf(school, found.attempts) == std::set<std::string>{"monday/2.jsonl", "monday/ada/1.jsonl"});
  REQUIRE(found.predictions.size() == 1);
  CHECK(found.predictions[0].file.filename() == "bo.jsonl");
  CHECK(found.predictions[0].lines == 1);
  CHECK(namesOf(school, found.recordings) == std::set<std::string>{"monday/groove ada l.recording"});
  CHECK(namesOf(school, found.reports) == std::set<std::string>{"class.csv", "class.html", "marks.csv"});
  CHECK(namesOf(school, found.others) ==
        std::set<std::string>{"class.jsonl", "monday/told.jsonl", "notes.txt", "table.csv"});
  CHECK(found.alike == std::vector<std::string>{"ada l"});
  CHECK(found.nameless == 1);
  CHECK(found.passed_over.empty());
  CHECK(school.traces("Nobody At All").empty());
  CHECK(school.traces("grid").reports.empty());  // a word of the page's style
}

TEST_CASE("forgetting deletes these files and one line, keeps every other byte, and finds nothing afterwards") {
  const School school;
  const std::set<std::string> before = filesBelow(school.scratch.path);
  const std::string bo = bytesOf(school.scratch.path / "monday" / "bo.jsonl"),
                    cy = bytesOf(school.scratch.path / "monday" / "cy.jsonl");
  CHECK(forgetStudent(school.traces("Ada L")).empty());
  std::set<std::string> left = before;
  for (const char* gone : {"monday/ada/1.jsonl", "monday/2.jsonl", "monday/groove ada l.recording", "class.csv",
                           "class.html", "marks.csv"})
    CHECK(left.erase(gone) == 1);
  CHECK(filesBelow(school.scratch.path) == left);
  CHECK(bytesOf(school.scratch.path / "monday" / "cy.jsonl") == cy);
  std::string expected = bo;
  const std::string line = lineOf(AttemptEvent{7.0, Predicted{"Ada L", "one", "What will you feel?", "a bump"}});
  REQUIRE(expected.find(line) != std::string::npos);
  expected.erase(expected.find(line), line.size());
  CHECK(bytesOf(school.scratch.path / "monday" / "bo.jsonl") == expected);
  CHECK(school.traces("Ada L").empty());
  const std::array<fs::path, 1> all{school.scratch.path / "monday"};
  for (const std::string& name : readClass(all).summary.people) CHECK(name != "Ada L");
}

TEST_CASE("an attempt that a running program writes stays and is named; the others of the student are deleted") {
  const School school;
  const fs::path open = school.scratch.path / "monday" / "2.jsonl";
  const StudentTraces traces = school.traces("Ada L");
  const Expected<AppendFile> writer = AppendFile::open(open, AppendFile::Begin::Continue);
  REQUIRE(bool(writer));
  const std::vector<Problem> faults = forgetStudent(traces);
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].text().find("2.jsonl") != std::string::npos);
  CHECK(fs::exists(open));
  CHECK_FALSE(fs::exists(school.scratch.path / "monday" / "ada" / "1.jsonl"));
}

TEST_CASE("a name is covered as a whole and by its words, in either case, but not within other words") {
  const NameCover cover({{"Ada Lovelace", "S01"}, {"Zoë", "S02"}, {"A", "S03"}, {"9b-02", "S04"}});
  CHECK(cover.covered("Ada Lovelace, ada and LOVELACE; Adam, Canada") == "S01, S01 and S01; Adam, Canada");
  CHECK(cover.covered("I asked Zoë. Zoëlle did not") == "I asked S02. Zoëlle did not");
  CHECK(cover.covered("A or B, 9b-02 said; 19b-025") == "S03 or B, S04 said; 19b-025");
  CHECK(cover.covered("").empty());
  CHECK(NameCover(std::map<std::string, std::string>{{"", "S01"}}).covered("nothing") == "nothing");
  CHECK(mentions("by ada l.", "Ada L"));
  CHECK_FALSE(mentions("by Ada Li", "Ada L"));
  CHECK_FALSE(mentions("text", ""));
  for (const char* number : {"2.5", "2,5 Å", "-3.0e2 kJ/mol", " 7 ", "50 %"}) CHECK(isMeasurement(number));
  for (const char* text : {"", "Å", "2 Tom", "Ada", "e", "3 of us"}) CHECK_FALSE(isMeasurement(text));
}

TEST_CASE(
    "without names, table and page have the day of 1 attempt but not its hour, no word of a typed text, and with typed "
    "texts the class's names replaced in them; right answers and numbers stay") {
  const ScratchFolder scratch;
  writeFile(scratch.path / "a.jsonl", fileOf("Quintus Name", "Bo", "Bo told me: Quintus, a bump"));
  writeFile(scratch.path / "b.jsonl", fileOf("Bo", "Quintus Name", "3.5 Å"));
  const std::array<fs::path, 1> all{scratch.path};
  const ClassSummary without = readClass(all, {.anonymous = true}).summary,
                     texts = readClass(all, {.anonymous = true, .typed_texts = true}).summary,
                     words = readClass(all, {.typed_texts = true, .code_word = "w"}).summary;
  for (const ClassSummary* summary : {&without, &texts, &words})
    for (const std::string& text : {classCsv(*summary), classPage(*summary, {}, "today")}) {
      CHECK_FALSE(mentions(text, "Quintus"));
      CHECK_FALSE(mentions(text, "Bo"));
      CHECK(text.find("10:58") == std::string::npos);
      CHECK(text.find("3.5 Å") != std::string::npos);
    }
  const std::string table = classCsv(without);
  CHECK(table.find(",2026-11-21,") != std::string::npos);
  CHECK(table.find("told me") == std::string::npos);
  CHECK(table.find("(6 words left out)") != std::string::npos);
  CHECK(classCsv(texts).find("S02 told me: S01, a bump") != std::string::npos);
  // The same file with names says all of it.
  CHECK(classCsv(readClass(all).summary).find("Bo told me: Quintus, a bump") != std::string::npos);
}

}  // namespace moltact
