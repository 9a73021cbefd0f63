// Oracles: manual sums over a class, a CSV reader that shares no code with the writer, and the page's own text.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <regex>
#include <set>

#include "engine/language/units.h"
#include "engine/results/attempt_lines.h"
#include "engine/results/class_csv.h"
#include "engine/results/class_page.h"
#include "tests/results/sample_attempt.h"
#include "tests/results/synthetic_class.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

// RFC 4180, strictly: quotes only around a whole cell, CR LF after each row.
std::vector<std::vector<std::string>> readCsv(const std::string& text) {
  REQUIRE(text.starts_with("\xEF\xBB\xBF"));
  std::vector<std::vector<std::string>> rows;
  std::size_t at = 3;
  while (at < text.size()) {
    rows.emplace_back();
    for (;;) {
      std::string cell;
      if (text[at] == '"') {
        for (++at; !(text[at] == '"' && text[at + 1] != '"'); ++at) {
          if (text[at] == '"') ++at;
          cell += text[at];
        }
        ++at;
      } else {
        while (text[at] != ',' && text[at] != '\r') {
          REQUIRE(text[at] != '"');
          REQUIRE(text[at] != '\n');
          cell += text[at++];
        }
      }
      rows.back().push_back(cell);
      if (text[at++] == ',') continue;
      REQUIRE(text[at++] == '\n');
      break;
    }
  }
  return rows;
}

std::string cell(const std::vector<std::vector<std::string>>& rows, std::size_t row, const std::string& column) {
  for (std::size_t k = 0; k < rows[0].size(); ++k)
    if (rows[0][k] == column) return rows[row][k];
  FAIL("no column " << column);
  return {};
}

Attempt sampleAttempt() {
  Attempt a;
  a.header = sampleHeader();
  a.events = sampleEvents();
  return a;
}

/// An attempt at a lesson that asks a task before and after, with d' in the first round of each; NaN: not done.
Attempt askedTwice(const std::string& student, double before, double after, const std::string& file = "twice.md") {
  Attempt a;
  a.header.began = "2026-11-21T10:58:14Z";
  a.header.student = student;
  a.header.lesson = {file,
                     "Twice",
                     "0123456789abcdef",
                     {{"one", "One", {{"same", "Feel."}}, {}}, {"two", "Two", {{"same", "Feel."}}, {}}}};
  a.header.lesson.steps[0].tasks[0].asked = "before";
  a.header.lesson.steps[1].tasks[0].asked = "after";
  const auto done = [&](const char* step, double d, double t_s, bool solved) {
    if (std::isnan(d)) return;
    a.events.push_back(
        {t_s, TaskDone{step, 0, 1.0, InputKind::Mouse, {{"d'", 9.0, ""}, {"d' in the first round", d, ""}}, solved}});
  };
  done("one", before, 1.0, true);
  done("two", after, 2.0, false);       // its tries were used up: the first round counts all the same
  done("two", after + 1.0, 3.0, true);  // begun again and solved: it counts no more
  return a;
}

