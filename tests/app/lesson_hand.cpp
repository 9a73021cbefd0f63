#include "tests/app/lesson_hand.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/key_focus.h"
#include "engine/device/pointer_hand.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

constexpr int kAttempts = 24;       // in a row that bring a task no further
constexpr double kSeen = 0.5;       // a slide continues while the surface faces the viewer this much (cosine)
constexpr double kAsItIs = 0.95;    // the view is kept if the place faces the viewer this much (cosine)
constexpr double kPastRim_A = 3.0;  // a hand farther from its place than this is on another atom
constexpr double kSame_A = 0.1;     // sideways: nearer than this a plan only pushes deeper

// With MOLTACT_LESSON_PICTURES a picture of each task as it was done, for people to look at.
void takePicture(ScriptedUser& d, const std::string& name) {
  const char* folder = std::getenv("MOLTACT_LESSON_PICTURES");
  if (!folder) return;
  if (const auto problem = writePng(std::string(folder) + "/" + name + ".png", d.picture()))
    std::fputs(problem->text().c_str(), stderr);
}

std::string unitText(const AnswerSpec& answer) {
  if (answer.kind == AnswerSpec::Kind::Text && !answer.texts.empty()) return answer.texts.front();
  if (answer.kind != AnswerSpec::Kind::Number) return "By touch.";
  char number[32];
  std::snprintf(number, sizeof number, "%.6g", answer.number);
  return number;
}

}  // namespace

LessonSession& LessonHand::session() const { return *d_.app().lesson.session(); }

double LessonHand::N_per_A() const {
  const ServoSettings& s = d_.app().scene.servo_settings;
  return s.stiffness_N_per_mm / s.workspace.A_per_mm;
}

bool LessonHand::canBegin() {
  std::string reported;
  for (const Message& m : d_.app().messages.all()) reported += ": " + m.text;
  if (!d_.app().lesson.session())
    failed_ += "no lesson is open" + reported + '\n';
  else if (!d_.app().scene.stage())
    failed_ += "nothing is on the stage" + reported + '\n';
  else
    return true;
  return false;
}

bool LessonHand::finishLesson() {
  for (;;) {
    // Both could go with any step: a lesson that is not there, a molecule that cannot be read.
    if (!canBegin()) return false;
    d_.frames(5);
    const std::string step = session().step().id;
    for (std::size_t t = 0; t < session().step().tasks.size(); ++t) {
      if (errs_) doWrongly(t);
      const bool done = doTask(t);
      takePicture(d_, d_.app().lesson.file().stem().string() + "-" + std::to_string(session().stepIndex()) + "-" +
                          std::to_string(t) + (mouse() ? "-mouse" : "-keys"));
      lift();
      if (done) continue;
      failed_ += step + ", task " + std::to_string(t + 1) + ": " + session().task(t).sentence + '\n';
      break;
    }
    for (std::size_t q = 0; q < session().step().questions.size(); ++q) {
      if (errs_) answerWrongly(q);
      answerCorrectly(q);
    }
    if (!session().hasNext()) return session().finished();
    if (mouse())
      d_.click("lesson/next");
    else
      d_.tap("Alt+Right");
    d_.frames(10);
  }
}

bool LessonHand::isCurrent(std::size_t task) const { return session().currentTask() == task; }

HandPlanInput LessonHand::planInput(int attempt) const {
  const TouchableModel& stage = d_.app().scene.stage();
  HandPlanInput input{.spheres = *stage.spheres,
                      .probe_A = d_.app().scene.servo_settings.probe_A,
                      .N_per_A = N_per_A(),
                      .hip = d_.app().scene.log().latest().hip,
                      .attempt = attempt,
                      .body = stage.body.get(),
                      .orientation = bodyTurned()};
  for (const auto& [share, spheres] : structures_) input.structures.push_back({share, spheres.get()});
  return input;
}

double LessonHand::figure(std::size_t task, std::string_view name) const {
  for (const TaskFigure& f : session().taskFigures(task))
    if (f.name == name) return f.value;
  return 0.0;
}

void LessonHand::expect(bool held, const std::string& what) {
  if (held)
    ++wrong_answers_;
  else
    failed_ += session().step().id + ", " + what + '\n';
}

