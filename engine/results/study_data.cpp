#include "engine/results/study_data.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/results/anonymous_text.h"

namespace moltact {
namespace {

// Tests before the lesson, the lessons, tests after it.
int rankOf(const std::string& part) {
  return part == "pre" ? 0 : part.starts_with("lesson") ? 1 : part == "post" ? 2 : part == "delayed" ? 3 : 4;
}

StudyPartOutline partOf(const LessonOutline& lesson) {
  StudyPartOutline out{lesson.study.part, lesson, {}};
  for (std::size_t s = 0; s < lesson.steps.size(); ++s)
    for (std::size_t q = 0; q < lesson.steps[s].questions.size(); ++q)
      out.questions.push_back({s, false, q, lesson.steps[s].id + "/" + lesson.steps[s].questions[q].id});
  return out;
}

// Adds the events of one attempt to a student's work in a part.
class StudyCounting {
 public:
  StudyCounting(const LessonOutline& own, const StudyPartOutline& part, StudyScore& into)
      : part_(part), into_(into), first_attempt_(into.attempts == 0) {
    learn(own);
  }

  void add(const Attempt& attempt) {
    ++into_.attempts;
    for (const AttemptEvent& event : attempt.events) {
      t_s_ = event.t_s;
      std::visit(*this, event.what);
    }
    endTouch();
    into_.time_s += attempt.end_s();
  }

  void operator()(const StepEntered&) { since_s_ = t_s_; }
  void operator()(const LessonReread& e) { learn(e.lesson); }
  void operator()(const Answered& e) {
    const auto item = items_.find({e.step, e.question});
    if (item == items_.end()) return;
    // Only the first attempt at a test counts.
    if (part_.test() && !first_attempt_) return;
    const bool first = !into_.answers.contains(item->second);
    StudyAnswer& answer = into_.answers[item->second];
    if (first) answer.seconds = std::max(0.0, t_s_ - since_s_);
    since_s_ = t_s_;
    ++answer.tries;
    if (!first && !part_.test()) return;
    answer.chosen = e.chosen;
    answer.written = e.written;
    answer.right = e.right;
    answer.by = e.by;
  }
  void operator()(const TaskDone& e) {
    const auto kind = kinds_.find({e.step, e.task});
    for (const StudyTask& done : into_.tasks)
      if (done.step == e.step && done.index == e.task && done.solved) return;
    into_.tasks.push_back(
        {e.step, e.task, kind == kinds_.end() ? std::string() : kind->second, e.solved, e.took_s, e.by, e.figures});
  }
  void operator()(const HintOpened&) { ++into_.hints; }
  void operator()(const TouchBegan&) { endTouch(); }
  void operator()(const TouchSoFar& e) {
    if (open_ && open_->from_s != e.from_s) endTouch();
    open_ = e;
    open_at_s_ = t_s_;
  }
  void operator()(const TouchEnded& e) {
    if (open_ && open_->from_s == e.from_s) open_.reset();
    count(e, t_s_);
  }
  void operator()(const Resumed&) {
    endTouch();
    since_s_ = t_s_;
  }
  void operator()(const auto&) {}

 private:
  // A question is the same in every language and condition by its place among the part's questions.
  void learn(const LessonOutline& lesson) {
    items_.clear();
    std::size_t k = 0;
    const bool same = questionsIn(lesson) == part_.questions.size();
    for (const StepOutline& step : lesson.steps) {
      for (const QuestionOutline& question : step.questions) {
        std::size_t item = k++;
        if (!same) {
          const auto known = std::find_if(part_.questions.begin(), part_.questions.end(),
                                          [&](const StudyItem& i) { return i.id == step.id + "/" + question.id; });
          if (known == part_.questions.end()) continue;
          item = std::size_t(known - part_.questions.begin());
        }
        items_[{step.id, question.id}] = item;
      }
      for (std::size_t t = 0; t < step.tasks.size(); ++t) kinds_[{step.id, t}] = step.tasks[t].kind;
    }
  }
  static std::size_t questionsIn(const LessonOutline& lesson) {
    std::size_t n = 0;
    for (const StepOutline& step : lesson.steps) n += step.questions.size();
    return n;
  }
  template <class TouchEvent>
  void count(const TouchEvent& e, double until_s) {
    ++into_.touches;
    into_.touch_s += std::max(0.0, until_s - e.from_s);
    into_.peak_N = std::max(into_.peak_N, e.peak_N);
    into_.path_A += e.path_A;
  }
  void endTouch() {
    if (open_) count(*std::exchange(open_, std::nullopt), open_at_s_);
  }

