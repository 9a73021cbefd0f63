// A translated lesson, first-touch.de.md beside first-touch.md, differs only in its words: tasks, questions, assessment
// and measurements are the same.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "engine/lesson/glossary.h"
#include "engine/lesson/lesson_files.h"
#include "engine/lesson/tasks/registry.h"
#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using namespace moltact::test;

namespace {

namespace fs = std::filesystem;

struct Pair {
  std::string name, language;  // "first-touch", "de"
};

std::vector<Pair> translatedLessons() {
  std::vector<Pair> out;
  for (const auto& entry : fs::directory_iterator(MOLTACT_SOURCE_DIR "/lessons")) {
    const fs::path stem = entry.path().stem();
    if (looksLikeLesson(entry.path()) && stem.has_extension())
      out.push_back({stem.stem().string(), stem.extension().string().substr(1)});
  }
  std::sort(out.begin(), out.end(), [](const Pair& a, const Pair& b) { return a.name < b.name; });
  return out;
}

/// "0.59 Å", "70 °", "1971": every number of a text with its unit, the decimal sign a point, sorted.
std::vector<std::string> numbersOf(const std::string& text) {
  static const std::regex number("([0-9]+)(?:[.,]([0-9]+))? ?(Å|%|°|N\\b|s\\b)?");
  std::vector<std::string> out;
  for (std::sregex_iterator it(text.begin(), text.end(), number), end; it != end; ++it)
    out.push_back((*it)[1].str() + ((*it)[2].matched ? "." + (*it)[2].str() : "") + " " + (*it)[3].str());
  std::sort(out.begin(), out.end());
  return out;
}

/// What a sentence in two languages must share, and what it must not.
void compareSentence(const std::string& original, const std::string& translated, const std::string& language) {
  CAPTURE(original);
  CAPTURE(translated);
  CHECK(translated.empty() == original.empty());
  CHECK(numbersOf(translated) == numbersOf(original));
  // A decimal point; codes of curricula, "S2.2" and "3.1.3", are none.
  static const std::regex point("(^|[^A-Z0-9.])[0-9]+\\.[0-9]+([^0-9.]|$)");
  if (language == "de") CHECK_FALSE(std::regex_search(translated, point));
  // Sums and names of few letters may be the same in both; sentences are not.
  if (original.size() > 25) CHECK(translated != original);
}

void compareTexts(const std::vector<RichText>& original, const std::vector<RichText>& translated,
                  const std::string& language) {
  REQUIRE(translated.size() == original.size());
  for (std::size_t k = 0; k < original.size(); ++k)
    compareSentence(plainText(original[k]), plainText(translated[k]), language);
}

void compareBlocks(const std::vector<Block>& original, const std::vector<Block>& translated,
                   const std::string& language) {
  REQUIRE(translated.size() == original.size());
  for (std::size_t k = 0; k < original.size(); ++k) {
    CAPTURE(k);
    const Block &a = original[k], &b = translated[k];
    REQUIRE(b.index() == a.index());
    if (const auto* p = std::get_if<Paragraph>(&a)) {
      compareTexts({p->text}, {std::get<Paragraph>(b).text}, language);
    } else if (const auto* s = std::get_if<Subheading>(&a)) {
      compareTexts({s->text}, {std::get<Subheading>(b).text}, language);
    } else if (const auto* t = std::get_if<Tip>(&a)) {
      compareTexts(t->paragraphs, std::get<Tip>(b).paragraphs, language);
    } else if (const auto* n = std::get_if<TeacherNote>(&a)) {
      compareTexts(n->paragraphs, std::get<TeacherNote>(b).paragraphs, language);
    } else if (const auto* q = std::get_if<Quote>(&a)) {
      compareTexts(q->paragraphs, std::get<Quote>(b).paragraphs, language);
    } else if (const auto* l = std::get_if<ListBlock>(&a)) {
      const auto& other = std::get<ListBlock>(b).items;
      REQUIRE(other.size() == l->items.size());
      for (std::size_t i = 0; i < other.size(); ++i) {
        CHECK(other[i].depth == l->items[i].depth);
        CHECK(other[i].number == l->items[i].number);
        compareTexts({l->items[i].text}, {other[i].text}, language);
      }
    } else if (const auto* i = std::get_if<Image>(&a)) {
      CHECK(std::get<Image>(b).path == i->path);
    } else if (const auto* task = std::get_if<TaskHere>(&a)) {
      CHECK(std::get<TaskHere>(b).index == task->index);
    } else if (const auto* question = std::get_if<QuestionHere>(&a)) {
      CHECK(std::get<QuestionHere>(b).index == question->index);
    }
  }
}

void compareScenes(const SceneSpec& a, const SceneSpec& b) {
  CHECK(b.molecule == a.molecule);
  CHECK(b.touch == a.touch);
  CHECK(b.show == a.show);
  CHECK(b.colour == a.colour);
  CHECK(b.panels == a.panels);
  CHECK(b.locked == a.locked);
  CHECK(b.highlight.text() == a.highlight.text());
  CHECK(b.view == a.view);
  CHECK(b.views.size() == a.views.size());  // their names are prose
  for (std::size_t k = 0; k < std::min(a.views.size(), b.views.size()); ++k) CHECK(b.views[k].view == a.views[k].view);
  CHECK(b.hide == a.hide);
  CHECK(b.untouchable == a.untouchable);
  CHECK(b.in_hand == a.in_hand);
  CHECK(b.remove == a.remove);
  CHECK(b.cut == a.cut);
  CHECK(b.cut_at == a.cut_at);
  CHECK(b.then.molecule == a.then.molecule);
  CHECK(b.then.superposed_on == a.then.superposed_on);
  CHECK(b.elastic == a.elastic);
  CHECK(b.elastic_modes == a.elastic_modes);
  CHECK(b.scan_A == a.scan_A);
  CHECK(b.scan_force_pN == a.scan_force_pN);
  CHECK(b.simulation == a.simulation);
  CHECK(b.pull == a.pull);
  CHECK(b.pulled == a.pulled);
  CHECK(b.temperature_K == a.temperature_K);
  CHECK(b.trajectory == a.trajectory);
  CHECK(b.magnify.text() == a.magnify.text());
}

bool isProse(const TaskSpec& task, std::string_view key) {
  if (key == "dock") return false;  // a pose
  const auto prose = [&](const std::vector<KeySpec>& keys) {
    return std::any_of(keys.begin(), keys.end(),
                       [&](const KeySpec& k) { return k.name == key && k.type == ValueType::Text; });
  };
  return prose(keysOf(KeyBlock::Touch)) || prose(findTaskKind(task.kind)->keys);
}

void compareTasks(const TaskSpec& a, const TaskSpec& b, const std::string& language) {
  REQUIRE(b.kind == a.kind);
  for (const auto& [key, value] : a.values) {
    CAPTURE(key);
    REQUIRE(b.values.has(key));
    CHECK((b.values[key].place.line == 0) == (value.place.line == 0));
    if (isProse(a, key)) {
      compareSentence(value.text, b.values[key].text, value.place.line ? language : "");
      CHECK((value.place.line == 0 || value.text != b.values[key].text));
    } else {
      CHECK(b.values[key].text == value.text);
    }
  }
  for (const auto& [key, value] : b.values) CHECK_MESSAGE(a.values.has(key), key);
}

std::size_t translatedLessonsStepOf(const Lesson& lesson, const std::string& link) {
  return link.empty() ? std::string::npos : lesson.find(link.substr(1)).value_or(std::string::npos);
}

void compareQuestions(const Lesson& original, const Question& a, const Lesson& translated, const Question& b,
                      const std::string& language) {
  compareTexts({a.title}, {b.title}, language);
  compareTexts(a.prompt, b.prompt, language);
  REQUIRE(b.choices.size() == a.choices.size());
  for (std::size_t k = 0; k < a.choices.size(); ++k) {
    CHECK(b.choices[k].right == a.choices[k].right);
    CHECK(translatedLessonsStepOf(translated, b.choices[k].link) ==
          translatedLessonsStepOf(original, a.choices[k].link));
    compareTexts({a.choices[k].text, a.choices[k].feedback}, {b.choices[k].text, b.choices[k].feedback}, language);
  }
  REQUIRE(b.answer.has_value() == a.answer.has_value());
  if (!a.answer) return;
  CHECK(b.answer->kind == a.answer->kind);
  CHECK(b.answer->number == a.answer->number);
  CHECK(b.answer->tolerance == a.answer->tolerance);
  CHECK(b.answer->unit == a.answer->unit);
  CHECK(b.answer->texts.size() == a.answer->texts.size());
  if (a.answer->kind == AnswerSpec::Kind::Free) return;
  compareSentence(a.answer->right.text(), b.answer->right.text(), language);
  compareSentence(a.answer->wrong.text(), b.answer->wrong.text(), language);
}

}  // namespace