HandPlan LessonHand::wrongPlan(std::size_t task) const {
  const TaskSpec& spec = session().step().tasks[task];
  const HandPlanInput input = planInput(0);
  HandPlan plan;
  if (spec.kind == "find") {
    const std::vector<std::uint32_t> target = spec.values["find"].selection.select(*session().molecule());
    constexpr double kElsewhere_A = 4.0;
    const auto elsewhere = [&](const SurfacePlace& p) {
      return std::all_of(target.begin(), target.end(), [&](std::uint32_t a) {
        return glm::distance(p.scp_A, input.spheres[a].centre_A) >
               input.spheres[a].radius_A + input.probe_A + kElsewhere_A;
      });
    };
    // What lies round the place is near the middle of the view.
    std::vector<std::uint32_t> round;
    for (const std::uint32_t a : target)
      input.spheres.visitNear(input.spheres[a].centre_A, 12.0,
                              [&](std::uint32_t b, const Sphere&) { round.push_back(b); });
    std::sort(round.begin(), round.end());
    round.erase(std::unique(round.begin(), round.end()), round.end());
    const std::vector<SurfacePlace> places = openPlaces(input, round, Feature::Sphere, 1, elsewhere);
    if (places.empty()) return plan;
    const bool rests = spec.values["by"].text == "hold";
    comeTo(plan, places.front(), depthFor(input, 0.3), rests ? 2.6 : 0.3);
    if (!rests) plan.push_back({.answer = TaskAnswer{.word = "here"}});
  } else if (spec.kind == "same" || spec.kind == "fit") {
    plan = session().taskAt(task)->demonstrate(input);
    const double smaller_A = spec.kind == "fit" ? 4.0 * spec.values["within"].number : 0.0;
    for (std::size_t k = 0; k < plan.size(); ++k) {
      HandAct& act = plan[k];
      // A smaller probe lies deeper.
      if (act.to && !act.placed && k > 0 && plan[k - 1].to && act.to->A != plan[k - 1].to->A)
        act.to->A += smaller_A * glm::normalize(act.to->A - plan[k - 1].to->A);
      if (!act.answer) continue;
      if (act.answer->number) *act.answer->number -= smaller_A;
      if (act.answer->word == "same" || act.answer->word == "different")
        act.answer->word = act.answer->word == "same" ? "different" : "same";
    }
  } else if (spec.kind == "measure") {
    const AtomSet other(spec.values["to"].selection, *session().molecule());
    const std::vector<SurfacePlace> places = openPlaces(input, other.atoms(), Feature::Sphere, 1);
    if (places.empty()) return plan;
    comeTo(plan, places.front(), depthFor(input, 0.3), 0.3);
    plan.push_back({.answer = TaskAnswer{.word = "mark"}});
  }
  return plan;
}

void LessonHand::doWrongly(std::size_t task) {
  const TaskSpec& spec = session().step().tasks[task];
  // A round of pairs forgives one; where it forgives none it would have to be felt twice.
  const bool same = spec.kind == "same";
  if (same && spec.values["right"].number + 1 > spec.values["trials"].number) return;
  constexpr int kTries = 4;
  for (int tries = 0; tries < kTries && isCurrent(task); ++tries) {
    const HandPlan plan = wrongPlan(task);
    if (plan.empty()) return;
    const std::string before = session().task(task).sentence;
    follow(plan, task);
    lift();
    d_.frames(3);
    if (!isCurrent(task)) break;
    const bool reported = spec.kind == "measure" ? session().task(task).sentence != before
                          : same                 ? figure(task, "trials") == 1.0 && figure(task, "right") == 0.0
                                                 : figure(task, "guesses") >= 1.0;
    if (!reported) continue;
    expect(session().task(task).progress < 1.0, "task done wrongly");
    return;
  }
  expect(false, "task " + std::to_string(task + 1) + " could not be done wrongly: " + session().task(task).sentence);
}

bool LessonHand::doTask(std::size_t task) {
  double best = -1.0;
  if (d_.app().scene.stage().body) lookAtStates();
  for (int attempt = 0, idle = 0; isCurrent(task) && idle < kAttempts; ++attempt, ++idle) {
    follow(session().taskAt(task)->demonstrate(planInput(attempt)), task);
    if (!isCurrent(task)) return true;
    const double progress = session().task(task).progress;
    if (progress > best) best = progress, idle = -1;
  }
  return !isCurrent(task);
}