TEST_CASE(
    "the gain in d' is after less before, of each student and in the mean of those who did both, in page and table") {
  // Of 4 pairs that differed 2 hits, of 4 alike 2 false alarms: guessing. Then 4 hits and no false alarm: 2 z(0.9).
  const double guessing = 0.0, perfect = 2.0 * 1.2815515655446004;
  const std::vector<Attempt> attempts{askedTwice("A", guessing, perfect), askedTwice("B", guessing, guessing),
                                      askedTwice("C", perfect, std::nan(""))};
  const ClassSummary summary = summarise(attempts);
  REQUIRE(summary.lessons.size() == 1);
  const LessonSummary& lesson = summary.lessons[0];
  CHECK(asksTwice(lesson.lesson));
  const auto of = [&](std::size_t k) { return sensitivityPair(lesson.lesson, lesson.people[k]); };
  CHECK(*of(0).gain() == doctest::Approx(2.5631031310892007).epsilon(1e-12));
  CHECK(*of(1).gain() == 0.0);
  CHECK(of(2).before);
  CHECK_FALSE(of(2).gain());
  const auto rows = readCsv(classCsv(summary));
  CHECK(cell(rows, 1, "twice.md#d_prime before") == "0.000");
  CHECK(cell(rows, 1, "twice.md#d_prime after") == "2.563");
  CHECK(cell(rows, 1, "twice.md#d_prime gain") == "2.563");
  CHECK(cell(rows, 3, "twice.md#d_prime after") == "");
  CHECK(cell(rows, 3, "twice.md#d_prime gain") == "");
  // The mean of 2.563 and 0 is 1.28; both are 1.28 from it, so the standard deviation is 1.81 and its error 1.28. With one
  // degree of freedom Student's t is 12.71, so the interval of two students is wider than d' itself.
  const std::string page = classPage(summary, {}, "now");
  CHECK(page.find("1.28 ± 16.28") != std::string::npos);
  CHECK(page.find("Mean of 2") != std::string::npos);
  CHECK(classPage(summarise({sampleAttempt()}), {}, "now").find("Told apart in the dark") == std::string::npos);
}

TEST_CASE("a task says in an attempt's file whether it is asked before or after") {
  const Attempt a = askedTwice("A", 0.0, 1.0);
  const Expected<AttemptHeader> read = readHeaderLine(lineOf(a.header));
  REQUIRE(read);
  CHECK(read->lesson.steps[0].tasks[0].asked == "before");
  CHECK(read->lesson.steps[1].tasks[0].asked == "after");
  CHECK(lineOf(sampleHeader()).find("asked") == std::string::npos);
}

TEST_CASE("attempts at a lesson that was parted into two are read and reported as that lesson, beside the new ones") {
  // Its first line as the program wrote it when the lesson was one.
  const std::string line =
      R"({"kind":"attempt","format":1,"program":"0.1.0","began":"2026-11-01T08:00:00Z","student":"A","device":"Mouse",)"
      R"("gives_force":false,"lesson":{"file":"haemoglobin-and-haem.md","title":"Haemoglobin and haem","hash":"0011223344556677",)"
      R"("goals":["Find the chains"],"steps":[{"id":"four-chains","title":"Four chains","tasks":[{"kind":"cross","say":"Slide.",)"
      R"("goals":[0]}]},{"id":"the-first-one-is-the-hardest","title":"The first one is the hardest","questions":[{"id":"how-many-more",)"
      R"("text":"How many more?"}]},{"id":"aside-what-acid-does","title":"What acid does","aside":true}]}})"
      "\n";
  const Expected<AttemptHeader> header = readHeaderLine(line);
  REQUIRE(header);
  Attempt old;
  old.header = *header;
  old.events.push_back({1.0, TaskDone{"four-chains", 0, 1.0, InputKind::Mouse, {}, true}});
  old.events.push_back({2.0, Answered{"the-first-one-is-the-hardest", "how-many-more", 1, {}, "36", true}});
  Attempt now = old;
  now.header.lesson.file = "four-chains-as-one.md";
  now.header.lesson.title = "Four chains that work as one";
  now.header.lesson.steps.resize(1);
  now.events.resize(1);
  const ClassSummary summary = summarise({old, now});
  REQUIRE(summary.lessons.size() == 2);
  const LessonSummary& parted = summary.lessons[1];
  CHECK(parted.lesson.title == "Haemoglobin and haem");
  REQUIRE(parted.people.size() == 1);
  CHECK(parted.people[0].answered() == 1);
  CHECK(goalScore(parted.lesson, parted.people[0], 0).done == 1);
  CHECK(classPage(summary, {}, "now").find("How many more?") != std::string::npos);
}