TEST_CASE("every shipped lesson is there in German, and every translated lesson has its original beside it") {
  const fs::path folder = MOLTACT_SOURCE_DIR "/lessons";
  int originals = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const fs::path stem = entry.path().stem();
    if (!looksLikeLesson(entry.path()) || stem.has_extension()) continue;
    CHECK_MESSAGE(fs::exists(folder / (stem.string() + ".de.md")), stem.string());
    ++originals;
  }
  CHECK(originals >= 14);
  for (const Pair& p : translatedLessons()) CHECK_MESSAGE(fs::exists(folder / (p.name + ".md")), p.name);
}

TEST_CASE(
    "the German glossary explains the words of the English one, each with the same numbers, and both without faults") {
  const Glossary english = glossaryBeside(MOLTACT_SOURCE_DIR "/lessons/first-touch.md", "en");
  const Glossary german = glossaryBeside(MOLTACT_SOURCE_DIR "/lessons/first-touch.de.md", "de");
  CHECK((english.errors.empty() && english.warnings.empty() && german.errors.empty() && german.warnings.empty()));
  CHECK(english.words.size() >= 25);
  REQUIRE(english.words.size() == german.words.size());
  for (std::size_t k = 0; k < english.words.size(); ++k) {
    CAPTURE(english.words[k].word);
    CAPTURE(german.words[k].word);
    CHECK(numbersOf(plainText(english.words[k].meaning)) == numbersOf(plainText(german.words[k].meaning)));
  }
}

