#include "engine/lesson/scripted_learner/answers_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine/haptics/methods.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/lesson/pose_text.h"
#include "engine/lesson/quantity.h"
#include "engine/lesson/suggestion.h"
#include "engine/lesson/tasks/task.h"

namespace moltact {
namespace {

using Kind = LearnerAct::Kind;

constexpr double kTouch_N = 0.3, kTouchFor_s = 0.5;

struct Verb {
  std::string_view name;
  Kind kind;
};
constexpr std::array kVerbs{
    Verb{"do", Kind::Do},     Verb{"touch", Kind::Touch},   Verb{"press", Kind::Press},   Verb{"slide", Kind::Slide},
    Verb{"wait", Kind::Wait}, Verb{"lift", Kind::Lift},     Verb{"method", Kind::Method}, Verb{"say", Kind::Say},
    Verb{"draw", Kind::Draw}, Verb{"answer", Kind::Answer}, Verb{"next", Kind::Next},     Verb{"back", Kind::Back},
    Verb{"go", Kind::Go},     Verb{"set", Kind::Set},       Verb{"pose", Kind::Pose},     Verb{"state", Kind::State}};

std::vector<std::string_view> parts(std::string_view text, char by) {
  std::vector<std::string_view> out;
  for (;;) {
    const std::size_t end = std::min(text.find(by), text.size());
    out.push_back(stripped(text.substr(0, end)));
    if (end == text.size()) return out;
    text.remove_prefix(end + 1);
  }
}

class LineReader {
 public:
  LineReader(std::string_view line, std::size_t number, const std::string& file)
      : line_(line), number_(number), file_(file) {}

  /// Returns nothing for an empty line; adds a problem to `problems` for a wrong one.
  std::optional<LearnerAct> read(std::vector<Problem>& problems) {
    const std::string_view body = stripped(line_.substr(0, line_.find('#')));
    if (body.empty()) return std::nullopt;
    const std::size_t end = std::min(body.find(' '), body.size());
    const std::string_view verb = body.substr(0, end), rest = stripped(body.substr(end));
    const auto known = std::find_if(kVerbs.begin(), kVerbs.end(), [&](const Verb& v) { return v.name == verb; });
    if (known == kVerbs.end()) {
      std::vector<std::string_view> names;
      for (const Verb& v : kVerbs) names.push_back(v.name);
      problems.push_back(at(verb, trf("there is no act '{0}'", verb), suggest(verb, names, tr("known"))));
      return std::nullopt;
    }
    LearnerAct act;
    act.kind = known->kind;
    act.line = number_;
    act.column = column(verb);
    if (const std::optional<Problem> wrong = fill(act, rest, body)) {
      problems.push_back(*wrong);
      return std::nullopt;
    }
    return act;
  }

 private:
  std::size_t column(std::string_view part) const {
    return part.data() < line_.data()
               ? 1
               : characterCount(line_.substr(0, static_cast<std::size_t>(part.data() - line_.data()))) + 1;
  }
  Problem at(std::string_view part, std::string message, std::string remedy) const {
    return {file_, number_, column(part), std::move(message), std::move(remedy)};
  }
  Problem within(std::string_view part, Problem p) const {
    p.file = file_;
    p.line = number_;
    p.column += column(part) - 1;
    return p;
  }

  std::optional<Problem> place(LearnerAct& act, std::string_view text) const {
    for (const std::string_view word : {"crease", "pit", "sphere", "anywhere"})
      if (text == word) {
        act.word = word == "anywhere" ? "" : std::string(word);
        return std::nullopt;
      }
    const auto selection = parseSelection(text);
    if (!selection) return within(text, selection.problem());
    act.place = *selection;
    return std::nullopt;
  }

  std::optional<Problem> quantity(double& number, std::string_view text, Dimension dimension) const {
    const auto read = parseQuantity(text, dimension);
    if (!read) return within(text, read.problem());
    if (*read < 0.0) return at(text, trf("'{0}' is less than nothing", text), tr("write a positive number"));
    number = *read;
    return std::nullopt;
  }