void LessonHand::follow(const HandPlan& plan, std::size_t task) {
  if (followWithBody(plan, task)) return;
  for (std::size_t k = 0; k < plan.size() && isCurrent(task); ++k) {
    const HandAct& act = plan[k];
    if (act.share) moveStates(*act.share);
    if (!act.method.empty()) useMethod(act.method);
    if (act.to && act.placed) {
      lift();
      if (act.answer && act.answer->number) slideTo(task, *act.answer->number);
      // The whole slide is to be seen from the front, its first place above all.
      const Vec3 first = k + 1 < plan.size() && plan[k + 1].to ? plan[k + 1].to->A : act.to->A;
      Vec3 front = act.to->A - first;
      for (std::size_t n = k + 2; n < plan.size() && plan[n].to && !plan[n].placed && n < k + 12; ++n)
        front += 0.5 * outward(plan[n].to->A);
      if (glm::dot(front, act.to->A - first) < kSeen * glm::length(front) * glm::distance(act.to->A, first))
        front = act.to->A - first;
      face(front);
      pointAt(first);
      continue;
    }
    if (act.to) {
      const Vec3 deeper = k > 0 && plan[k - 1].to ? plan[k - 1].to->A - act.to->A : Vec3(0.0);
      const Vec3 front = outward(act.to->A);
      const bool began = k > 0 && plan[k - 1].placed,
                 straight = !began && glm::length(deeper - front * glm::dot(deeper, front)) < kSame_A;
      if (began) press();
      if (began || straight) {
        // A plan comes to a place from 1 A outside.
        const double depth_A = began ? glm::length(deeper) - 1.0 : glm::dot(deeper, front) + pushed_N_ / N_per_A();
        push(depth_A * N_per_A());
      } else {
        if (glm::dot(front, d_.app().scene.camera.back()) < kSeen) {
          // A ridge may stand before the place: it is looked at from where it is to be seen.
          const Vec3 from = openFrom(plan, k);
          if (glm::dot(from, d_.app().scene.camera.back()) < kAsItIs) {
            lift();
            face(from);
            pointAt(act.to->A);
            press();
          }
        }
        lead(act.to->A, task);
        // Past a rim the pointer is on what lies behind: the place is looked at from straight before it.
        if (isCurrent(task) && glm::distance(d_.app().scene.controls.lead().A, act.to->A) > kPastRim_A) {
          lift();
          face(front);
          pointAt(act.to->A);
          press();
        }
      }
    }
    for (int n = 0; n < int(act.wait_s * 60.0) + 1 && isCurrent(task); ++n) {
      d_.frames(1);
      if (watch) watch();
    }
    if (act.answer && isCurrent(task)) tell(task, *act.answer);
  }
}

void LessonHand::pick(std::size_t q, std::size_t choice) {
  if (mouse()) {
    d_.click("question/" + std::to_string(q) + "/" + std::to_string(choice));
    return;
  }
  const std::vector<std::size_t> order = session().choiceOrder(q);
  const auto place = std::find(order.begin(), order.end(), choice) - order.begin();
  readQuestion(d_, q);
  lookAt(d_, "question/" + std::to_string(q) + "/" + std::to_string(choice));
  d_.tap(std::to_string(place + 1));
}

void LessonHand::handIn(std::size_t q) {
  const std::string check = "question/" + std::to_string(q) + "/check";
  if (mouse()) {
    d_.click(check);
    return;
  }
  const bool chosen = !session().step().questions[q].choices.empty();
  if (chosen) lookAt(d_, check);
  d_.tap(session().step().questions[q].free() ? "Ctrl+Enter" : "Enter");
}

void LessonHand::writeIn(std::size_t q, const std::string& text) {
  const std::string name = "question/" + std::to_string(q);
  if (mouse()) {
    d_.click(name + "/field");
  } else {
    lookAt(d_, name);
    lookAt(d_, name + "/field");
    d_.tap("A");
  }
  d_.frames(3);
  if (session().question(q).attempts > 0) d_.tap("Ctrl+A");
  d_.type(text);
  handIn(q);
}

void LessonHand::answerWrongly(std::size_t q) {
  const Question& asked = session().step().questions[q];
  if (asked.prediction || asked.free() || session().question(q).done()) return;
  const auto reported = [&](const std::string& what) {
    d_.frames(3);
    const QuestionStatus& now = session().question(q);
    expect(now.attempts > 0 && !now.last_right && !now.answered_right && session().feedbackVisible(q),
           "question " + std::to_string(q + 1) + ": " + what + " is not told to be wrong");
  };
  if (asked.choices.empty()) {
    const AnswerSpec& answer = *asked.answer;
    char number[32];
    std::snprintf(number, sizeof number, "%.6g", answer.number + 2.0 * answer.tolerance + 1.0);
    writeIn(q, answer.kind == AnswerSpec::Kind::Number ? number : "nothing like it");
    return reported("another answer");
  }
  const bool several = asked.rightChoices() > 1;
  for (std::size_t k = 0; k < asked.choices.size(); ++k) {
    if (asked.choices[k].right) continue;
    if (asked.attempts > 0 && session().question(q).attempts + 1 >= asked.attempts)
      return;  // the last is the right one
    pick(q, k);
    if (several) handIn(q);
    reported(plainText(asked.choices[k].text));
    if (several) pick(q, k);
  }
}

