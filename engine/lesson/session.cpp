#include "engine/lesson/session.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "engine/core/content_hash.h"
#include "engine/core/random.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/lesson/quantity.h"
#include "engine/lesson/scene_atoms.h"
#include "engine/lesson/scene_forces.h"
#include "engine/lesson/tasks/registry.h"
#include "engine/structure/interaction_input.h"

namespace moltact {
namespace {

std::string folded(std::string_view text) {
  std::string out(stripped(text));
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

// The number in the text, in the answer's unit.
std::optional<double> numberIn(const AnswerSpec& answer, const std::string& text) {
  auto number = parseNumber(text);
  if (!number)
    for (const Dimension d : {Dimension::Length, Dimension::Force, Dimension::Time, Dimension::Stiffness})
      if (answer.unit == codeUnit(d)) number = parseQuantity(text, d);
  if (!number) return std::nullopt;
  return *number;
}

bool isRight(const AnswerSpec& answer, double number) {
  // A tolerance of 0 still forgives the last bit of a decimal fraction.
  const double slack = answer.tolerance + 1e-9 * std::max(1.0, std::abs(answer.number));
  return std::abs(number - answer.number) <= slack;
}

bool sameShape(const Step& a, const Step& b) {
  if (a.id != b.id || a.tasks.size() != b.tasks.size() || a.questions.size() != b.questions.size()) return false;
  for (std::size_t i = 0; i < a.tasks.size(); ++i)
    if (a.tasks[i].kind != b.tasks[i].kind) return false;
  for (std::size_t i = 0; i < a.questions.size(); ++i)
    if (a.questions[i].id != b.questions[i].id || a.questions[i].choices.size() != b.questions[i].choices.size() ||
        a.questions[i].prediction != b.questions[i].prediction)
      return false;
  return true;
}

}  // namespace

std::string rightAnswer(const Question& asked) {
  std::string out;
  for (const Choice& c : asked.choices)
    if (c.right) out += (out.empty() ? "" : "; ") + plainText(c.text);
  if (!asked.answer) return out;
  if (asked.answer->kind == AnswerSpec::Kind::Text) return asked.answer->texts.front();
  return numberText(asked.answer->number, plain()) + (asked.answer->unit.empty() ? "" : "\u00a0" + asked.answer->unit);
}

LessonSession::StepState::StepState(const Step& step)
    : tasks_done(step.tasks.size(), 0), finished(step.tasks.size()), questions(step.questions.size()) {}

LessonSession::LessonSession(std::shared_ptr<const Lesson> lesson) : lesson_(std::move(lesson)) {
  for (const Step& s : lesson_->steps) states_.emplace_back(s);
  enter(0);
}

void LessonSession::enter(std::size_t step) {
  if (step != step_)
    for (QuestionStatus& q : state().questions) q.left_since_answer = true;
  // Another molecule is being read; the tasks wait for it.
  if (step != step_ && lesson_->steps[step].scene.molecule != scene().molecule) molecule_ = nullptr;
  step_ = step;
  if (!lesson_->steps[step].aside) main_step_ = step;
  ++scene_number_;
  hints_ = 0;
  meet(step);
  makeTasks();
  reportStep();
}

void LessonSession::meet(std::size_t step) {
  states_[step].seen = true;
  if (std::find(visited_steps_.begin(), visited_steps_.end(), step) == visited_steps_.end())
    visited_steps_.push_back(step);
}

void LessonSession::makeTasks() {
  tasks_.clear();
  slide_.restart();
  slid_.clear();
  const std::vector<std::uint32_t> untouchable =
      molecule_ ? untouchableAtoms(scene(), *molecule_) : std::vector<std::uint32_t>();
  const std::shared_ptr<const HeldBody> body =
      molecule_ ? heldBody(*molecule_, heldAtoms(scene(), *molecule_)) : nullptr;
  const std::shared_ptr<const SceneForces> forces =
      step().tasks.empty() ? nullptr : sceneForces(scene(), molecule_, untouchable, body);
  for (const TaskSpec& spec : step().tasks) {
    tasks_.push_back(molecule_ ? makeTask(spec, *molecule_) : nullptr);
    if (tasks_.back() && !untouchable.empty()) tasks_.back()->leaveOut(untouchable);
    if (tasks_.back()) tasks_.back()->takeLesson(lesson_->file, *molecule_);
    if (tasks_.back() && body) tasks_.back()->takeInHand(body);
    if (tasks_.back() && forces) tasks_.back()->takeForces(forces);
  }
  if (molecule_) ++state().made;
  for (std::size_t k = 0; k < tasks_.size(); ++k)
    if (tasks_[k]) tasks_[k]->drawBy(drawSeed(k));
}

// A student who returns to a step or resumes the lesson meets another order than before.
std::uint64_t LessonSession::drawSeed(std::size_t task) const {
  return mixedSeed(mixedSeed(order_seed_, hash64(step().id) + task), (std::uint64_t(sitting_) << 32) + state().made);
}

void LessonSession::setOrderSeed(std::uint64_t seed, std::size_t sitting) {
  order_seed_ = seed;
  sitting_ = sitting;
  for (std::size_t k = 0; k < tasks_.size(); ++k)
    if (tasks_[k]) tasks_[k]->drawBy(drawSeed(k));
}

void LessonSession::setMolecule(std::shared_ptr<const Molecule> molecule) {
  if (molecule == molecule_) return;
  molecule_ = std::move(molecule);
  makeTasks();
}

std::size_t LessonSession::currentTask() const {
  const std::vector<char>& done = state().tasks_done;
  return static_cast<std::size_t>(std::find(done.begin(), done.end(), 0) - done.begin());
}

void LessonSession::feed(const TouchSample& sample) {
  std::size_t i = currentTask();
  if (i >= tasks_.size() || !tasks_[i]) return;
  keepSlide(sample);
  feedTask(i, sample);
  keepIfDone(i);
  // One slide may complete several tasks: the next task starts where the slide began.
  for (std::size_t next = currentTask(); next != i && next < tasks_.size() && tasks_[next]; next = currentTask()) {
    i = next;
    if (!tasks_[i]->takesUpSlide() || tasks_[i]->stage() != TaskStage()) return;
    for (const TouchSample& s : slid_) feedTask(i, s);
    keepIfDone(i);
  }
}

void LessonSession::feedTask(std::size_t task, const TouchSample& sample) {
  const CurveState before = curveState(*tasks_[task]);
  tasks_[task]->feed(sample);
  reportCurves(task, before);
}

void LessonSession::keepSlide(const TouchSample& sample) {
  constexpr double kBetween_s = 0.008;
  constexpr std::size_t kMax = 4000;
  const double dt_s = slid_.empty() ? 0.0 : std::max(0.0, sample.time_s - slid_.back().time_s);
  if (!slid_.empty() && dt_s < kBetween_s && sample.contact.feature == slid_.back().contact.feature) return;
  if (slide_.tick(sample.contact, dt_s)) slid_.clear();
  if (slid_.size() >= kMax) slid_.erase(slid_.begin(), slid_.begin() + kMax / 2);
  if (sample.contact.touching() || !slid_.empty()) slid_.push_back(sample);
}

void LessonSession::keepIfDone(std::size_t task) {
  if (!tasks_[task]->done()) return;
  state().tasks_done[task] = tasks_[task]->solved() ? kSolved : kShown;
  state().finished[task] = tasks_[task];
  reportFinished(task);
}

std::vector<std::uint32_t> LessonSession::shownAtoms() const {
  std::vector<std::uint32_t> out;
  for (std::size_t k = 0; k < state().finished.size(); ++k)
    if (const auto& task = state().finished[k]; task && !task->solved()) {
      const std::vector<std::uint32_t> atoms = task->answerAtoms();
      out.insert(out.end(), atoms.begin(), atoms.end());
    }
  if (const Task* now = taskAt(currentTask()); now && !now->done()) {
    const std::vector<std::uint32_t> atoms = now->exampleAtoms();
    out.insert(out.end(), atoms.begin(), atoms.end());
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

const Task* LessonSession::taskAt(std::size_t index) const {
  if (index >= tasks_.size()) return nullptr;
  return state().finished[index] ? state().finished[index].get() : tasks_[index].get();
}

TaskStage LessonSession::taskStage() const {
  const Task* now = taskAt(currentTask());
  return now ? now->stage() : TaskStage();
}

std::optional<TaskGuide> LessonSession::taskGuide() const {
  const Task* now = taskAt(currentTask());
  return now ? now->guide() : std::nullopt;
}

void LessonSession::answerTask(const TaskAnswer& answer) {
  const std::size_t i = currentTask();
  if (i >= tasks_.size() || !tasks_[i]) return;
  const CurveState before = curveState(*tasks_[i]);
  tasks_[i]->answer(answer);
  reportCurves(i, before);
  keepIfDone(i);
}

std::vector<TaskFigure> LessonSession::taskFigures(std::size_t index) const {
  const Task* task = taskAt(index);
  return task ? task->figures() : std::vector<TaskFigure>();
}

std::vector<TaskFigure> LessonSession::figuresOf(std::size_t step, std::size_t task) const {
  const auto& finished = states_[step].finished[task];
  return finished ? finished->figures() : std::vector<TaskFigure>();
}

void LessonSession::feed(std::span<const TouchSample> samples) {
  for (const TouchSample& s : samples) feed(s);
}

TaskStatus LessonSession::task(std::size_t index) const {
  TaskStatus out;
  out.done = taskDone(step_, index);
  out.solved = taskSolved(step_, index);
  out.current = !out.done && index == currentTask();
  out.say = step().tasks[index].values["say"].text;
  if (out.done) {
    out.progress = 1.0;
    out.sentence =
        out.solved ? AuthorsText(step().tasks[index].values["praise"]).text() : tr("The tries are used up. Go on.");
    if (state().finished[index]) out.sentence = state().finished[index]->sentence();
  } else if (out.current && tasks_[index]) {
    out.progress = tasks_[index]->progress();
    out.sentence = tasks_[index]->sentence();
  }
  return out;
}

void LessonSession::restartTask(std::size_t index) {
  if (index >= tasks_.size()) return;
  state().tasks_done[index] = 0;
  state().finished[index].reset();
  if (tasks_[index]) tasks_[index]->reset();
  reportTask();
}

std::vector<std::size_t> LessonSession::choiceOrder(std::size_t question) const {
  const Question& asked = step().questions[question];
  std::vector<std::size_t> out(asked.choices.size());
  std::iota(out.begin(), out.end(), std::size_t{0});
  if (order_seed_ == 0 || asked.in_order) return out;
  std::uint64_t state = order_seed_ ^ hash64(step().id + '/' + asked.id);
  // Fisher-Yates shuffle.
  for (std::size_t k = out.size(); k > 1; --k) std::swap(out[k - 1], out[nextRandom(state) % k]);
  return out;
}

bool LessonSession::feedbackVisible(std::size_t question) const {
  if (this->question(question).attempts == 0 || lesson_->test) return false;
  const std::vector<char>& done = state().tasks_done;
  return !step().questions[question].prediction || std::all_of(done.begin(), done.end(), [](char d) { return d != 0; });
}

bool LessonSession::takesAnswer(std::size_t question) const {
  if (lesson_->test) return true;
  if (step().questions[question].prediction) return !feedbackVisible(question);
  const QuestionStatus& status = this->question(question);
  const auto leads = leadsTo(question);
  return !status.done() && !(leads && !status.left_since_answer && status.attempts > 0);
}

std::optional<int> LessonSession::triesLeft(std::size_t question) const {
  const int limit = step().questions[question].attempts;
  if (limit == 0) return std::nullopt;
  return std::max(0, limit - this->question(question).attempts);
}

void LessonSession::record(std::size_t question, bool right) {
  QuestionStatus& status = state().questions[question];
  const bool done_before = status.done();
  std::vector<char> rules;  // those that hold
  for (std::size_t r = 0; r < step().questions[question].rules.size(); ++r)
    rules.push_back(ruleHolds(step_, question, r));
  ++status.attempts;
  status.last_right = right;
  status.answered_right = status.answered_right || right || step().questions[question].prediction || lesson_->test;
  status.again.clear();
  status.left_since_answer = false;
  const int limit = step().questions[question].attempts;
  status.shown = limit > 0 && !status.answered_right && status.attempts >= limit;
  reportAnswer(question, done_before, rules);
}

bool LessonSession::choose(std::size_t question, std::vector<std::size_t> choices) {
  if (!takesAnswer(question)) return false;
  const std::vector<Choice>& there = step().questions[question].choices;
  std::sort(choices.begin(), choices.end());
  choices.erase(std::unique(choices.begin(), choices.end()), choices.end());
  bool right = choices.empty() || choices.back() < there.size();
  for (std::size_t i = 0; i < there.size(); ++i)
    right = right && there[i].right == std::binary_search(choices.begin(), choices.end(), i);
  std::erase_if(choices, [&](std::size_t i) { return i >= there.size(); });
  state().questions[question].chosen = std::move(choices);
  record(question, right);
  return right;
}

bool LessonSession::write(std::size_t question, std::string text) {
  const auto& answer = step().questions[question].answer;
  if (!answer || stripped(text).empty()) return false;
  // A free answer may be changed.
  if (!step().questions[question].free() && !takesAnswer(question)) return false;
  bool right = true;
  if (answer->kind == AnswerSpec::Kind::Number) {
    const auto number = numberIn(*answer, text);
    if (!number) {
      state().questions[question].again =
          answer->unit.empty()
              ? trf("'{0}' is no number. Write one, for example 12 or 0.5.", text)
              : trf("'{0}' is no number in {1}. Write one, for example 12 or 0.5.", text, answer->unit);
      return false;
    }
    right = isRight(*answer, *number);
  }
  if (answer->kind == AnswerSpec::Kind::Text)
    right = std::any_of(answer->texts.begin(), answer->texts.end(),
                        [&](const std::string& t) { return folded(t) == folded(text); });
  state().questions[question].written = std::move(text);
  record(question, right);
  return right;
}

std::vector<RichText> LessonSession::feedback(std::size_t question) const {
  std::vector<RichText> out;
  const QuestionStatus& status = state().questions[question];
  const Question& asked = step().questions[question];
  if (!feedbackVisible(question)) return out;
  if (asked.free()) {
    if (!asked.answer->model.empty()) out.push_back({TextRun{.text = asked.answer->model}});
    return out;
  }
  const auto say = [&](std::string text) { out.push_back({TextRun{.text = std::move(text)}}); };
  if (asked.answer) {
    // When the tries are used up, the program's own words must not ask for another try.
    if (status.last_right)
      say(asked.answer->right.text());
    else if (!status.shown || asked.answer->wrong.own())
      say(asked.answer->wrong.text());
  }
  for (const std::size_t i : status.chosen)
    if (!asked.choices[i].feedback.empty()) out.push_back(asked.choices[i].feedback);
  if (status.shown) {
    say(trf("That was the last try. Right is: {0}", rightAnswer(asked)));
    for (const Choice& c : asked.choices)
      if (c.right && !c.feedback.empty() && asked.rightChoices() == 1) out.push_back(c.feedback);
    return out;
  }
  if (!status.last_right && asked.rightChoices() > 1) say(tr("Look again: more than one is right."));
  if (const auto left = triesLeft(question); left && !status.answered_right)
    say(trnf("{0} try is left.", "{0} tries are left.", static_cast<std::size_t>(*left), *left));
  return out;
}

bool LessonSession::stepDone(std::size_t step) const {
  const StepState& s = states_[step];
  return std::all_of(s.tasks_done.begin(), s.tasks_done.end(), [](char d) { return d != kOpen; }) &&
         std::all_of(s.questions.begin(), s.questions.end(), [](const QuestionStatus& q) { return q.done(); });
}

LessonSession::Parts LessonSession::parts() const {
  Parts parts, steps;
  const std::vector<char> skipped = skippedSteps();
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (lesson_->steps[i].aside || skipped[i]) continue;
    const StepState& s = states_[i];
    parts.of += s.tasks_done.size() + s.questions.size();
    parts.done +=
        s.tasks_done.size() - static_cast<std::size_t>(std::count(s.tasks_done.begin(), s.tasks_done.end(), kOpen));
    for (const QuestionStatus& q : s.questions) parts.done += q.done();
    steps.done += s.seen;
    ++steps.of;
  }
  return parts.of ? parts : steps;
}

double LessonSession::progress() const {
  const Parts p = parts();
  return p.of ? static_cast<double>(p.done) / static_cast<double>(p.of) : 1.0;
}

bool LessonSession::finished() const { return progress() >= 1.0; }

void LessonSession::restore(const SessionMemory& memory) {
  for (const SessionMemory::StepMemory& remembered : memory.steps) {
    const auto index = lesson_->find(remembered.step);
    if (!index) continue;
    StepState& s = states_[*index];
    meet(*index);
    for (const std::size_t task : remembered.tasks_done)
      if (task < s.tasks_done.size()) s.tasks_done[task] = kSolved;
    for (const std::size_t task : remembered.tasks_shown)
      if (task < s.tasks_done.size()) s.tasks_done[task] = kShown;
    const std::vector<Question>& questions = lesson_->steps[*index].questions;
    for (const auto& [id, status] : remembered.questions)
      for (std::size_t q = 0; q < questions.size(); ++q) {
        if (questions[q].id != id) continue;
        s.questions[q] = status;
        if (questions[q].prediction || questions[q].free() || lesson_->test)
          s.questions[q].answered_right = status.attempts > 0;
        std::erase_if(s.questions[q].chosen, [&](std::size_t c) { return c >= questions[q].choices.size(); });
        const int limit = questions[q].attempts;
        s.questions[q].shown = limit > 0 && !s.questions[q].answered_right && s.questions[q].attempts >= limit;
      }
  }
  goTo(memory.step);
}

void LessonSession::replaceLesson(std::shared_ptr<const Lesson> lesson) {
  const std::shared_ptr<const Lesson> old = std::exchange(lesson_, std::move(lesson));
  std::vector<StepState> old_states = std::move(states_);
  states_.clear();
  for (const Step& s : lesson_->steps) {
    states_.emplace_back(s);
    if (const auto before = old->find(s.id); before && sameShape(old->steps[*before], s))
      states_.back() = std::move(old_states[*before]);
  }
  for (const std::size_t step : std::exchange(visited_steps_, {}))
    if (const auto now = lesson_->find(old->steps[step].id); now && states_[*now].seen) visited_steps_.push_back(*now);
  const Step& was = old->steps[step_];
  const std::size_t hints = hints_;
  const std::size_t now = lesson_->find(was.id).value_or(std::min(step_, lesson_->steps.size() - 1));
  if (lesson_->steps[now].scene.molecule != was.scene.molecule) molecule_ = nullptr;
  main_step_ = lesson_->find(old->steps[main_step_].id).value_or(0);
  if (lesson_->steps[main_step_].aside) main_step_ = 0;
  step_ = now;
  enter(now);
  if (lesson_->steps[now].id == was.id) hints_ = hints;
}

}  // namespace moltact