TEST_CASE("one student's attempt of 9.5 s gives its figures, cell by cell") {
  const ClassSummary summary = summarise({sampleAttempt()});
  const auto rows = readCsv(classCsv(summary));
  REQUIRE(rows.size() == 2);
  CHECK(rows[1].size() == rows[0].size());
  CHECK(cell(rows, 1, "student") == "A. \"Quote\", Ünlü\n'=1+1");
  CHECK(cell(rows, 1, "done_percent") == "100.0");
  CHECK(cell(rows, 1, "finished") == "yes");
  CHECK(cell(rows, 1, "minutes") == "0.16");
  CHECK(cell(rows, 1, "answered") == "2");
  CHECK(cell(rows, 1, "right_at_first_try") == "1");
  CHECK(cell(rows, 1, "hints") == "1");
  CHECK(cell(rows, 1, "touches") == "1");
  CHECK(cell(rows, 1, "touch_s") == "0.1");
  CHECK(cell(rows, 1, "peak_force_N") == "1.250");
  CHECK(cell(rows, 1, "mean_force_N") == "0.750");
  CHECK(cell(rows, 1, "path_A") == "6.25");
  CHECK(cell(rows, 1, "input") == "keyboard");
  CHECK(cell(rows, 1, "keyboard_percent") == "100.0");
  CHECK(cell(rows, 1, "first-touch.md#one minutes") == "0.13");  // from 0 s to 8 s
  CHECK(cell(rows, 1, "first-touch.md#two minutes") == "0.03");  // from 8 s to 9.5 s
  CHECK(cell(rows, 1, "first-touch.md#one/which first answer") == "this");
  CHECK(cell(rows, 1, "first-touch.md#one/which tries") == "2");
  CHECK(cell(rows, 1, "first-touch.md#two/how-much first answer") == "2.5 Å");
  CHECK(cell(rows, 1, "first-touch.md#one/task 1 s") == "3.2");
  CHECK(cell(rows, 1, "first-touch.md#one/task 1 input") == "device");
  CHECK(cell(rows, 1, "first-touch.md#one/which solved") == "yes");
  CHECK(cell(rows, 1, "first-touch.md#one/task 1 solved") == "yes");
}

TEST_CASE("every figure of a task has its column, empty for who did not do it") {
  Attempt a = sampleAttempt(), b = sampleAttempt();
  b.header.student = "Bo";
  std::erase_if(b.events, [](const AttemptEvent& e) { return std::holds_alternative<TaskDone>(e.what); });
  const auto rows = readCsv(classCsv(summarise({a, b})));
  REQUIRE(rows.size() == 3);
  const TaskDone* done = nullptr;
  for (const AttemptEvent& e : a.events)
    if (const auto* task = std::get_if<TaskDone>(&e.what)) done = task;
  REQUIRE(done);
  REQUIRE_FALSE(done->figures.empty());
  for (const LoggedFigure& f : done->figures) {
    const std::string column = "first-touch.md#one/task 1 " + f.name + (f.unit.empty() ? "" : " " + f.unit);
    CAPTURE(column);
    CHECK(std::stod(cell(rows, 1, column)) == doctest::Approx(f.value).epsilon(0.001));
    CHECK(cell(rows, 2, column).empty());
  }
}

TEST_CASE("4 attempts without a name are 4 attempts and no students; beside 1 named one they are distinguished") {
  std::vector<Attempt> attempts(4, sampleAttempt());
  for (std::size_t k = 0; k < attempts.size(); ++k) {
    attempts[k].header.student.clear();
    attempts[k].header.lesson.file = "lesson-" + std::to_string(k) + ".md";
  }
  CHECK(summaryText(summarise(attempts)) == "4 lessons, 4 attempts, all without a name");
  CHECK(summaryText(summarise(attempts, {.anonymous = true})) == "4 lessons, 4 attempts, all without a name");
  attempts.push_back(sampleAttempt());
  CHECK(summaryText(summarise(attempts)) == "1 student, 5 lessons, 5 attempts, 4 of them without a name");
  CHECK(summaryText(summarise({sampleAttempt()})) == "1 student, 1 lesson, 1 attempt");
}