void LessonHand::answerCorrectly(std::size_t q) {
  if (session().question(q).answered_right) return;
  const Question& asked = session().step().questions[q];
  if (asked.choices.empty()) {
    writeIn(q, unitText(*asked.answer));
  } else {
    for (std::size_t k = 0; k < asked.choices.size(); ++k)
      if (asked.choices[k].right) pick(q, k);
    if (asked.rightChoices() > 1) handIn(q);
  }
  d_.frames(3);
  if (!session().question(q).answered_right)
    failed_ += session().step().id + ", question " + std::to_string(q + 1) + '\n';
}

void LessonHand::tell(std::size_t task, const TaskAnswer& answer) {
  const std::string name = "task/" + std::to_string(task);
  if (answer.word.empty()) return draw(name, answer.curve, session().taskAt(task)->curves()->max_N);
  // With a mouse the hand has to let go before clicking.
  if (mouse()) lift();
  for (const TaskButton& b : session().taskAt(task)->buttons()) {
    if (b.word != answer.word) continue;
    if (!mouse()) lookAt(d_, name + "/" + std::string(b.word));
    if (mouse())
      d_.click(name + "/" + std::string(b.word));
    else
      d_.tap(b.key == '\n' ? std::string("Enter") : std::string(1, b.key));
    break;
  }
  lift();
  d_.frames(3);
}

void LessonHand::slideTo(std::size_t task, double value) {
  const std::optional<TaskSlider> asked = session().taskAt(task)->slider();
  if (!asked) return;
  const std::string name = "task/" + std::to_string(task) + "/slider";
  if (mouse()) {
    d_.point(name, (value - asked->min) / (asked->max - asked->min), 0.5);
    d_.press();
    d_.frames(2);
    d_.release();
    d_.frames(2);
    return;
  }
  for (int stops = 0; stops < 200 && controlOfKeys() != name; ++stops) {
    d_.tap("Tab");
    d_.frames(2);
  }
  const int steps = static_cast<int>(std::lround((value - asked->value) / asked->step));
  for (int k = 0; k < std::abs(steps); ++k) {
    d_.tap(steps > 0 ? "Right" : "Left");
    d_.frames(2);
  }
  d_.tap("Escape");  // the keys are the molecule's again
  d_.frames(2);
}

void LessonHand::draw(const std::string& name, const std::vector<double>& curve, double max_N) {
  const double last = double(curve.size() - 1);
  if (mouse()) {
    d_.point(name + "/hand in");  // with the whole of the curve in sight
    for (std::size_t k = 0; k < curve.size(); ++k) {
      d_.point(name + "/curve", double(k) / last, 1.0 - curve[k] / max_N);
      if (k == 0) d_.press();
    }
    d_.release();
    d_.click(name + "/hand in");
    return;
  }
  constexpr double kStep = 0.025;
  double pen = 0.0;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    for (; pen < curve[k] / max_N - 0.5 * kStep; pen += kStep) d_.tap("Up");
    for (; pen > curve[k] / max_N + 0.5 * kStep; pen -= kStep) d_.tap("Down");
    d_.tap("Right");
  }
  lookAt(d_, name + "/hand in");
  d_.tap("Enter");
}

void LessonHand::useMethod(const std::string& name) {
  if (d_.app().scene.touch().method == name) return;
  if (!mouse()) {
    for (std::size_t k = 0; k < methods().size() && d_.app().scene.touch().method != name; ++k) d_.tap("M");
    return;
  }
  const Method& m = *findMethod(name);
  d_.click("tab/Methods");
  d_.click("method/" + std::string(m.family.name));
  d_.frames(2);
  if (!gradeText(m).empty() && d_.app().scene.touch().method != name) d_.click("grade/" + gradeText(m));
  d_.frames(2);
  if (!m.variant.empty() && d_.app().scene.touch().method != name) d_.click("variant/" + std::string(m.variant));
}

}  // namespace moltact
