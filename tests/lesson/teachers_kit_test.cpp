// The teacher's kit: its file's format, the kits of all shipped lessons, the time line, and what students get of it.
#include "engine/lesson/teachers_kit.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "engine/language/catalogue.h"
#include "engine/lesson/class_plan.h"
#include "engine/lesson/glossary.h"
#include "engine/lesson/kit_page.h"
#include "engine/lesson/kit_parts.h"
#include "engine/lesson/lesson_files.h"
#include "engine/lesson/minutes.h"
#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using namespace moltact::test;

namespace {

namespace fs = std::filesystem;

/// The names of the lessons in lessons/, in alphabetical order, without the translations.
const std::vector<std::string>& lessonNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> out;
    for (const auto& entry : fs::directory_iterator(fs::path(MOLTACT_SOURCE_DIR) / "lessons"))
      if (looksLikeLesson(entry.path()) && lessonName(entry.path()).language.empty())
        out.push_back(entry.path().stem().string());
    std::sort(out.begin(), out.end());
    return out;
  }();
  return names;
}

struct Shipped {
  fs::path file;
  Lesson lesson;
  TeachersKit kit;
};

const std::vector<Shipped>& shipped() {
  static const std::vector<Shipped> all = [] {
    std::vector<Shipped> out;
    for (const std::string& name : lessonNames())
      for (const char* language : {"", ".de"}) {
        const fs::path file = fs::path(MOLTACT_SOURCE_DIR) / "lessons" / (name + language + ".md");
        LessonReading read = readLesson(file);
        REQUIRE_MESSAGE(read.lesson, file.string());
        linkWords(*read.lesson, glossaryBeside(file, read.lesson->language));
        out.push_back({file, *std::move(read.lesson), kitOf(file)});
      }
    return out;
  }();
  return all;
}

bool has(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

std::size_t count(const std::string& text, std::string_view part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++n;
  return n;
}

/// The texts that a lesson keeps from a student until they are earned: feedback, tags, praise, model answers, accepted
/// answers of several letters, hints and teacher's notes.
struct KeptBack {
  std::string text;
  bool choice = false, tag = false;
};
std::vector<KeptBack> keptBack(const Lesson& lesson) {
  std::vector<KeptBack> out;
  for (const Step& step : lesson.steps) {
    for (const Question& q : step.questions) {
      for (const Choice& c : q.choices) {
        out.push_back({kit::html(c.feedback)});
        out.push_back({c.tag, false, true});
        if (!q.prediction) out.push_back({kit::html(c.text), true});
      }
      if (q.answer) {
        out.push_back({q.answer->model});
        for (const std::string& text : q.answer->texts)
          if (text.size() > 3) out.push_back({text});
      }
    }
    for (const TaskSpec& task : step.tasks) out.push_back({task.values["praise"].text});
    for (const Block& b : step.blocks) {
      if (const auto* tip = std::get_if<Tip>(&b))
        for (const RichText& p : tip->paragraphs) out.push_back({kit::html(p)});
      if (const auto* note = std::get_if<TeacherNote>(&b))
        for (const RichText& p : note->paragraphs) out.push_back({kit::html(p)});
    }
  }
  // A single word such as "Yes" or "Two" can stand anywhere.
  std::erase_if(out, [](const KeptBack& kept) { return kept.text.size() < 12; });
  return out;
}

constexpr std::string_view kGoodKit =
    "# Teacher's kit\n## Prior knowledge\n- Atoms.\n## What touch shows\n- Depth.\n## Limits of the model\n- Rigid.\n"
    "## What to ask\n- [One](../l.md#one): Why *so?* \n- [One](../l.md#one): Why? *Because of it.*\n"
    "## Exit ticket\n### Question: A *b*?\n- [x] yes\n- [ ] no → no idea\n### Question: B?\n- [ ] no → none\n- [x] "
    "yes\n"
    "### Question: C?\n- [ ] no → none\n- [x] yes\n";

Lesson smallLesson(const std::string& body = "") {
  const LessonReading read = readLessonText(
      "l.md",
      "---\ntitle: T\ngoals: G\nmolecules: argon\nauthor: A\nlicence: L\n---\nWhy?\n## One\n```scene\nmolecule: argon\n"
      "```\nText.\n" +
          body);
  for (const Problem& p : read.errors) MESSAGE(p.text());
  REQUIRE(read.lesson);
  return *read.lesson;
}

}  // namespace