  std::optional<Problem> pose(LearnerAct& act, std::string_view text) const {
    const Expected<WrittenPose> read = parsePose(text);
    if (!read) return within(text, read.problem());
    act.to = read->place;
    act.turned_to = read->orientation;
    return std::nullopt;
  }

  std::optional<Problem> fill(LearnerAct& act, std::string_view rest, std::string_view body) const {
    const auto missing = [&](const char* what) {
      return at(body.substr(body.size()), trf("this act needs {0}", what), tr("write it at the end of the line"));
    };
    switch (act.kind) {
      case Kind::Do:
      case Kind::Lift:
      case Kind::Next:
      case Kind::Back:
        if (!rest.empty()) return at(rest, tr("nothing comes after this act"), tr("take it out"));
        return std::nullopt;
      case Kind::Touch:
      case Kind::Slide:
        return rest.empty() ? missing(tr("a place")) : place(act, rest);
      case Kind::Press: {
        const std::size_t on = rest.find(" on ");
        if (const auto wrong = quantity(act.number, stripped(rest.substr(0, on)), Dimension::Force)) return wrong;
        if (on == std::string_view::npos) {
          act.text = "here";
          return std::nullopt;
        }
        return place(act, stripped(rest.substr(on + 4)));
      }
      case Kind::Pose:
        return rest.empty() ? missing(tr("a place")) : pose(act, rest);
      case Kind::State: {
        const auto share = parseNumber(rest);
        if (!share) return within(rest.empty() ? body : rest, share.problem());
        if (!(*share >= 0.0 && *share <= 1.0))
          return at(rest, trf("'{0}' is no share from 0 to 1", rest),
                    tr("write 0 for the first structure, 1 for the second"));
        act.number = *share;
        return std::nullopt;
      }
      case Kind::Wait:
        return quantity(act.number, rest, Dimension::Time);
      case Kind::Set:
        return quantity(act.number, rest, Dimension::Length);
      case Kind::Method:
        if (const Method* method = findMethod(rest))
          act.word = method->name;
        else
          return at(rest.empty() ? body : rest, trf("there is no haptic method '{0}'", rest),
                    suggest(rest, methodNames(), tr("known")));
        return std::nullopt;
      case Kind::Say:
      case Kind::Go:
        if (rest.empty()) return missing(act.kind == Kind::Say ? tr("a word") : tr("the step's id"));
        act.word = rest.starts_with('#') ? rest.substr(1) : rest;
        return std::nullopt;
      case Kind::Draw:
        for (const std::string_view part : parts(rest, ',')) {
          double force_N = 0.0;
          if (const auto wrong = quantity(force_N, part, Dimension::Force)) return wrong;
          act.curve.push_back(force_N);
        }
        return std::nullopt;
      case Kind::Answer: {
        const std::size_t colon = rest.find(':');
        if (colon == std::string_view::npos || stripped(rest.substr(colon + 1)).empty())
          return missing(tr("a question, a colon and an answer"));
        act.word = stripped(rest.substr(0, colon));
        act.text = stripped(rest.substr(colon + 1));
        return std::nullopt;
      }
    }
    return std::nullopt;
  }

  std::string_view line_;
  std::size_t number_;
  const std::string& file_;
};

std::optional<std::size_t> asNumber(std::string_view text, std::size_t max) {
  const auto number = parseNumber(text);
  if (!number || *number < 1.0 || *number > double(max) || *number != std::floor(*number)) return std::nullopt;
  return static_cast<std::size_t>(*number) - 1;
}

// Carries out acts in order and keeps track of the hand's place on the surface.
class Performer {
 public:
  Performer(ScriptedLearner& learner, const std::string& file) : learner_(learner), file_(file) {}

  std::vector<Problem> run(const std::vector<LearnerAct>& acts) {
    for (const LearnerAct& act : acts) {
      learner_.enterStep();
      perform(act);
    }
    return std::move(problems_);
  }

 private:
  void tell(const LearnerAct& act, std::string message, std::string remedy) {
    problems_.push_back({file_, act.line, act.column, std::move(message), std::move(remedy)});
  }