TEST_CASE("an attempt's beginning is read from its first line alone, whatever else the line holds") {
  CHECK(beginTimeOf(R"({"kind":"attempt","began":"2026-11-21T10:58:14Z","lesson":)") == "2026-11-21T10:58:14Z");
  CHECK(beginTimeOf(R"({"lesson":{"began":"x"},"student":"\"began\":\"y\"", "began" : "z"})") == "z");
  CHECK(beginTimeOf(R"({"began":7})").empty());
  CHECK(beginTimeOf("[\"began\",\"x\"]").empty());
  CHECK(beginTimeOf("").empty());
}

TEST_CASE("two lessons of one file name and different titles stay two, with columns of their own") {
  Attempt a = sampleAttempt(), b = sampleAttempt();
  b.header.lesson.title = "Another";
  const ClassSummary summary = summarise({a, b});
  REQUIRE(summary.lessons.size() == 2);
  CHECK(summary.lessons[0].name == "first-touch.md (Another)");
  const auto rows = readCsv(classCsv(summary));
  REQUIRE(rows.size() == 3);
  CHECK(std::set<std::string>(rows[0].begin(), rows[0].end()).size() == rows[0].size());
}

TEST_CASE("codes computed from a word do not depend on the other students, and differ for another word") {
  Attempt a = sampleAttempt(), b = sampleAttempt();
  a.header.student = "Ada";
  b.header.student = "Bo";
  const auto codes = [](std::vector<Attempt> attempts, const char* word) {
    return summarise(std::move(attempts), {.code_word = word}).people;
  };
  const std::string alone = codes({b}, "winter").at(0);
  CHECK(alone.size() == 7);
  const auto both = codes({a, b}, "winter");
  CHECK(std::find(both.begin(), both.end(), alone) != both.end());
  CHECK(both[0] != both[1]);
  CHECK(codes({b}, "summer").at(0) != alone);
  CHECK(alone.find("Bo") == std::string::npos);
}

TEST_CASE("the gradebook has a row for each named student, marks of 100, and no cell that a spreadsheet computes") {
  Attempt a = sampleAttempt(), nobody = sampleAttempt();
  a.header.student = "=Ada";
  nobody.header.student.clear();
  const auto rows = readCsv(gradebookCsv(summarise({a, nobody})));
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].size() == 3);
  CHECK(rows[1] == std::vector<std::string>{"'=Ada", "100.0", "50.0"});
}

TEST_CASE(
    "a question that separates 4 good from 3 weak students completely has r of 1, one that all "
    "answer rightly has none") {
  std::vector<Attempt> attempts;
  for (int k = 0; k < 7; ++k) {
    Attempt a = sampleAttempt();
    a.header.student = "S" + std::to_string(k);
    a.events.clear();
    const bool good = k < 4;
    a.events.push_back({1.0, Answered{"one", "which", 1, {good ? 0u : 1u}, "", good}});
    a.events.push_back({2.0, Answered{"two", "how-much", 1, {}, "x", good}});
    attempts.push_back(std::move(a));
  }
  const LessonSummary lesson = summarise(attempts).lessons.at(0);
  REQUIRE(discrimination(lesson, "one", "which"));
  CHECK(*discrimination(lesson, "one", "which") == doctest::Approx(1.0));
  attempts.resize(4);
  CHECK_FALSE(discrimination(summarise(attempts).lessons.at(0), "one", "which"));
}

TEST_CASE("the page shows the first curve that a student drew beside the one felt in the end") {
  Attempt again = sampleAttempt();
  again.events.push_back({9.6, CurveKept{"one", 0, false, "depth", 0.8, 3.3, {3.3, 3.3, 3.3}}});
  const ClassSummary summary = summarise({again});
  const TaskScore& score = summary.lessons[0].people[0].tasks.at({"one", 0});
  REQUIRE((score.done && score.drawn && score.felt));
  CHECK(score.drawn->force_N[1] == 1.5);
  CHECK(score.felt->force_N[1] == 1.25);
  const std::string page = classPage(summary, {}, "");
  CHECK(page.find("<path class=\"felt\" d=\"M24 90L107 58.2L190 26.4\"/>") != std::string::npos);
  CHECK(page.find("<path class=\"drawn\" d=\"M24 90L107 51.8L190 13.6\"/>") != std::string::npos);
}