TEST_CASE(
    "a translated lesson has the steps, scenes, tasks, selections, targets, questions, right answers and numbers of "
    "its "
    "original, and words of its own") {
  for (const Pair& p : translatedLessons()) {
    CAPTURE(p.name);
    CAPTURE(p.language);
    const Lesson a = shippedLesson(p.name), b = shippedLesson(p.name + "." + p.language);
    CHECK(b.title != a.title);
    CHECK(b.language == p.language);
    CHECK(b.minutes == a.minutes);
    CHECK(b.level == a.level);
    CHECK(b.molecules == a.molecules);
    CHECK(b.locked == a.locked);
    CHECK(b.author == a.author);
    CHECK(b.licence == a.licence);
    REQUIRE(b.goals.size() == a.goals.size());
    for (std::size_t k = 0; k < a.goals.size(); ++k) compareSentence(a.goals[k], b.goals[k], p.language);
    compareBlocks(a.introduction, b.introduction, p.language);
    REQUIRE(b.steps.size() == a.steps.size());
    for (std::size_t k = 0; k < a.steps.size(); ++k) {
      const Step &from = a.steps[k], &to = b.steps[k];
      CAPTURE(from.title);
      CHECK(to.title != from.title);
      CHECK(to.aside == from.aside);
      CHECK(to.states_scene == from.states_scene);
      compareScenes(from.scene, to.scene);
      compareBlocks(from.blocks, to.blocks, p.language);
      REQUIRE(to.tasks.size() == from.tasks.size());
      for (std::size_t t = 0; t < from.tasks.size(); ++t) compareTasks(from.tasks[t], to.tasks[t], p.language);
      REQUIRE(to.questions.size() == from.questions.size());
      for (std::size_t q = 0; q < from.questions.size(); ++q)
        compareQuestions(a, from.questions[q], b, to.questions[q], p.language);
    }
  }
}