  std::optional<SurfacePlace> find(const LearnerAct& act) {
    const LessonSession& session = learner_.session();
    const HandPlanInput view = learner_.view();
    const Molecule* molecule = session.molecule();
    if (!molecule) return std::nullopt;
    const AtomSet atoms(act.place, *molecule);
    if (atoms.count() == 0) {
      const Problem why = act.place.whyEmpty(*molecule);
      tell(act, why.message, why.remedy);
      return std::nullopt;
    }
    const auto place = placeFor(view, placesToTouch(view, atoms, act.word));
    if (!place) tell(act, tr("no such place is open to the probe from outside"), tr("name another place"));
    return place;
  }

  void perform(const LearnerAct& act) {
    const HandPlanInput view = learner_.view();
    HandPlan plan;
    switch (act.kind) {
      case Kind::Do:
        if (learner_.session().currentTask() >= learner_.session().step().tasks.size())
          tell(act, tr("the step has no task left to do"), tr("take the line out, or go on with 'next'"));
        else
          learner_.doTask();
        return;
      case Kind::Touch:
      case Kind::Press: {
        const bool here = act.text == "here";
        if (here && !on_) {
          tell(act, tr("the hand touches nothing"), tr("touch a place first, or name one: 'press 0.8 N on element O'"));
          return;
        }
        const auto place = here ? on_ : find(act);
        if (!place) return;
        const double depth_A = depthFor(view, act.kind == Kind::Touch ? kTouch_N : act.number);
        if (here)
          plan.push_back({.to = PointA{place->scp_A - place->outward * depth_A}, .wait_s = kTouchFor_s});
        else
          comeTo(plan, *place, depth_A, kTouchFor_s);
        on_ = place;
        depth_A_ = depth_A;
        break;
      }
      case Kind::Slide: {
        if (!on_) {
          tell(act, tr("the hand touches nothing"), tr("touch a place first"));
          return;
        }
        const auto place = find(act);
        if (!place) return;
        slide(plan, view, *on_, *place, depth_A_);
        plan.back().wait_s = kTouchFor_s;
        on_ = place;
        break;
      }
      case Kind::Pose:
        plan.push_back({.to = act.to, .turned_to = act.turned_to});
        on_.reset();
        break;
      case Kind::Wait:
        plan.push_back({.wait_s = act.number});
        break;
      case Kind::State:
        plan.push_back({.share = act.number});
        break;
      case Kind::Lift:
        if (on_) plan.push_back({.to = PointA{on_->scp_A + on_->outward}, .placed = true, .wait_s = kTouchFor_s});
        on_.reset();
        break;
      case Kind::Method:
        plan.push_back({.method = act.word});
        break;
      case Kind::Say:
        say(act);
        return;
      case Kind::Set:
        set(act);
        return;
      case Kind::Draw:
        draw(act);
        return;
      case Kind::Answer:
        answer(act);
        return;
      case Kind::Next:
      case Kind::Back:
      case Kind::Go:
        move(act);
        return;
    }
    learner_.follow(plan);
  }

  const Task* current() const { return learner_.session().taskAt(learner_.session().currentTask()); }

  void say(const LearnerAct& act) {
    const std::vector<TaskButton> offered = current() ? current()->buttons() : std::vector<TaskButton>();
    if (std::none_of(offered.begin(), offered.end(), [&](const TaskButton& b) { return b.word == act.word; })) {
      std::string words;
      for (const TaskButton& b : offered) words += (words.empty() ? "" : ", ") + std::string(b.word);
      tell(act, trf("the task does not offer '{0}' now", act.word),
           words.empty() ? tr("it offers nothing; touch first") : trf("it offers: {0}", words));
      return;
    }
    on_.reset();
    learner_.tell({.word = act.word});
  }

