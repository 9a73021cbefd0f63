#include "engine/classroom/class_view.h"

#include <algorithm>
#include <map>
#include <span>

#include "engine/classroom/stuck.h"
#include "engine/core/text.h"
#include "engine/core/utf8.h"
#include "engine/results/lesson_language.h"

namespace moltact {
namespace {

constexpr std::size_t kMaxShownTexts = 60;

// An attempt at a lesson, the latest of its student.
struct AttemptAt {
  std::size_t student = 0;
  const LiveAttempt* attempt = nullptr;
};

struct LessonAttempts {
  std::string id;
  LessonOutline lesson;
  std::vector<AttemptAt> attempts;
};

// The attempts at the teacher's lessons. What a student opens besides, with any title and size, has a row and no card.
std::vector<LessonAttempts> byLesson(const ClassRoom& room) {
  std::vector<LessonAttempts> out;
  for (const ClassLesson& lesson : room.lessons()) out.push_back({lesson.id, lesson.outline, {}});
  for (std::size_t s = 0; s < room.students().size(); ++s)
    for (const LiveAttempt& attempt : room.students()[s].attempts) {
      if (attempt.lines == 0 || attempt.lesson.steps.empty()) continue;
      auto group = std::find_if(out.begin(), out.end(),
                                [&](const LessonAttempts& one) { return sameLesson(one.lesson, attempt.lesson); });
      if (group == out.end()) continue;
      if (!group->attempts.empty() && group->attempts.back().student == s) group->attempts.pop_back();
      group->attempts.push_back({s, &attempt});
    }
  return out;
}

// A version of the lesson with another number of steps shows only the steps that the outline has.
std::size_t commonSteps(const LessonAttempts& of, const LiveAttempt& attempt) {
  return std::min(of.lesson.steps.size(), attempt.steps.size());
}

bool stuckAt(const LessonAttempts& of, const AttemptAt& one, std::optional<std::size_t> held) {
  const LiveAttempt& own = *one.attempt;
  if (!own.step || own.finished() || own.step == held || *own.step >= of.lesson.steps.size()) return false;
  std::vector<StepTime> others;
  for (const AttemptAt& other : of.attempts) {
    if (other.student == one.student || *own.step >= commonSteps(of, *other.attempt)) continue;
    const LiveAttempt::Step& there = other.attempt->steps[*own.step];
    if (there.entered) others.push_back({other.attempt->spent_s(*own.step), other.attempt->step != own.step});
  }
  return isStuck(own.spent_s(*own.step), others);
}

std::string shownTitle(std::string_view title) {
  std::string out;
  std::size_t count = 0;
  for (const char32_t c : charactersOf(title.substr(0, 4 * kMaxShownTitle)))
    if (count++ < kMaxShownTitle) out += utf8Of(c);
  return out;
}

StudentRow rowOf(const LiveStudent& student, double now_s) {
  StudentRow row;
  row.name = student.name;
  row.away = now_s - student.seen_s > kAwayAfter_s;
  row.begun = !student.attempts.empty();
  if (student.current >= student.attempts.size()) return row;
  const LiveAttempt& attempt = student.attempts[student.current];
  row.lesson = shownTitle(attempt.lesson.title);
  row.done = attempt.done;
  row.of = attempt.of;
  row.hints = attempt.hints();
  row.finished = attempt.finished();
  if (!attempt.step) return row;
  row.step = shownTitle(attempt.lesson.steps[*attempt.step].title);
  row.step_number = *attempt.step + 1;
  row.on_step_s = attempt.spent_s(*attempt.step);
  const std::vector<char>& tasks = attempt.steps[*attempt.step].tasks_done;
  const auto open = std::find(tasks.begin(), tasks.end(), 0);
  if (open != tasks.end()) row.task = std::size_t(open - tasks.begin()) + 1;
  row.tasks = tasks.size();
  return row;
}

PredictionPlot predictionPlot(const LessonAttempts& of, std::size_t s, std::size_t q) {
  const StepOutline& step = of.lesson.steps[s];
  const QuestionOutline& asked = step.questions[q];
  PredictionPlot plot{s,  q, step.title, asked.text, asked.choices, std::vector<std::size_t>(asked.choices.size()),
                      {}, 0, 0};
  for (const AttemptAt& one : of.attempts) {
    const auto answer = one.attempt->answers.find({s, q});
    if (answer == one.attempt->answers.end()) continue;
    ++plot.students;
    for (const std::size_t choice : answer->second.chosen)
      if (choice < plot.counts.size()) ++plot.counts[choice];
    if (!answer->second.written.empty() && plot.written.size() < kMaxShownTexts)
      plot.written.push_back(answer->second.written);
  }
  std::sort(plot.written.begin(), plot.written.end());  // not in the order of the students
  return plot;
}

CurvePlot curvePlot(const LessonAttempts& of, std::size_t s, std::size_t t) {
  CurvePlot plot{s, t, of.lesson.steps[s].title, of.lesson.steps[s].tasks[t].say, {}, 0};
  for (const AttemptAt& one : of.attempts)
    if (const auto curve = one.attempt->curves.find({s, t}); curve != one.attempt->curves.end())
      plot.curves.push_back(curve->second);
  return plot;
}

// Students here whose present attempt is at the lesson and lacks what `has` looks for, and those who have begun nothing.
template <class Has>
std::size_t waitingFor(const LessonAttempts& of, const ClassRoom& room, double now_s, const Has& has) {
  const auto here = [&](const LiveStudent& student) { return now_s - student.seen_s <= kAwayAfter_s; };
  std::size_t out = 0;
  for (const LiveStudent& student : room.students()) out += here(student) && student.attempts.empty();
  for (const AttemptAt& one : of.attempts) {
    const LiveStudent& student = room.students()[one.student];
    out += here(student) && &student.attempts[student.current] == one.attempt && !has(*one.attempt);
  }
  return out;
}

void addPredictions(LessonView& view, const LessonAttempts& of, const ClassRoom& room, double now_s) {
  for (std::size_t s = 0; s < of.lesson.steps.size(); ++s) {
    const StepOutline& step = of.lesson.steps[s];
    for (std::size_t q = 0; q < step.questions.size(); ++q) {
      if (step.questions[q].kind != AnswerKind::Prediction) continue;
      PredictionPlot plot = predictionPlot(of, s, q);
      if (plot.students == 0) continue;
      plot.waiting = waitingFor(of, room, now_s, [&](const LiveAttempt& one) { return one.answers.contains({s, q}); });
      view.predictions.push_back(std::move(plot));
    }
    for (std::size_t t = 0; t < step.tasks.size(); ++t) {
      CurvePlot plot = curvePlot(of, s, t);
      if (plot.curves.empty()) continue;
      plot.waiting = waitingFor(of, room, now_s, [&](const LiveAttempt& one) { return one.curves.contains({s, t}); });
      view.curves.push_back(std::move(plot));
    }
  }
}

void addMisconceptions(std::map<std::string, std::vector<std::string>>& into, const LessonAttempts& of,
                       const ClassRoom& room) {
  for (const AttemptAt& one : of.attempts)
    for (const auto& [place, answer] : one.attempt->answers) {
      // The words of the teacher's lesson, whichever language the student reads.
      if (place.first >= of.lesson.steps.size() || place.second >= of.lesson.steps[place.first].questions.size())
        continue;
      const QuestionOutline& asked = of.lesson.steps[place.first].questions[place.second];
      for (const std::size_t choice : answer.chosen) {
        if (answer.right || choice >= asked.tags.size() || asked.tags[choice].empty()) continue;
        std::vector<std::string>& students = into[asked.tags[choice]];
        const std::string& name = room.students()[one.student].name;
        if (std::find(students.begin(), students.end(), name) == students.end()) students.push_back(name);
      }
    }
}

// Rows are still in the order of the room.
void markUnbegun(ClassView& view, const ClassRoom& room, double now_s) {
  const auto begun =
      std::size_t(std::count_if(view.students.begin(), view.students.end(), [](const auto& row) { return row.begun; }));
  if (begun < kStuckOthers || 4 * begun < 3 * (view.students.size() - 1)) return;
  for (std::size_t k = 0; k < view.students.size(); ++k) {
    StudentRow& row = view.students[k];
    if (row.begun || row.away || now_s - room.students()[k].joined_s < kUnbegunAfter_s) continue;
    row.stuck = true;
    ++view.stuck;
  }
}

}  // namespace

ClassView viewOf(const ClassRoom& room, double now_s) {
  ClassView out;
  out.ended = room.ended();
  out.shown = room.shown();
  for (const LiveStudent& student : room.students()) {
    out.students.push_back(rowOf(student, now_s));
    out.students.back().student = out.students.size() - 1;
    ++(out.students.back().away ? out.away : out.here);
    out.finished += out.students.back().finished;
  }
  markUnbegun(out, room, now_s);
  std::map<std::string, std::vector<std::string>> misconceptions;
  for (const LessonAttempts& group : byLesson(room)) {
    LessonView view;
    view.id = group.id;
    view.title = group.lesson.title;
    if (const auto held = room.held().find(group.id); held != room.held().end()) view.held = held->second;
    for (const StepOutline& step : group.lesson.steps)
      view.steps.push_back({step.title, 0, 0, 0, 0, step.aside, false});
    if (view.held && *view.held < view.steps.size()) view.steps[*view.held].held = true;
    for (const AttemptAt& one : group.attempts) {
      const LiveStudent& student = room.students()[one.student];
      StudentRow& row = out.students[one.student];
      const bool current = &student.attempts[student.current] == one.attempt;
      view.students += current;
      for (std::size_t k = 0; k < commonSteps(group, *one.attempt); ++k) {
        view.steps[k].reached += one.attempt->steps[k].entered;
        view.steps[k].hints += one.attempt->steps[k].hints;
      }
      const bool known = one.attempt->step && *one.attempt->step < view.steps.size();
      if (current && known && !row.away) ++view.steps[*one.attempt->step].here;
      if (current && known && !row.away && stuckAt(group, one, view.held)) {
        row.stuck = true;
        ++view.steps[*one.attempt->step].stuck;
        ++out.stuck;
      }
    }
    addPredictions(view, group, room, now_s);
    addMisconceptions(misconceptions, group, room);
    out.lessons.push_back(std::move(view));
  }
  for (auto& [words, students] : misconceptions) out.misconceptions.push_back({words, std::move(students)});
  std::stable_sort(out.misconceptions.begin(), out.misconceptions.end(),
                   [](const auto& a, const auto& b) { return a.students.size() > b.students.size(); });
  std::stable_sort(out.lessons.begin(), out.lessons.end(),
                   [](const LessonView& a, const LessonView& b) { return (a.students > 0) > (b.students > 0); });
  std::stable_sort(out.students.begin(), out.students.end(), [](const StudentRow& a, const StudentRow& b) {
    return a.stuck != b.stuck ? a.stuck : lower(a.name) < lower(b.name);
  });
  return out;
}

void addScene(ClassView& view, const ClassRoom& room, const SharedScene& scene, double now_s) {
  for (StudentRow& row : view.students) row.may_ask_scene = scene.mayAsk(room, row.student, now_s);
  if (scene.state() == SharedScene::State::None) return;
  SceneRow& row = view.scene.emplace();
  row.student = room.students()[scene.student()].name;
  row.agreed = scene.state() == SharedScene::State::Agreed;
  row.named = scene.named();
  row.hidden =
      row.agreed ? scene.hidden(room, now_s, row.waiting) : sceneAnswers(room, scene.place(), now_s, row.waiting);
}

std::size_t studentsHere(const ClassRoom& room, double now_s) {
  std::size_t out = 0;
  for (const LiveStudent& student : room.students()) out += now_s - student.seen_s <= kAwayAfter_s;
  return out;
}

BoardPlot boardPlotOf(const ClassRoom& room, const ShownPlot& shown) {
  BoardPlot out;
  for (const LessonAttempts& group : byLesson(room)) {
    if (group.id != shown.lesson || shown.step >= group.lesson.steps.size()) continue;
    const StepOutline& step = group.lesson.steps[shown.step];
    if (shown.curve && shown.number < step.tasks.size()) {
      CurvePlot plot = curvePlot(group, shown.step, shown.number);
      if (plot.curves.size() >= kShownFrom) out.curve = std::move(plot);
    } else if (!shown.curve && shown.number < step.questions.size()) {
      PredictionPlot plot = predictionPlot(group, shown.step, shown.number);
      plot.written.clear();
      if (plot.students >= kShownFrom) out.prediction = std::move(plot);
    }
  }
  return out;
}

}  // namespace moltact