TEST_CASE("the page shows a curve that was felt without being drawn, and the energies of a task in kcal/mol") {
  Attempt pulled = sampleAttempt();
  std::erase_if(pulled.events, [](const AttemptEvent& e) {
    const auto* curve = std::get_if<CurveKept>(&e.what);
    return curve && !curve->felt;
  });
  for (AttemptEvent& e : pulled.events)
    if (auto* done = std::get_if<TaskDone>(&e.what)) done->figures.push_back({"lowest energy", -26.5, "kcal/mol"});
  const std::string page = classPage(summarise({pulled}), {}, "");
  CHECK(page.find("<path class=\"felt\" d=\"M24 90L107 58.2L190 26.4\"/>") != std::string::npos);
  CHECK(page.find("<path class=\"drawn\"") == std::string::npos);
  CHECK(page.find("Force as felt.") != std::string::npos);
  CHECK(page.find("lowest energy, kcal/mol") != std::string::npos);
}

TEST_CASE(
    "with nm and mN chosen the page has no other unit of length and force: 6.25 Å are 0.6 nm, 1.25 N are 1250 mN") {
  Attempt again = sampleAttempt();
  again.events.push_back({9.6, CurveKept{"one", 0, false, "depth", 0.8, 3.3, {3.3, 3.3, 3.3}}});
  const ClassSummary summary = summarise({again});
  const std::string before = classPage(summary, {}, "");
  CHECK(before.find("<th>Path,<br>Å</th>") != std::string::npos);
  CHECK(before.find("<td>1.25</td><td>0.75</td><td>6</td></tr>") != std::string::npos);
  UnitSet set;
  REQUIRE(set.choose(Dimension::Length, "nm"));
  REQUIRE(set.choose(Dimension::Force, "mN"));
  setShownUnits(set);
  std::string page = classPage(summary, {}, "");
  setShownUnits({});
  CHECK(page.find("<th>Path,<br>nm</th>") != std::string::npos);
  CHECK(page.find("<td>1250</td><td>750</td><td>0.6</td>") != std::string::npos);
  CHECK(page.find("mN against depth") != std::string::npos);
  // What the student wrote stays as it was written.
  for (std::size_t at; (at = page.find("2.5 Å")) != std::string::npos;) page.erase(at, std::string("2.5 Å").size());
  CHECK(page.find("Å") == std::string::npos);
  CHECK_FALSE(std::regex_search(page, std::regex("[>, \u00a0]N[<, ]")));
}

TEST_CASE("a second attempt adds its time, keeps the first answers and never lowers the progress") {
  Attempt second = sampleAttempt();
  second.header.began = "2026-11-22T08:00:00Z";
  second.events = {{0.0, StepEntered{"one"}},
                   {4.0, Answered{"one", "which", 1, {1}, "", true, InputKind::Device}},
                   {10.5, ProgressMade{"one", 1, 3}}};
  const ClassSummary summary = summarise({second, sampleAttempt()});
  REQUIRE(summary.lessons.size() == 1);
  REQUIRE(summary.lessons[0].people.size() == 1);
  const PersonScore& p = summary.lessons[0].people[0];
  CHECK(p.attempts == 2);
  CHECK(p.time_s == doctest::Approx(20.0));
  CHECK(p.finished());
  CHECK(p.began == "2026-11-21T10:58:14Z");
  CHECK_FALSE(p.answers.at({"one", "which"}).first_right);
  CHECK(p.last_step == "One");
}

std::string cellOf(const std::string& name) {
  Attempt a = sampleAttempt();
  a.header.student = name;
  return cell(readCsv(classCsv(summarise({a}))), 1, "student");
}