  const StudyPartOutline& part_;
  StudyScore& into_;
  const bool first_attempt_;
  std::map<std::pair<std::string, std::string>, std::size_t> items_;
  std::map<std::pair<std::string, std::size_t>, std::string> kinds_;
  std::optional<TouchSoFar> open_;
  double t_s_ = 0.0, since_s_ = 0.0, open_at_s_ = 0.0;
};

// Takes out what could tell who somebody is.
void makeAnonymous(StudyScore& score) {
  constexpr std::size_t kDay = 10;  // "2026-11-21"
  score.began.resize(std::min(score.began.size(), kDay));
  for (auto& [item, answer] : score.answers)
    if (!answer.right) answer.written = wordsLeftOut(answer.written);
}

}  // namespace

std::size_t StudyScore::right() const {
  return std::size_t(std::count_if(answers.begin(), answers.end(), [](const auto& a) { return a.second.right; }));
}

std::optional<double> StudyStudent::share(const StudyPartOutline& part) const {
  const auto found = parts.find(part.part);
  if (found == parts.end() || part.questions.empty()) return std::nullopt;
  return double(found->second.right()) / double(part.questions.size());
}

const StudyPartOutline* StudyData::find(const std::string& part) const {
  for (const StudyPartOutline& p : parts)
    if (p.part == part) return &p;
  return nullptr;
}

AnswerMatrix StudyData::answers(const StudyPartOutline& part, const std::string& group) const {
  AnswerMatrix out;
  for (const StudyStudent& s : students) {
    const auto score = s.parts.find(part.part);
    if (score == s.parts.end() || (!group.empty() && s.group != group)) continue;
    std::vector<char>& row = out.emplace_back(part.questions.size(), char(0));
    for (const auto& [item, answer] : score->second.answers) row[item] = answer.right;
  }
  return out;
}

std::string StudyCount::nameOf(const std::string& student) {
  if (student.empty()) return trf("(no code {0})", ++nameless_);
  const auto [known, is_new] = names_.try_emplace(student, student);
  if (is_new && anonymous_) {
    char code[24];
    std::snprintf(code, sizeof code, "S%02zu", names_.size());
    known->second = code;
  }
  return known->second;
}

void StudyCount::add(const Attempt& attempt) {
  const LessonOutline& lesson = attempt.header.lesson;
  if (lesson.study.study.empty()) {
    ++out_.others;
    return;
  }
  if (std::find(studies_.begin(), studies_.end(), lesson.study.study) == studies_.end())
    studies_.push_back(lesson.study.study);
  ++out_.attempts;
  auto part = std::find_if(out_.parts.begin(), out_.parts.end(),
                           [&](const StudyPartOutline& p) { return p.part == lesson.study.part; });
  if (part == out_.parts.end()) part = out_.parts.insert(part, partOf(lesson));
  const std::string name = nameOf(attempt.header.student);
  const auto [known, is_new] = students_.try_emplace(name, out_.students.size());
  if (is_new) out_.students.push_back({name, {}, {}});
  StudyStudent& student = out_.students[known->second];
  const std::string& group = lesson.study.group;
  if (!group.empty() && student.group.empty()) student.group = group;
  if (!group.empty() && student.group != group)
    out_.notes.push_back(
        trf("{0} has worked in the groups {1} and {2}. The first one counts.", name, student.group, group));
  StudyScore& score = student.parts[lesson.study.part];
  if (score.attempts == 1 && lesson.test)
    out_.notes.push_back(trf("{0} has done the test '{1}' more than once. The first time counts.", name, part->part));
  if (score.attempts == 0) {
    score.began = attempt.header.began;
    score.condition = moltact::nameOf(lesson.condition);
    score.group = group;
  }
  StudyCounting(lesson, *part, score).add(attempt);
}

Expected<StudyData> StudyCount::finish() {
  if (studies_.empty())
    return Problem{"", 0, 0, tr("these attempts belong to no study"),
                   tr("name the results of pages that 'moltact study' made, or leave out --study")};
  if (studies_.size() > 1)
    return Problem{"", 0, 0, trf("these attempts belong to several studies: {0}, {1}", studies_[0], studies_[1]),
                   tr("name the results of one study at a time")};
  out_.name = studies_.front();
  if (anonymous_)
    for (StudyStudent& student : out_.students)
      for (auto& [part, score] : student.parts) makeAnonymous(score);
  std::stable_sort(out_.parts.begin(), out_.parts.end(), [](const StudyPartOutline& a, const StudyPartOutline& b) {
    return std::pair(rankOf(a.part), a.part) < std::pair(rankOf(b.part), b.part);
  });
  std::stable_sort(out_.students.begin(), out_.students.end(),
                   [](const StudyStudent& a, const StudyStudent& b) { return a.name < b.name; });
  std::map<std::string, std::string> groups;
  for (const StudyStudent& s : out_.students) {
    if (s.group.empty()) continue;
    std::string& condition = groups[s.group];
    for (const auto& [part, score] : s.parts)
      if (score.group == s.group && part.starts_with("lesson")) condition = score.condition;
  }
  for (const auto& [group, condition] : groups) {
    out_.groups.push_back(group);
    out_.conditions.push_back(condition);
  }
  return std::move(out_);
}

}  // namespace moltact