  void set(const LearnerAct& act) {
    const auto asked = current() ? current()->slider() : std::nullopt;
    if (!asked || act.number < asked->min || act.number > asked->max) {
      tell(act, asked ? tr("the task's slider does not go so far") : tr("no number is asked for now"),
           asked ? trf("it goes from {0} to {1}", quantityText(asked->min, asked->dimension),
                       quantityText(asked->max, asked->dimension))
                 : tr("take the line out"));
      return;
    }
    learner_.tell({.number = act.number});
  }

  void draw(const LearnerAct& act) {
    const TaskCurves* curves = current() ? current()->curves() : nullptr;
    if (!curves || !curves->drawing) {
      tell(act, tr("no curve is asked for now"), tr("take the line out"));
      return;
    }
    TaskAnswer answer;
    const std::size_t n = curves->drawn.size();
    for (std::size_t k = 0; k < n; ++k) {
      const double at = double(k) / double(n - 1) * double(act.curve.size() - 1);
      const auto low = std::min(static_cast<std::size_t>(at), act.curve.size() - 1),
                 high = std::min(low + 1, act.curve.size() - 1);
      answer.curve.push_back(act.curve[low] + (act.curve[high] - act.curve[low]) * (at - double(low)));
    }
    learner_.tell(answer);
  }

  void answer(const LearnerAct& act) {
    const std::vector<Question>& questions = learner_.session().step().questions;
    std::optional<std::size_t> index = asNumber(act.word, questions.size());
    for (std::size_t k = 0; !index && k < questions.size(); ++k)
      if (questions[k].id == act.word || plainText(questions[k].title) == act.word) index = k;
    if (!index) {
      std::string ids;
      for (const Question& q : questions) ids += (ids.empty() ? "" : ", ") + q.id;
      tell(act, trf("the step '{0}' has no question '{1}'", learner_.session().step().id, act.word),
           ids.empty() ? tr("it asks nothing") : trf("its questions: {0}", ids));
      return;
    }
    const Question& asked = questions[*index];
    if (asked.choices.empty()) {
      learner_.write(*index, act.text);
      return;
    }
    std::vector<std::size_t> choices;
    for (const std::string_view part : parts(act.text, ';')) {
      std::optional<std::size_t> choice = asNumber(part, asked.choices.size());
      for (std::size_t k = 0; !choice && k < asked.choices.size(); ++k)
        if (plainText(asked.choices[k].text) == part) choice = k;
      if (!choice) {
        tell(act, trf("'{0}' is none of the {1} choices", part, asked.choices.size()),
             tr("write a choice's number or its whole text"));
        return;
      }
      choices.push_back(*choice);
    }
    learner_.choose(*index, choices);
  }

  void move(const LearnerAct& act) {
    on_.reset();
    const LessonSession& session = learner_.session();
    if (act.kind == Kind::Next && !session.hasNext())
      tell(act, tr("this is the last step"), tr("take the line out"));
    else if (act.kind == Kind::Next && !session.mayGoOn())
      tell(act, tr("this step must be finished first"), tr("do its tasks and answer its questions before this line"));
    else if (act.kind == Kind::Back && !session.hasBack())
      tell(act, tr("this is the first step"), tr("take the line out"));
    else if (act.kind == Kind::Next)
      learner_.next();
    else if (act.kind == Kind::Back)
      learner_.back();
    else if (!session.mayGoTo(act.word))
      tell(act, tr("a step before that one must be finished first"), tr("finish it before this line"));
    else if (!learner_.goTo(act.word))
      tell(act, trf("the lesson has no step '{0}'", act.word), tr("write the id of a step's heading"));
    learner_.enterStep();
  }

  ScriptedLearner& learner_;
  const std::string& file_;
  std::vector<Problem> problems_;
  std::optional<SurfacePlace> on_;  // the place that the hand touches
  double depth_A_ = 0.0;
};

}  // namespace

AnswersReading readAnswers(const std::string& file, std::string_view text) {
  AnswersReading out;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (auto act = LineReader(line, number, file).read(out.problems)) out.acts.push_back(*std::move(act));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

std::vector<Problem> carryOut(ScriptedLearner& learner, const std::vector<LearnerAct>& acts, const std::string& file) {
  return Performer(learner, file).run(acts);
}

}  // namespace moltact