TEST_CASE("each shipped lesson has a complete kit in English and in German") {
  CHECK(lessonNames().size() >= 16);
  CHECK(shipped().size() == 2 * lessonNames().size());
  for (const Shipped& s : shipped()) {
    CAPTURE(s.file.string());
    CHECK(s.kit.present);
    for (const Problem& p : kitLacks(s.lesson, s.kit)) FAIL_CHECK(p.text());
    CHECK(s.kit.prior_knowledge.size() >= 1);
    CHECK(s.kit.touch_shows.size() >= 2);
    CHECK(s.kit.limits.size() == 3);
    CHECK(s.kit.prompts.size() >= 4);
    for (const KitPrompt& p : s.kit.prompts) CHECK_FALSE(s.lesson.steps[*s.lesson.find(p.step)].aside);
  }
}

TEST_CASE(
    "a lesson's two kits say the same: as many items in each part, at the same steps, with the same right choices") {
  for (std::size_t k = 0; k < shipped().size(); k += 2) {
    const Shipped &english = shipped()[k], &german = shipped()[k + 1];
    CAPTURE(english.file.string());
    CHECK(english.kit.prior_knowledge.size() == german.kit.prior_knowledge.size());
    CHECK(english.kit.touch_shows.size() == german.kit.touch_shows.size());
    CHECK(english.kit.curriculum.size() == german.kit.curriculum.size());
    REQUIRE(english.kit.prompts.size() == german.kit.prompts.size());
    for (std::size_t i = 0; i < english.kit.prompts.size(); ++i)
      CHECK(english.lesson.find(english.kit.prompts[i].step) == german.lesson.find(german.kit.prompts[i].step));
    REQUIRE(english.kit.exit_ticket.size() == german.kit.exit_ticket.size());
    for (std::size_t i = 0; i < english.kit.exit_ticket.size(); ++i) {
      const auto &a = english.kit.exit_ticket[i].choices, &b = german.kit.exit_ticket[i].choices;
      REQUIRE(a.size() == b.size());
      for (std::size_t c = 0; c < a.size(); ++c) CHECK(a[c].right == b[c].right);
    }
  }
}

TEST_CASE("every exit ticket has three questions of three choices, one of them right, and not always at one place") {
  std::array<int, 3> at{};
  for (const Shipped& s : shipped()) {
    CAPTURE(s.file.string());
    REQUIRE(s.kit.exit_ticket.size() == 3);
    std::set<std::size_t> places;
    std::size_t longest_right = 0;
    for (const Question& q : s.kit.exit_ticket) {
      CAPTURE(plainText(q.title));
      REQUIRE(q.choices.size() == 3);
      CHECK(q.rightChoices() == 1);
      std::size_t longest = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        if (plainText(q.choices[c].text).size() > plainText(q.choices[longest].text).size()) longest = c;
        if (q.choices[c].right) {
          places.insert(c);
          ++at[c];
        } else {
          CHECK_FALSE(q.choices[c].feedback.empty());
        }
      }
      longest_right += q.choices[longest].right;
    }
    CHECK(places.size() >= 2);
    CHECK(longest_right <= 2);  // who always takes the longest choice does not pass
  }
  // A student who always takes the same letter gets at most half of all right.
  for (const int n : at) CHECK(n <= 48);
}

