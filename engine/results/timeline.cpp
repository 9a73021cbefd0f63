#include "engine/results/timeline.h"

#include <algorithm>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

// The last element, in a chronological list, that is not after `t_s`; null if there is none.
template <class List>
auto lastUpTo(const List& list, double t_s) -> const typename List::value_type* {
  const auto after =
      std::upper_bound(list.begin(), list.end(), t_s, [](double t, const auto& item) { return t < item.t_s; });
  return after == list.begin() ? nullptr : &*std::prev(after);
}

template <class List>
void sortByTime(List& list) {
  std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.t_s < b.t_s; });
}

const StepOutline* stepOf(const LessonOutline& lesson, const std::string& id) {
  const auto found =
      std::find_if(lesson.steps.begin(), lesson.steps.end(), [&](const StepOutline& s) { return s.id == id; });
  return found == lesson.steps.end() ? nullptr : &*found;
}

std::string answerText(const LessonOutline& lesson, const Answered& a) {
  if (!a.written.empty()) return a.written;
  std::string out;
  const StepOutline* step = stepOf(lesson, a.step);
  if (!step) return out;
  for (const QuestionOutline& q : step->questions)
    if (q.id == a.question)
      for (const std::size_t c : a.chosen)
        out += (out.empty() ? "" : ", ") + (c < q.choices.size() ? q.choices[c] : std::string("?"));
  return out;
}

}  // namespace

Timeline::Timeline(Attempt attempt) : header_(std::move(attempt.header)), length_s_(0.0) {
  length_s_ = attempt.end_s();
  const auto mark = [&](double t_s, TimelineMark::Kind kind, std::string text) {
    marks_.push_back({t_s, kind, std::move(text)});
  };
  for (AttemptEvent& e : attempt.events) {
    if (auto* chunk = std::get_if<HipChunk>(&e.what))
      samples_.insert(samples_.end(), chunk->samples.begin(), chunk->samples.end());
    if (auto* stage = std::get_if<StageChanged>(&e.what)) stages_.push_back({e.t_s, std::move(*stage)});
    if (auto* moved = std::get_if<AtomsMoved>(&e.what)) moves_.push_back({e.t_s, std::move(*moved)});
    if (auto* view = std::get_if<ViewChanged>(&e.what)) views_.push_back({e.t_s, *view});
    if (auto* input = std::get_if<InputChanged>(&e.what)) inputs_.push_back({e.t_s, input->by});
    if (auto* step = std::get_if<StepEntered>(&e.what)) {
      const StepOutline* known = stepOf(header_.lesson, step->step);
      mark(e.t_s, TimelineMark::Kind::Step, known ? known->title : step->step);
    }
    if (auto* done = std::get_if<TaskDone>(&e.what)) {
      const StepOutline* known = stepOf(header_.lesson, done->step);
      mark(e.t_s, TimelineMark::Kind::Task,
           known && done->task < known->tasks.size() ? trf("Done: {0}", known->tasks[done->task].say)
                                                     : tr("Done: a task"));
    }
    if (auto* answer = std::get_if<Answered>(&e.what))
      mark(e.t_s, answer->right ? TimelineMark::Kind::Right : TimelineMark::Kind::Wrong,
           answer->right ? trf("Answered rightly: {0}", answerText(header_.lesson, *answer))
                         : trf("Answered: {0}", answerText(header_.lesson, *answer)));
    if (std::holds_alternative<HintOpened>(e.what)) mark(e.t_s, TimelineMark::Kind::Hint, tr("Opened the hint"));
  }
  sortByTime(samples_);
  sortByTime(stages_);
  sortByTime(moves_);
  sortByTime(views_);
  sortByTime(inputs_);
  sortByTime(marks_);
  if (!samples_.empty()) length_s_ = std::max(length_s_, samples_.back().t_s);
}

std::optional<HipSample> Timeline::hand(double t_s) const {
  const HipSample* before = lastUpTo(samples_, t_s);
  if (!before) return std::nullopt;
  HipSample out = *before;
  out.t_s = t_s;
  if (before == &samples_.back()) return out;
  const HipSample& after = *(before + 1);
  const double span_s = after.t_s - before->t_s;
  // Do not interpolate across scenes, or if the hand was repositioned or released in between.
  const StageChanged *here = stage(before->t_s), *there = stage(after.t_s);
  if (!(span_s > 0.0) || here != there) return out;
  const double part = (t_s - before->t_s) / span_s;
  out.hip.A = glm::mix(before->hip.A, after.hip.A, part);
  if (before->held && after.held) {
    const auto between = [part](const Quat& a, const Quat& b) { return glm::slerp(a, b, part); };
    out.held->orientation = between(before->held->orientation, after.held->orientation);
    out.held->body.place.A = glm::mix(before->held->body.place.A, after.held->body.place.A, part);
    out.held->body.orientation = between(before->held->body.orientation, after.held->body.orientation);
  }
  if (before->feature == Feature::Free) {
    out.scp = out.hip;
  } else if (after.feature != Feature::Free) {
    out.scp.A = glm::mix(before->scp.A, after.scp.A, part);
    out.force.N = glm::mix(before->force.N, after.force.N, part);
    out.displacement_A = glm::mix(before->displacement_A, after.displacement_A, part);
  }
  return out;
}

const StageChanged* Timeline::stage(double t_s) const {
  const auto* found = lastUpTo(stages_, t_s);
  return found ? &found->fact : nullptr;
}

const AtomsMoved* Timeline::atoms(double t_s) const {
  const auto* staged = lastUpTo(stages_, t_s);
  if (!staged) return nullptr;
  const auto* found = lastUpTo(moves_, t_s);
  if (found && found->t_s >= staged->t_s) return &found->fact;
  // Before the mover had read its file, the atoms were at the position in the first line of this scene.
  const At<AtomsMoved>* next = moves_.empty() ? nullptr : found ? found + 1 : moves_.data();
  if (!next || next == moves_.data() + moves_.size() || lastUpTo(stages_, next->t_s) != staged) return nullptr;
  return &next->fact;
}

const ViewChanged* Timeline::view(double t_s) const {
  const auto* found = lastUpTo(views_, t_s);
  return found ? &found->fact : nullptr;
}

double Timeline::nextAfter(double t_s) const {
  double next = length_s_;
  const auto earlier = [&](const auto& list) {
    const auto found =
        std::upper_bound(list.begin(), list.end(), t_s, [](double t, const auto& item) { return t < item.t_s; });
    if (found != list.end()) next = std::min(next, found->t_s);
  };
  earlier(samples_);
  earlier(moves_);
  earlier(marks_);
  return next;
}

InputKind Timeline::input(double t_s) const {
  const auto* found = lastUpTo(inputs_, t_s);
  return found ? found->fact : InputKind::Mouse;
}

std::string Timeline::step(double t_s) const {
  std::string out;
  for (const TimelineMark& m : marks_)
    if (m.kind == TimelineMark::Kind::Step && m.t_s <= t_s) out = m.text;
  return out;
}

}  // namespace moltact
