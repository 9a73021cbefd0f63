#include "engine/lesson/scripted_learner/scripted_learner.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/lesson/second_state.h"

namespace moltact {

ScriptedLearner::ScriptedLearner(std::shared_ptr<const Lesson> lesson, MoleculeByName molecules, Watch watch,
                                 Options options)
    : session_(std::move(lesson)), by_name_(std::move(molecules)), watch_(std::move(watch)), options_(options) {}

LearnerEvent ScriptedLearner::event(LearnerEvent::Kind kind) const {
  LearnerEvent e;
  e.kind = kind;
  e.time_s = touch_.time_s();
  e.step = session_.step().id;
  e.index = session_.stepIndex();
  e.place = session_.step().place;
  return e;
}

bool ScriptedLearner::enterStep() {
  if (entered_ == session_.sceneNumber()) return on_stage_;
  entered_ = session_.sceneNumber();
  const SceneSpec& scene = session_.scene();
  LearnerEvent e = event(LearnerEvent::Kind::Step);
  e.text = session_.step().title;
  e.note = scene.molecule.name;
  watch_(e);
  const auto molecule = by_name_(scene.molecule);
  on_stage_ = bool(molecule);
  if (!on_stage_) {
    LearnerEvent fault = event(LearnerEvent::Kind::Fault);
    fault.note = molecule.problem().message;
    fault.place = scene.places.molecule;
    watch_(fault);
    return false;
  }
  std::shared_ptr<const Molecule> begins = *molecule;
  std::shared_ptr<const TwoStates> both;
  if (!scene.then.molecule.empty())
    if (const auto other = by_name_(secondMolecule(scene)))
      if (auto states = statesOf(scene, **molecule, **other))
        both = std::make_shared<const TwoStates>(*std::move(states));
  if (both && scene.then.share > 0.0)
    begins = std::make_shared<const Molecule>(begins->movedTo(both->at(scene.then.share)));
  session_.setMolecule(begins);
  touch_.begin(begins, scene);
  touch_.setStructures(both);
  touch_.setStage(session_.taskStage());
  task_begun_s_ = touch_.time_s();
  return true;
}

bool ScriptedLearner::timeIsUp() const { return touch_.time_s() - task_begun_s_ > options_.task_s; }

void ScriptedLearner::tick(const PoseA& hand) {
  const std::size_t task = session_.currentTask();
  touch_.setGuide(session_.taskGuide());
  session_.feed(touch_.tick(hand));
  if (session_.currentTask() != task) reportDone(task);
}

void ScriptedLearner::reportDone(std::size_t task) {
  const bool solved = session_.task(task).solved;
  LearnerEvent e = event(solved ? LearnerEvent::Kind::Task : LearnerEvent::Kind::GaveUp);
  e.index = task;
  e.place = session_.step().tasks[task].place;
  const TaskStatus status = session_.task(task);
  e.text = status.say;
  e.note = status.sentence;
  e.figures = session_.taskFigures(task);
  watch_(e);
  touch_.setStage(session_.taskStage());
  task_begun_s_ = touch_.time_s();
}

void ScriptedLearner::tell(const TaskAnswer& answer) {
  const std::size_t task = session_.currentTask();
  session_.answerTask(answer);
  if (session_.currentTask() != task)
    reportDone(task);
  else
    touch_.setStage(session_.taskStage());
}

void ScriptedLearner::follow(const HandPlan& plan) {
  if (!enterStep()) return;
  const std::size_t task = session_.currentTask();
  for (const HandAct& act : plan) {
    const auto running = [&] { return session_.currentTask() == task && !timeIsUp(); };
    if (!running()) return;
    if (!act.method.empty()) touch_.useMethod(act.method);
    if (act.share) touch_.moveTo(*act.share);
    while (touch_.moving() && running()) tick(touch_.hand());
    const HandWay way = wayOf(act, touch_.hand(), kTick_s);
    if (act.placed)
      touch_.place(way.to);
    else
      for (std::size_t k = 1; k <= way.ticks && running(); ++k) tick(way.at(k));
    const auto rest = static_cast<long>(std::lround(act.wait_s / kTick_s));
    for (long k = 0; k < rest && running(); ++k) tick(touch_.hand());
    if (act.answer && running()) tell(*act.answer);
  }
}

bool ScriptedLearner::doTask() {
  if (!enterStep()) return false;
  const std::size_t task = session_.currentTask();
  if (task >= session_.step().tasks.size()) return false;
  task_begun_s_ = touch_.time_s();
  double best = -1.0;
  std::string why;
  for (int attempt = 0, idle = 0; session_.currentTask() == task && idle < options_.attempts && !timeIsUp();
       ++attempt, ++idle) {
    const HandPlan plan = session_.taskAt(task)->demonstrate(touch_.view(attempt));
    if (plan.empty()) {
      why = tr(session_.taskAt(task)->noPlan());
      break;
    }
    follow(plan);
    if (session_.currentTask() != task) return true;
    // An attempt that advances the progress or gives an answer does not count as failed.
    const double progress = session_.task(task).progress;
    if (progress > best) {
      best = progress;
      idle = -1;
    }
  }
  if (session_.currentTask() != task) return true;
  LearnerEvent e = event(LearnerEvent::Kind::GaveUp);
  e.index = task;
  e.place = session_.step().tasks[task].place;
  const TaskStatus status = session_.task(task);
  e.text = status.say;
  if (why.empty())
    why = trf("not done after {0} of trying",
              quantityText(touch_.time_s() - task_begun_s_, Dimension::Time, decimals(0)));
  e.note = trf("{0}; the task says: {1}", why, status.sentence);
  e.figures = session_.taskFigures(task);
  watch_(e);
  return false;
}

void ScriptedLearner::reportAnswer(std::size_t question, const std::string& answer, bool right, int attempts_before) {
  LearnerEvent e = event(LearnerEvent::Kind::Question);
  e.index = question;
  e.place = session_.step().questions[question].place;
  e.text = plainText(session_.step().questions[question].title);
  e.answer = answer;
  e.right = right;
  const QuestionStatus& status = session_.question(question);
  e.taken = status.attempts > attempts_before;
  if (!e.taken) {
    e.note = !status.again.empty()            ? status.again
             : session_.takesAnswer(question) ? tr("the answer is empty")
                                              : tr("the question is answered and takes no other answer");
    return watch_(e);
  }
  for (const RichText& text : session_.feedback(question)) e.note += (e.note.empty() ? "" : " ") + plainText(text);
  watch_(e);
}

void ScriptedLearner::choose(std::size_t question, const std::vector<std::size_t>& choices) {
  const int before = session_.question(question).attempts;
  const bool right = session_.choose(question, choices);
  std::string answer;
  for (const std::size_t k : choices)
    if (const auto& there = session_.step().questions[question].choices; k < there.size())
      answer += (answer.empty() ? "" : "; ") + plainText(there[k].text);
  reportAnswer(question, answer, right, before);
}

void ScriptedLearner::write(std::size_t question, const std::string& text) {
  const int before = session_.question(question).attempts;
  reportAnswer(question, text, session_.write(question, text), before);
}

void ScriptedLearner::answerCorrectly(std::size_t question) {
  const Question& asked = session_.step().questions[question];
  if (asked.choices.empty() && asked.answer) {
    const AnswerSpec& answer = *asked.answer;
    char number[64];
    std::snprintf(number, sizeof number, "%.12g%s%s", answer.number, answer.unit.empty() ? "" : " ",
                  answer.unit.c_str());
    write(question, answer.kind == AnswerSpec::Kind::Number                          ? number
                    : answer.kind == AnswerSpec::Kind::Text && !answer.texts.empty() ? answer.texts.front()
                                                                                     : "An answer for the teacher.");
    return;
  }
  std::vector<std::size_t> right;
  for (std::size_t k = 0; k < asked.choices.size(); ++k)
    if (asked.choices[k].right) right.push_back(k);
  choose(question, right);
}

void ScriptedLearner::next() { session_.next(); }
void ScriptedLearner::back() { session_.back(); }
bool ScriptedLearner::goTo(const std::string& step) { return session_.mayGoTo(step) && session_.goTo(step); }

bool ScriptedLearner::demonstrate() {
  for (;;) {
    demonstrateStep();
    if (!session_.hasNext() || !session_.mayGoOn()) return session_.finished();
    next();
  }
}

void ScriptedLearner::demonstrateStepsLeft() {
  for (std::size_t s = 0; s < session_.lesson().steps.size(); ++s) {
    if (session_.stepSeen(s)) continue;
    session_.goTo(session_.lesson().steps[s].id);
    demonstrateStep();
  }
}

void ScriptedLearner::demonstrateStep() {
  enterStep();
  // A task that cannot be done blocks those after it; the questions and the other steps are still reachable.
  while (session_.currentTask() < session_.step().tasks.size())
    if (!doTask()) break;
  for (std::size_t q = 0; q < session_.step().questions.size(); ++q)
    if (session_.takesAnswer(q)) answerCorrectly(q);
}

}  // namespace moltact