TEST_CASE("the time line of each shipped lesson has a row for each step of the core and takes 45 minutes at most") {
  for (const Shipped& s : shipped()) {
    CAPTURE(s.file.string());
    const std::vector<PlanRow> plan = classPlan(s.lesson);
    const auto core =
        std::count_if(s.lesson.steps.begin(), s.lesson.steps.end(), [](const Step& x) { return !x.aside; });
    REQUIRE(plan.size() == std::size_t(core) + 3);
    int at = 0;
    for (const PlanRow& row : plan) {
      CHECK(row.from_min == at);
      CHECK(row.minutes >= 1);
      at += row.minutes;
    }
    CHECK(at == minutesOf(plan));
    CHECK(at <= kClassMinutes);
    CHECK(at >= 35);
    // No step is shorter than one reader needs, but for rounding.
    for (const PlanRow& row : plan)
      if (row.kind == PlanRow::Kind::Step) CHECK(row.minutes >= minutesOf(s.lesson.steps[row.step]) - 1.0);
  }
}

TEST_CASE("a core that is too long for 45 minutes keeps its estimate, and the kit is said to take too long") {
  std::string body;
  for (int i = 0; i < 16; ++i)
    body += "### Question: Q" + std::to_string(i) + "?\n```answer\nfree: yes\nmodel: M\n```\n";
  const Lesson lesson = smallLesson(body);
  const double core = minutesOf(lesson.steps[0]);
  CHECK(core > 40.0);  // sixteen free answers of 150 s
  const std::vector<PlanRow> plan = classPlan(lesson);
  CHECK(plan[1].minutes == doctest::Approx(core).epsilon(0.02));
  const std::vector<Problem> lacks = kitLacks(lesson, readKit("kits/l.md", std::string(kGoodKit)));
  CHECK(std::any_of(lacks.begin(), lacks.end(), [](const Problem& p) { return has(p.message, "more than 45"); }));
}

TEST_CASE("nothing that a lesson keeps back stands on its worksheet or exit ticket") {
  for (const Shipped& s : shipped()) {
    CAPTURE(s.file.string());
    const std::string page = kitPage(s.lesson, s.kit, KitFor::Students);
    std::string sheet, ticket;
    kit::worksheet(sheet, s.lesson);
    kit::exitTicket(ticket, s.lesson, s.kit);
    std::string asked;
    for (const Step& step : s.lesson.steps)
      for (const Question& q : step.questions) asked += kit::html(q.title) + "\n";
    for (const KeptBack& kept : keptBack(s.lesson)) {
      if (kept.tag && has(asked, kept.text)) continue;  // of a question's own words
      CHECK_MESSAGE(!has(sheet, kept.text), kept.text);
      // The ticket may offer a choice of the lesson again, without a mark.
      if (!kept.choice) CHECK_MESSAGE(!has(ticket, kept.text), kept.text);
    }
    for (const std::string& goal : s.lesson.goals) CHECK_MESSAGE(!has(page, goal), goal);
    for (const Question& q : s.kit.exit_ticket)
      for (const Choice& c : q.choices)
        if (!c.right && plainText(c.feedback) != plainText(c.text))
          CHECK_MESSAGE(!has(page, kit::html(c.feedback)), plainText(c.feedback));
    // Every question of the core stands there, and each prediction with all its choices.
    for (const Step& step : s.lesson.steps)
      for (const Question& q : step.questions) {
        CHECK(has(sheet, kit::html(q.title)) == !step.aside);
        if (q.prediction && !step.aside)
          for (const Choice& c : q.choices) {
            CHECK(has(sheet, "<li>" + kit::html(c.text) + "</li>"));
            if (c.right && plainText(c.text).size() > 12) CHECK(count(sheet, kit::html(c.text)) == 1);
          }
      }
    CHECK(count(page, "class=\"ticket\"") == 2);  // two on a sheet
  }
}

TEST_CASE("the order of a prediction's choices on the worksheet does not depend on which one is right") {
  const auto sheet = [](const char* a, const char* b, const char* c) {
    std::string out;
    kit::worksheet(out, smallLesson(std::string("### Prediction: What?\n- [") + a + "] down there → F\n- [" + b +
                                    "] up there → F\n- [" + c + "] over there → F\n"));
    return out;
  };
  CHECK(sheet("x", " ", " ") == sheet(" ", "x", " "));
  CHECK(sheet("x", " ", " ") == sheet(" ", " ", "x"));
  CHECK(has(sheet("x", " ", " "), "down there"));
}

