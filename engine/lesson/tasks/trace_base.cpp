// Common base of the two forms of the task trace.
#include <algorithm>
#include <cmath>

#include "engine/language/catalogue.h"
#include "engine/lesson/tasks/trace.h"

namespace moltact {

Trace::Trace(const TaskSpec& spec)
    : Task(spec),
      called_(spec.values["called"].text),
      within_A_(spec.values["within"].number),
      cover_(0.01 * spec.values["cover"].number),
      limited_(spec.values.has("lifts")),
      lifts_allowed_(static_cast<int>(spec.values["lifts"].number)) {}

void Trace::reset() {
  Task::reset();
  forget();
  slide_.restart();
  lifts_ = 0;
  over_A_s_ = on_s_ = greatest_A_ = 0.0;
  state_ = State::Away;
}

void Trace::onSample(const TouchSample& s, double dt_s) {
  put_down_ = slide_.tick(s.contact, dt_s);
  if (!s.contact.touching()) {
    away_s_ += dt_s;
    if (away_s_ > kSlip_s && begun() && state_ != State::Lifted && state_ != State::Again) letGo();
    return;
  }
  away_s_ = 0.0;
  const Step step = follow(s.contact, s.probe_A, within_A_);
  if (begun()) {
    over_A_s_ += step.off_A * dt_s;
    on_s_ += dt_s;
    greatest_A_ = std::max(greatest_A_, step.off_A);
    state_ = step.on ? State::On : State::Off;
  } else if (state_ != State::Again) {
    state_ = State::Elsewhere;
  }
  setProgress(covered() / cover_);
  if (covered() >= cover_) finish();
}

void Trace::letGo() {
  ++lifts_;
  state_ = State::Lifted;
  if (!limited_ || lifts_ <= lifts_allowed_) return;
  if (missedLast()) return;
  forget();
  lifts_ = 0;
  over_A_s_ = on_s_ = greatest_A_ = 0.0;
  setProgress(0.0);
  state_ = State::Again;
}

std::string Trace::guidance() const {
  const std::string so_far = percentText(std::floor(100.0 * covered()) / 100.0);
  switch (state_) {
    case State::Away:
      switch (begin()) {
        case Begin::Start:
          return trf("Touch the start of {0} to begin.", name());
        case Begin::EitherEnd:
          return trf("Touch either end of {0} to begin.", name());
        case Begin::Anywhere:
          return trf("Touch {0} to begin.", name());
      }
      break;
    case State::Elsewhere:
      switch (begin()) {
        case Begin::Start:
          return trf("You are on the surface. Slide to the start of {0} to begin.", name());
        case Begin::EitherEnd:
          return trf("You are on the surface. Slide to either end of {0} to begin.", name());
        case Begin::Anywhere:
          return trf("You are on the surface. Slide to {0} to begin.", name());
      }
      break;
    case State::On:
      return trf("Follow {0}: {1} of the way.", way(), so_far);
    case State::Off:
      return trf("You are off {0}. Go back to where you left it: {1} of the way.", way(), so_far);
    case State::Lifted:
      return trf("You let go. Touch {0} where you left it: {1} of the way.", way(), so_far);
    case State::Again:
      break;
  }
  switch (begin()) {
    case Begin::Start:
      return trf("You let go too often. Begin again at the start of {0}.", name());
    case Begin::EitherEnd:
      return trf("You let go too often. Begin again at either end of {0}.", name());
    case Begin::Anywhere:
      break;
  }
  return trf("You let go too often. Begin again at {0}.", name());
}

void Trace::measure(std::vector<TaskFigure>& out) const {
  out.push_back({N_("coverage"), 100.0 * covered(), "%"});
  if (on_s_ > 0.0) out.push_back({N_("mean deviation"), over_A_s_ / on_s_, "Å"});
  out.push_back({N_("greatest deviation"), greatest_A_, "Å"});
  out.push_back({N_("lifts"), double(lifts_), ""});
}

const char* Trace::unnamed() const { return tr("the way"); }

std::string Trace::name() const { return called_.empty() ? std::string(unnamed()) : called_; }

std::string Trace::way() const { return called_.empty() ? tr("the way") : called_; }

}  // namespace moltact