TEST_CASE("cells that a spreadsheet would compute are defused: = + - @ tab and line ends") {
  for (const std::string name : {"=1+1", "+1", "-1", "@SUM(A1)", "\tx", "\nx", "=cmd|' /C calc'!A0"})
    CHECK(cellOf(name) == "'" + name);
  CHECK(cellOf("\rx") == "'\xEF\xBF\xBDx");
}

// What a spreadsheet may do before it looks for a formula, in its rudest form: cut off all that cannot be seen, fold
// what is wide or small, and part by the signs that other countries use.
bool mightCompute(std::string text) {
  const auto replaceAll = [&](const std::string& a, const std::string& b) {
    for (std::size_t at = 0; (at = text.find(a, at)) != std::string::npos; at += b.size())
      text.replace(at, a.size(), b);
  };
  for (const char* sign : {"\uFF1D", "\uFE66"}) replaceAll(sign, "=");
  for (const char* sign : {"\uFF0B", "\uFE62"}) replaceAll(sign, "+");
  for (const char* sign : {"\uFF0D", "\uFE63"}) replaceAll(sign, "-");
  for (const char* sign : {"\uFF20", "\uFE6B"}) replaceAll(sign, "@");
  for (const char* none :
       {"\u00A0", "\u00AD", "\u1680", "\u180E", "\u2000", "\u2003", "\u2007", "\u2009", "\u200B", "\u200E", "\u200F",
        "\u2028", "\u202F", "\u205F", "\u2060", "\u3000", "\uFEFF", "\uFFFD", " "})
    replaceAll(none, "");
  std::erase(text, '\0');
  bool begin = true;
  for (const char c : text) {
    if (begin && std::string_view("=+-@").find(c) != std::string_view::npos) return true;
    begin = c == ';' || c == '\t' || c == '\n' || c == '\r';
  }
  return false;
}

TEST_CASE(
    "no blank, invisible or control sign before a formula, no wide or small form of its sign, and no other separator "
    "gets it computed") {
  int tried = 0;
  for (const std::string before :
       {"",       " ",      "  ",     "\t",     "\n",     "\r",     "\r\n",   "\v",     "\x1f",
        "\x7f",   "\u00A0", "\u00AD", "\u0085", "\u1680", "\u180E", "\u2003", "\u200B", "\u200E",
        "\u2028", "\u202E", "\u2066", "\u3000", "\uFEFF", "a;",     "a; ",    "a\t",    "a\n\u00A0"})
    for (const std::string sign :
         {"=", "+", "-", "@", "\uFF1D", "\uFF0B", "\uFF0D", "\uFF20", "\uFE66", "\uFE62", "\uFE63", "\uFE6B"}) {
      CAPTURE(before);
      CAPTURE(sign);
      CHECK_FALSE(mightCompute(cellOf(before + sign + "1+1")));
      ++tried;
    }
  CHECK_FALSE(mightCompute(cellOf(std::string("\0=1", 3))));
  CHECK_FALSE(mightCompute(cellOf(std::string(" \0 \0\u00A0=1", 9))));
  CHECK(tried == 27 * 12);
  CHECK(cellOf("a-b = c + d @ home; 5") == "a-b = c + d @ home; 5");
}

TEST_CASE("quoted text is otherwise unchanged") {
  Attempt a = sampleAttempt();
  a.header.student = "a;b \"c\", d\ne";
  CHECK(cell(readCsv(classCsv(summarise({a}))), 1, "student") == "a;b \"c\", d\ne");
}