TEST_CASE("of the shipped predictions on the worksheets no place holds the right choice in more than half") {
  std::array<int, 3> at{};
  int all = 0;
  for (const Shipped& s : shipped()) {
    std::string sheet;
    kit::worksheet(sheet, s.lesson);
    for (const Step& step : s.lesson.steps)
      for (const Question& q : step.questions) {
        if (!q.prediction || step.aside || q.in_order || q.choices.size() != 3) continue;
        std::vector<std::pair<std::size_t, bool>> places;
        for (const Choice& c : q.choices)
          places.emplace_back(sheet.find("<li>" + kit::html(c.text) + "</li>"), c.right);
        std::sort(places.begin(), places.end());
        for (std::size_t k = 0; k < 3; ++k) at[k] += places[k].second;
        ++all;
      }
  }
  CHECK(all >= 38);
  for (const int n : at) CHECK(2 * n <= all);
}

TEST_CASE("the teacher's page has the goals, the questions of the core with their tags, and the key of the ticket") {
  for (const Shipped& s : shipped()) {
    CAPTURE(s.file.string());
    const std::string page = kitPage(s.lesson, s.kit, KitFor::Teacher);
    for (const std::string& goal : s.lesson.goals)
      CHECK(has(page, "<li>" + kit::html({TextRun{.text = goal}}) + "</li>"));
    for (const Step& step : s.lesson.steps)
      for (const Question& q : step.questions)
        if (!step.aside)
          for (const Choice& c : q.choices) CHECK(has(page, kit::html(c.text)));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& choices = s.kit.exit_ticket[k].choices;
      const auto right = std::find_if(choices.begin(), choices.end(), [](const Choice& c) { return c.right; });
      CHECK(has(page,
                "<p><b>" + std::to_string(k + 1) + " " + kit::letter(std::size_t(right - choices.begin())) + "</b>"));
    }
    CHECK(has(page, kitPage(s.lesson, s.kit, KitFor::Students).substr(0, 40)));
  }
}

TEST_CASE("the words of a worksheet are none that answer a question of the core: of first-touch not the crease") {
  for (const Shipped& s : shipped()) {
    CAPTURE(s.file.string());
    const auto words = kit::worksheetWords(s.lesson);
    CHECK(words.size() <= 6);
    for (const GlossaryWord* word : words)
      for (const Step& step : s.lesson.steps)
        for (const Question& q : step.questions)
          for (const Choice& c : q.choices)
            if (c.right && !step.aside) CHECK_MESSAGE(!has(plainText(c.text), word->word), word->word);
  }
  const auto first =
      std::find_if(shipped().begin(), shipped().end(), [](const Shipped& s) { return s.file.stem() == "first-touch"; });
  REQUIRE(first != shipped().end());
  const auto words = kit::worksheetWords(first->lesson);
  CHECK(std::none_of(words.begin(), words.end(), [](const GlossaryWord* w) { return w->word == "crease"; }));
  CHECK(
      std::any_of(words.begin(), words.end(), [](const GlossaryWord* w) { return w->word == "van der Waals radius"; }));
}

TEST_CASE("a kit's file is read: parts in English or German, prompts with step and answer, the ticket's choices") {
  const TeachersKit kit = readKit("kits/l.md", std::string(kGoodKit));
  CHECK(kit.problems.empty());
  REQUIRE(kit.prompts.size() == 2);
  CHECK(kit.prompts[1].step == "one");
  CHECK(plainText(kit.prompts[1].question) == "Why? ");
  CHECK(plainText(kit.prompts[1].answer) == "Because of it.");
  REQUIRE(kit.exit_ticket.size() == 3);
  CHECK(kit::html(kit.exit_ticket[0].title) == "A <i>b</i>?");
  CHECK(plainText(kit.exit_ticket[0].choices[1].feedback) == "no idea");
  CHECK(kitLacks(smallLesson(), kit).empty());
  CHECK(readKit("kits/l.de.md", "## Vorwissen\n- A\n## Was die Hand zeigt\n- B\n## Grenzen des Modells\n- C\n")
            .limits.size() == 1);
}

