#include "app/ui/extensions/touch_paint.h"

#include "app/ui/extensions/reveal_policy.h"
#include "app/ui/lesson/lesson_guide.h"

namespace moltact {
namespace {

constexpr double kSpacing_A = 0.15;
constexpr std::size_t kMaxPoints = 20'000;  // beyond this number, every second point is dropped
constexpr std::size_t kMaxFresh = 40;       // drawn individually; beyond this number the molecule is redrawn

AtomList listOf(const std::set<std::uint32_t>& atoms) {
  return atoms.empty() ? nullptr : std::make_shared<const std::vector<std::uint32_t>>(atoms.begin(), atoms.end());
}

}  // namespace

bool TouchPaint::paints() const {
  return lesson_.session() && lesson_.onStage() && lesson_.session()->scene().paint_touched;
}

void TouchPaint::beforeTicks() {
  const bool dark = policy_.all();
  if (dark && !dark_) {
    // After a look in between, the path of the same task is continued.
    const std::size_t task = lesson_.session() ? lesson_.session()->currentTask() : 0;
    if (trail_ && task == dark_task_) {
      way_ = trail_->trail;
    } else {
      way_.clear();
      points_ = 0;
      spacing_A_ = kSpacing_A;
    }
    dark_task_ = task;
    trail_ = nullptr;
  }
  if (!dark && dark_ && points_ > 1) {
    auto trail = std::make_shared<Annotations>();
    trail->trail = std::move(way_);
    trail_ = std::move(trail);
    way_.clear();
  }
  dark_ = dark;
}

void TouchPaint::ticks(const FeltTicks& felt) {
  const bool paints_now = paints();
  const std::size_t before = since_.size();
  bool touching = false;
  for (const FeltTick& tick : felt.ticks) {
    const ServoSample& s = tick.sample;
    if (!s.has_interaction) continue;
    touching = s.contact.touching();
    if (dark_) extendPath(s.forcePlace(), s.contact_reset);
    if (!paints_now || !touching) continue;
    for (const std::int32_t a : s.contact.atoms)
      if (a >= 0 && !touched_.contains(std::uint32_t(a))) since_.insert(std::uint32_t(a));
  }
  // The molecule is redrawn with them once the probe has left it.
  if (!since_.empty() && (!touching || since_.size() > kMaxFresh)) {
    touched_.insert(since_.begin(), since_.end());
    since_.clear();
    painted_ = listOf(touched_);
    fresh_ = nullptr;
  } else if (since_.size() != before) {
    fresh_ = listOf(since_);
  }
}

void TouchPaint::extendPath(const PointA& place, bool anew) {
  if (anew || way_.empty()) {
    way_.emplace_back();
  } else if (const std::vector<PointA>& piece = way_.back();
             !piece.empty() && glm::distance(piece.back().A, place.A) < spacing_A_) {
    return;
  }
  way_.back().push_back(place);
  if (++points_ < kMaxPoints) return;
  points_ = 0;
  for (std::vector<PointA>& piece : way_) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < piece.size(); i += 2) piece[kept++] = piece[i];
    piece.resize(kept);
    points_ += kept;
  }
  spacing_A_ *= 2.0;
  // A path of many short parts cannot be thinned out; its first parts are dropped.
  while (points_ > kMaxPoints / 2 && way_.size() > 1) {
    points_ -= way_.front().size();
    way_.erase(way_.begin());
  }
}

void TouchPaint::stepChanged() {
  trail_ = nullptr;
  dark_ = false;
  if (paints()) return;
  touched_.clear();
  since_.clear();
  painted_ = fresh_ = nullptr;
}

void TouchPaint::sceneChanged() {
  if (scene_.stage().molecule == molecule_) return;
  molecule_ = scene_.stage().molecule;
  trail_ = nullptr;
  touched_.clear();
  since_.clear();
  painted_ = fresh_ = nullptr;
}

}  // namespace moltact