TEST_CASE("the page shows what students wrote as text: no tag, attribute or script of theirs comes through") {
  Attempt a = sampleAttempt();
  a.header.student = "<script>alert(1)</script>\" onload='x";
  a.header.lesson.title = "<b>&amp;";
  for (AttemptEvent& e : a.events)
    if (auto* answer = std::get_if<Answered>(&e.what); answer && !answer->written.empty())
      answer->written = "</div><img onerror=y>";
  const std::string page = classPage(summarise({a}), {{"<i>.jsonl", 3, 0, "<u>", ""}}, "today");
  for (const char* bad : {"<script", "<img", "<b>&amp;<", "onload='", "<i>", "<u>"})
    CHECK_MESSAGE(page.find(bad) == std::string::npos, bad);
  CHECK(page.find("&lt;script&gt;alert(1)&lt;/script&gt;&quot; onload=&#39;x") != std::string::npos);
  // Nothing is loaded from elsewhere.
  for (const char* outside : {"http:", "https:", "src=", "@import", "url(//", "<link"})
    CHECK_MESSAGE(page.find(outside) == std::string::npos, outside);
}

TEST_CASE("with codes in the place of names no name stands in table or page, predictions included") {
  Attempt a = sampleAttempt(), b = sampleAttempt();
  a.header.student = "Visible Name";
  b.header.student = "Bo";
  const ClassSummary summary = summarise({a, b}, {.anonymous = true});
  for (const std::string& text : {classCsv(summary), classPage(summary, {}, "today")}) {
    CHECK(text.find("Visible") == std::string::npos);
    CHECK(text.find("S02") != std::string::npos);
    CHECK(text.find(">Bo<") == std::string::npos);
  }
}

TEST_CASE("a class of 24 attempts by 18 students, written by the real log, is counted whole") {
  const ScratchFolder scratch;
  const char* kept =
      std::getenv("MOLTACT_CLASS_REPORT");  // a folder to leave the class and its report in, to be looked at
  const fs::path folder = kept ? fs::path(kept) : scratch.path;
  writeSyntheticClass(folder / "attempts", 7);
  std::vector<Attempt> attempts;
  const auto files = attemptFiles(folder / "attempts");
  REQUIRE(bool(files));
  for (const fs::path& file : *files) attempts.push_back(*readAttempt(file, ReadDepth::NoHipSamples));
  REQUIRE(attempts.size() == 24);
  const ClassSummary summary = summarise(attempts);
  CHECK(summary.people.size() == 18);
  REQUIRE(summary.lessons.size() == 2);
  CHECK(summary.lessons[0].people.size() == 18);
  CHECK(summary.lessons[1].people.size() == 5);
  double time_s = 0, expected_s = 0;
  for (const Attempt& a : attempts) expected_s += a.end_s();
  for (const LessonSummary& l : summary.lessons)
    for (const PersonScore& p : l.people) time_s += p.time_s;
  CHECK(time_s == doctest::Approx(expected_s));
  const auto rows = readCsv(classCsv(summary));
  CHECK(rows.size() == 24);  // a head, and 23 pairs of a person and a lesson
  for (const auto& row : rows) REQUIRE(row.size() == rows[0].size());
  CHECK(std::set<std::string>(rows[0].begin(), rows[0].end()).size() == rows[0].size());
  const std::string page = classPage(summary, {}, "2026-11-21 12:00 UTC");
  CHECK(page.find("nan") == std::string::npos);
  CHECK(page.find("inf\"") == std::string::npos);
  if (kept) {
    writeFile(folder / "class.csv", classCsv(summary));
    writeFile(folder / "class.html", page);
  }
}

TEST_CASE("no attempts, and an attempt without any event, give a whole table and page") {
  CHECK(readCsv(classCsv({})).size() == 1);
  CHECK(classPage({}, {}, "now").ends_with("</html>\n"));
  Attempt bare = sampleAttempt();
  bare.events.clear();
  bare.header.student.clear();
  bare.header.lesson.steps.clear();
  const ClassSummary summary = summarise({bare, bare});
  CHECK(summary.people == std::vector<std::string>{"(no name, 21 Nov 10:58)", "(no name, 21 Nov 10:58) #2"});
  CHECK(readCsv(classCsv(summary)).size() == 3);
  CHECK(classPage(summary, {}, "now").find("nan") == std::string::npos);
}

}  // namespace
}  // namespace moltact
