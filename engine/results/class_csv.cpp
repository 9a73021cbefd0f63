#include "engine/results/class_csv.h"

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/language/catalogue.h"
#include "engine/language/figure_title.h"
#include "engine/results/csv_row.h"

namespace moltact {
namespace {

std::string answerText(const QuestionOutline& question, const AnswerScore& answer) {
  if (!answer.written.empty()) return answer.written;
  std::string out;
  for (const std::size_t c : answer.chosen)
    out += (out.empty() ? "" : " | ") + (c < question.choices.size() ? question.choices[c] : "?");
  return out;
}

// Names and units of all measurements of a task, in the order of first occurrence; by step and task.
using TaskFigures = std::map<std::pair<std::string, std::size_t>, std::vector<std::pair<std::string, std::string>>>;

TaskFigures figuresOf(const LessonSummary& lesson) {
  TaskFigures out;
  for (const PersonScore& p : lesson.people)
    for (const auto& [task, score] : p.tasks) {
      auto& figures = out[task];
      for (const LoggedFigure& f : score.figures)
        if (std::find(figures.begin(), figures.end(), std::pair(f.name, f.unit)) == figures.end())
          figures.emplace_back(f.name, f.unit);
    }
  return out;
}

std::span<const std::pair<std::string, std::string>> figuresAt(const TaskFigures& figures, const std::string& step,
                                                               std::size_t task) {
  const auto found = figures.find({step, task});
  return found == figures.end() ? std::span<const std::pair<std::string, std::string>>() : found->second;
}

// A lesson and the columns of its tasks' measurements.
struct Columns {
  const LessonSummary* lesson = nullptr;
  TaskFigures figures;
};

using Row = CsvRow;

const char* yesOrNo(bool yes) { return yes ? trc("cell", "yes") : trc("cell", "no"); }

void head(std::string& out, const ClassSummary& summary, std::span<const Columns> columns) {
  Row row(out);
  for (const char* name : {NC_("column", "student"),
                           NC_("column", "lesson"),
                           NC_("column", "lesson_file"),
                           NC_("column", "began_utc"),
                           NC_("column", "attempts"),
                           NC_("column", "done"),
                           NC_("column", "of"),
                           NC_("column", "done_percent"),
                           NC_("column", "finished"),
                           NC_("column", "last_step"),
                           NC_("column", "minutes"),
                           NC_("column", "questions"),
                           NC_("column", "answered"),
                           NC_("column", "right_at_first_try"),
                           NC_("column", "hints"),
                           NC_("column", "touches"),
                           NC_("column", "touch_s"),
                           NC_("column", "peak_force_N"),
                           NC_("column", "mean_force_N"),
                           NC_("column", "path_A"),
                           NC_("column", "crossings"),
                           NC_("column", "input"),
                           NC_("column", "device_percent"),
                           NC_("column", "mouse_percent"),
                           NC_("column", "keyboard_percent"),
                           NC_("column", "device"),
                           NC_("column", "force_feedback"),
                           NC_("column", "way"),
                           NC_("column", "misconceptions")})
    row.text(trc("column", name));
  for (const LessonSummary& lesson : summary.lessons)
    for (std::size_t g = 0; g < lesson.lesson.goals.size(); ++g) {
      row.text(trcf("column", "{0}#goal {1} done_percent", lesson.name, g + 1));
      row.text(trcf("column", "{0}#goal {1} right_percent", lesson.name, g + 1));
    }
  for (const LessonSummary& lesson : summary.lessons)
    if (asksTwice(lesson.lesson)) {
      row.text(trcf("column", "{0}#d_prime before", lesson.name));
      row.text(trcf("column", "{0}#d_prime after", lesson.name));
      row.text(trcf("column", "{0}#d_prime gain", lesson.name));
    }
  for (const Columns& of : columns)
    for (const StepOutline& step : of.lesson->lesson.steps) {
      const std::string place = of.lesson->name + "#" + step.id;
      row.text(trcf("column", "{0} minutes", place));
      for (const QuestionOutline& q : step.questions) {
        row.text(trcf("column", "{0} first answer", place + "/" + q.id));
        row.text(trcf("column", "{0} tries", place + "/" + q.id));
        row.text(trcf("column", "{0} solved", place + "/" + q.id));
      }
      for (std::size_t t = 0; t < step.tasks.size(); ++t) {
        row.text(trcf("column", "{0}/task {1} solved", place, t + 1));
        row.text(trcf("column", "{0}/task {1} s", place, t + 1));
        row.text(trcf("column", "{0}/task {1} input", place, t + 1));
        for (const auto& [name, unit] : figuresAt(of.figures, step.id, t))
          row.text(trcf("column", "{0}/task {1} {2}", place, t + 1,
                        figureTitle(name) + (unit.empty() ? std::string() : " " + unit)));
      }
    }
}

void person(std::string& out, const ClassSummary& summary, std::span<const Columns> columns, const LessonSummary& of,
            const PersonScore& p) {
  Row row(out);
  std::size_t questions = 0;
  for (const StepOutline& s : of.lesson.steps)
    for (const QuestionOutline& q : s.questions) questions += q.kind == AnswerKind::Marked;
  row.text(p.person);
  row.text(of.lesson.title);
  row.text(of.lesson.file);
  row.text(p.began);
  row.whole(p.attempts);
  row.whole(p.done);
  row.whole(p.of);
  row.value(100.0 * p.share(), 1);
  row.text(yesOrNo(p.finished()));
  row.text(p.last_step);
  row.value(p.time_s / 60.0, 2);
  row.whole(questions);
  row.whole(p.answered());
  row.whole(p.firstRight());
  row.whole(p.hints);
  row.whole(p.touches);
  row.value(p.touch_s, 1);
  row.value(p.peak_N, 3);
  row.value(p.mean_N, 3);
  row.value(p.path_A, 2);
  row.whole(p.crossings);
  const auto way = p.input();
  row.text(way ? shownName(*way) : "");
  for (const double s : p.touch_by_input_s) {
    if (p.touch_s > 0)
      row.value(100.0 * s / p.touch_s, 1);
    else
      row.empty();
  }
  row.text(p.device);
  row.text(yesOrNo(p.gives_force));
  row.text(wayText(of.lesson, p));
  std::string tags;
  for (const auto& [tag, times] : p.misconceptions)
    tags += (tags.empty() ? "" : " | ") + tag + (times > 1 ? " (" + std::to_string(times) + ")" : "");
  row.text(tags);
  for (const LessonSummary& lesson : summary.lessons)
    for (std::size_t g = 0; g < lesson.lesson.goals.size(); ++g) {
      const GoalScore score = &lesson == &of ? goalScore(lesson.lesson, p, g) : GoalScore{};
      if (score.parts > 0)
        row.value(100.0 * double(score.done) / double(score.parts), 1);
      else
        row.empty();
      if (score.answered > 0)
        row.value(100.0 * double(score.first_right) / double(score.answered), 1);
      else
        row.empty();
    }
  for (const LessonSummary& lesson : summary.lessons)
    if (asksTwice(lesson.lesson)) {
      const SensitivityPair pair = &lesson == &of ? sensitivityPair(lesson.lesson, p) : SensitivityPair{};
      for (const std::optional<double>& value : {pair.before, pair.after, pair.gain()})
        if (value)
          row.value(*value, 3);
        else
          row.empty();
    }
  for (const Columns& one : columns)
    for (const StepOutline& step : one.lesson->lesson.steps) {
      const bool mine = one.lesson == &of;
      const auto time = p.step_s.find(step.id);
      if (mine && time != p.step_s.end())
        row.value(time->second / 60.0, 2);
      else
        row.empty();
      for (const QuestionOutline& q : step.questions) {
        const auto answer = p.answers.find({step.id, q.id});
        const bool given = mine && answer != p.answers.end();
        if (given)
          row.text(answerText(q, answer->second)), row.whole(std::size_t(answer->second.tries));
        else
          row.empty(), row.empty();
        if (given && q.kind == AnswerKind::Marked)
          row.text(yesOrNo(answer->second.right));
        else
          row.empty();
      }
      for (std::size_t t = 0; t < step.tasks.size(); ++t) {
        const auto task = p.tasks.find({step.id, t});
        const bool begun = mine && task != p.tasks.end(), done = begun && task->second.done;
        if (begun)
          row.text(yesOrNo(done));
        else
          row.empty();
        if (done)
          row.value(task->second.took_s, 1), row.text(shownName(task->second.by));
        else
          row.empty(), row.empty();
        for (const auto& [name, unit] : figuresAt(one.figures, step.id, t)) {
          const LoggedFigure* found = nullptr;
          if (done)
            for (const LoggedFigure& f : task->second.figures)
              if (f.name == name && f.unit == unit) found = &f;
          if (found)
            row.value(found->value, 3);
          else
            row.empty();
        }
      }
    }
}

}  // namespace

std::string gradebookCsv(const ClassSummary& summary) {
  std::string out = "\xEF\xBB\xBF";
  {
    Row row(out);
    row.text(trc("column", "student"));
    for (const LessonSummary& lesson : summary.lessons) {
      const bool alone = std::count_if(summary.lessons.begin(), summary.lessons.end(), [&](const LessonSummary& l) {
                           return l.lesson.title == lesson.lesson.title;
                         }) == 1;
      const std::string title = alone ? lesson.lesson.title : lesson.lesson.title + " (" + lesson.name + ")";
      row.text(trcf("column", "{0}: done, of 100", title));
      row.text(trcf("column", "{0}: right at first try, of 100", title));
    }
  }
  std::map<std::string_view, std::vector<const PersonScore*>> scores;  // of each named person, by lesson
  for (std::size_t k = 0; k < summary.lessons.size(); ++k)
    for (const PersonScore& p : summary.lessons[k].people) {
      if (!p.named) continue;
      auto& of_person = scores[p.person];
      of_person.resize(summary.lessons.size());
      of_person[k] = &p;
    }
  for (const std::string& name : summary.people) {
    const auto of_person = scores.find(name);
    if (of_person == scores.end()) continue;
    Row row(out);
    row.text(name);
    for (const PersonScore* p : of_person->second) {
      if (p)
        row.value(100.0 * p->share(), 1);
      else
        row.empty();
      if (p && p->answered() > 0)
        row.value(100.0 * double(p->firstRight()) / double(p->answered()), 1);
      else
        row.empty();
    }
  }
  return out;
}

std::string classCsv(const ClassSummary& summary) {
  std::string out = "\xEF\xBB\xBF";
  std::vector<Columns> columns;
  for (const LessonSummary& lesson : summary.lessons) columns.push_back({&lesson, figuresOf(lesson)});
  head(out, summary, columns);
  for (const LessonSummary& lesson : summary.lessons)
    for (const PersonScore& p : lesson.people) person(out, summary, columns, lesson, p);
  return out;
}

}  // namespace moltact
