#include "engine/lesson/minutes.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/core/utf8.h"
#include "engine/lesson/letters.h"
#include "engine/lesson/tasks/guided.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact {
namespace {

/// The number of items of a key; the task's own key has the list if the other key has none.
double countOf(const TaskSpec& task, std::string_view key) {
  if (key.empty()) return 0.0;
  const auto in = [&](std::string_view k) {
    const Value& value = task.values[k];
    return std::max({value.number, double(value.path.size()), double(value.words.size())});
  };
  return std::max(1.0, std::max(in(key), in(task.kind)));
}

/// The number of words: parts between blanks that contain a letter or digit.
std::size_t wordsIn(std::string_view text) {
  std::size_t words = 0;
  bool in_word = false;
  for (const char32_t c : charactersOf(text)) {
    const bool blank = c == ' ' || c == '\n' || c == '\t' || c == U'\u00a0';
    const bool counts = isLetter(c);
    if (counts && !in_word) ++words;
    in_word = !blank && (in_word || counts);
  }
  return words;
}

std::size_t wordsIn(const RichText& text) { return wordsIn(plainText(text)); }

std::size_t wordsIn(const std::vector<RichText>& texts) {
  std::size_t words = 0;
  for (const RichText& t : texts) words += wordsIn(t);
  return words;
}

std::size_t wordsIn(const std::vector<Block>& blocks) {
  std::size_t words = 0;
  for (const Block& b : blocks) {
    if (const auto* p = std::get_if<Paragraph>(&b)) words += wordsIn(p->text);
    if (const auto* h = std::get_if<Subheading>(&b)) words += wordsIn(h->text);
    if (const auto* q = std::get_if<Quote>(&b)) words += wordsIn(q->paragraphs);
    if (const auto* i = std::get_if<Image>(&b)) words += wordsIn(i->caption);
    if (const auto* c = std::get_if<CodeText>(&b)) words += wordsIn(c->text);
    if (const auto* l = std::get_if<ListBlock>(&b))
      for (const ListBlock::Item& item : l->items) words += wordsIn(item.text);
    if (const auto* t = std::get_if<Table>(&b))
      for (const std::vector<RichText>& row : t->rows) words += wordsIn(row);
  }
  return words;
}

/// The words of the question, its choices, and the feedback to the right choice or the author's answer.
std::size_t wordsIn(const Question& question) {
  std::size_t words = wordsIn(question.title) + wordsIn(question.prompt);
  for (const Choice& c : question.choices) words += wordsIn(c.text) + (c.right ? wordsIn(c.feedback) : 0);
  if (question.answer) {
    if (question.answer->right.own()) words += wordsIn(question.answer->right.text());
    words += wordsIn(question.answer->model);
  }
  return words;
}

double reading_s(std::size_t words) { return 60.0 * double(words) / kWordsAMinute; }

double stepTime_s(const Step& step) {
  double time_s = reading_s(wordsIn(step.title) + wordsIn(step.blocks));
  for (const TaskSpec& task : step.tasks)
    time_s += taskTime_s(task) + reading_s(wordsIn(task.values["say"].text) + wordsIn(task.values["praise"].text));
  for (const Question& q : step.questions) time_s += reading_s(wordsIn(q)) + (q.free() ? kFreeAnswer_s : kQuestion_s);
  return time_s;
}

int whole(double minutes) { return std::max(1, static_cast<int>(std::lround(minutes))); }

}  // namespace

double taskTime_s(const TaskSpec& task) {
  const TaskKind* kind = findTaskKind(task.kind);
  if (!kind) return 0.0;
  const double count = countOf(task, kind->time.each);
  // Each pair has two things to touch.
  const double stays = kind->name == "same" ? 2.0 * count : std::max(1.0, count);
  const double once_s = kind->time.base_s + kind->time.each_s * count + stays * task.values["for"].number;
  return once_s * (1.0 + kGuidedTry * guidedTries(task));
}

double minutesOf(const Step& step) { return stepTime_s(step) / 60.0; }

LessonMinutes minutesOf(const Lesson& lesson) {
  LessonMinutes out;
  out.core = out.all = reading_s(wordsIn(lesson.introduction)) / 60.0;
  for (const Step& step : lesson.steps) {
    const double minutes = minutesOf(step);
    out.all += minutes;
    if (!step.aside) out.core += minutes;
  }
  return out;
}

ShownMinutes shownMinutes(const Lesson& lesson) {
  const LessonMinutes worked_out = minutesOf(lesson);
  const int core = lesson.minutes > 0 ? lesson.minutes : whole(worked_out.core);
  return {core, std::max(core, whole(core + worked_out.all - worked_out.core))};
}

}  // namespace moltact