TEST_CASE("what a kit lacks is named one by one: seven gaps of an empty file, and what is wrong in one that is there") {
  const Lesson lesson = smallLesson();
  const auto messages = [&](const std::string& text) {
    std::string out;
    for (const Problem& p : kitLacks(lesson, readKit("kits/l.md", text)))
      out += std::to_string(p.line) + ": " + p.message + "\n";
    return out;
  };
  CHECK(messages("# Kit\n") ==
        "0: the kit does not say what students must know before\n"
        "0: the kit does not say what touch shows that a picture does not\n"
        "0: the kit does not state the limits of the model\n"
        "0: the kit has nothing to ask the class\n"
        "0: the exit ticket has 0 questions\n");
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text(kGoodKit);
    text.replace(text.find(from), from.size(), to);
    return messages(text);
  };
  CHECK(changed("#one", "#two") == "9: this question belongs to no step of the lesson\n");
  CHECK(changed("*Because of it.*", "") == "10: this question has no expected answer\n");
  CHECK(changed(" → no idea", "") == "14: this choice does not say which misconception it stands for\n");
  CHECK(changed("- [x] yes\n- [ ] no → no idea", "- [x] yes\n- [x] no") ==
        "12: this question of the exit ticket does not have exactly one right choice among several\n");
  CHECK(changed("### Question: C?\n- [ ] no → none\n- [x] yes\n", "") == "0: the exit ticket has 2 questions\n");
  CHECK(changed("## Prior knowledge", "## Before") ==
        "2: 'Before' is no part of a teacher's kit\n"
        "0: the kit does not say what students must know before\n");
  CHECK(changed("# Teacher's kit\n", "# Teacher's kit\n## Curriculum\n- Code 7\n") ==
        "0: 'Code 7' names no source that it was checked against\n");
  CHECK(changed("# Teacher's kit\n", "# Teacher's kit\n## Curriculum\n- Code 7 ([checked](https://example.org/7))\n")
            .empty());
  const TeachersKit none = kitOf("no-such-folder/l.md");
  REQUIRE(kitLacks(lesson, none).size() == 1);
  CHECK(has(kitLacks(lesson, none)[0].remedy, "no-such-folder/kits/l.md"));
}

TEST_CASE("text of a lesson and of its kit cannot become a tag of the page") {
  Lesson lesson = smallLesson("### Question: Is 1 < 2 & \"3\"?\n- [x] a < b → F\n- [ ] c → F\n");
  lesson.title = "<script>alert(1)</script>";
  lesson.goals = {"<img src=x onerror=alert(1)>"};
  const std::string page = kitPage(
      lesson, readKit("kits/l.md", "## Limits of the model\n- <b onclick=x>rigid</b> & 1 < 2\n"), KitFor::Teacher);
  CHECK_FALSE(has(page, "<script"));
  CHECK_FALSE(has(page, "<img"));
  CHECK_FALSE(has(page, "onclick=x>"));
  CHECK(has(page, "&lt;script&gt;"));
}

TEST_CASE("a kit is no lesson and stands in no lesson's list; no lesson's own text holds an answer of its kit") {
  const LessonFolder folder = lessonsIn(fs::path(MOLTACT_SOURCE_DIR) / "lessons");
  for (const fs::path& file : folder.lessons) CHECK_FALSE_MESSAGE(isKitFile(file), file.string());
  CHECK(std::count_if(folder.others.begin(), folder.others.end(), isKitFile) == std::ptrdiff_t(shipped().size()));
  for (const Shipped& s : shipped()) {
    std::ifstream in(s.file);
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    CAPTURE(s.file.string());
    for (const KitPrompt& p : s.kit.prompts)
      if (plainText(p.answer).size() > 25) CHECK_FALSE_MESSAGE(has(text, plainText(p.answer)), plainText(p.answer));
  }
}
