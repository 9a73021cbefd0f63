#include "engine/results/attempt.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "engine/language/catalogue.h"

namespace moltact {

std::string_view nameOf(InputKind input) {
  switch (input) {
    case InputKind::Device:
      return N_("device");
    case InputKind::Mouse:
      return N_("mouse");
    case InputKind::Keyboard:
      return N_("keyboard");
  }
  return N_("mouse");
}

std::string shownName(InputKind input) { return std::string(tr(nameOf(input))); }

std::size_t LessonOutline::parts() const {
  std::size_t n = 0;
  for (const StepOutline& s : steps)
    if (!s.aside) n += s.tasks.size() + s.questions.size();
  return n;
}

LessonOutline outlineOf(const Lesson& lesson, std::string hash) {
  LessonOutline out{
      std::filesystem::path(lesson.file).filename().string(), lesson.title, std::move(hash), {}, lesson.goals};
  out.test = lesson.test;
  out.condition = lesson.condition;
  out.study = lesson.study;
  for (const Step& step : lesson.steps) {
    StepOutline& s = out.steps.emplace_back(StepOutline{step.id, step.title, {}, {}, step.aside});
    for (const TaskSpec& task : step.tasks)
      s.tasks.push_back({task.kind, task.values["say"].text, task.goals, task.values["asked"].text});
    for (const Question& question : step.questions) {
      QuestionOutline& q =
          s.questions.emplace_back(QuestionOutline{question.id, plainText(question.title), {}, {}, AnswerKind::Marked});
      q.goals = question.goals;
      if (question.prediction) q.kind = AnswerKind::Prediction;
      if (question.free()) q.kind = AnswerKind::Free;
      for (std::size_t i = 0; i < question.choices.size(); ++i) {
        q.choices.push_back(plainText(question.choices[i].text));
        if (question.choices[i].right) q.right.push_back(i);
      }
      if (std::any_of(question.choices.begin(), question.choices.end(), [](const Choice& c) { return !c.tag.empty(); }))
        for (const Choice& c : question.choices) q.tags.push_back(c.tag);
    }
  }
  return out;
}

std::uint64_t orderSeed(const AttemptHeader& header) { return hash64(header.began + '\n' + header.student) | 1u; }

std::string utcText(std::chrono::system_clock::time_point when) {
  using namespace std::chrono;
  const auto day = floor<days>(when);
  const year_month_day date(day);
  const hh_mm_ss time(floor<seconds>(when - day));
  char text[40];
  std::snprintf(text, sizeof text, "%04d-%02u-%02uT%02d:%02d:%02dZ", int(date.year()), unsigned(date.month()),
                unsigned(date.day()), int(time.hours().count()), int(time.minutes().count()),
                int(time.seconds().count()));
  return text;
}

}  // namespace moltact
