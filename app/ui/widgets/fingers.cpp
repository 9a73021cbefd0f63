#include "app/ui/widgets/fingers.h"

#include <algorithm>
#include <cmath>

namespace moltact {
namespace {

constexpr int kLeft = 0, kRight = 1;

}  // namespace

glm::dvec2 Fingers::middle() const {
  glm::dvec2 sum(0.0);
  for (const Finger& f : fingers_) sum += f.place;
  return sum / double(fingers_.size());
}

double Fingers::spread() const { return glm::distance(fingers_[0].place, fingers_[1].place); }

// The direction of the line from the first finger to the second: clockwise positive, because y points down in pixels
// (unit: radian).
double Fingers::direction() const {
  const glm::dvec2 line = fingers_[1].place - fingers_[0].place;
  return std::atan2(line.y, line.x);
}

// Ends the gesture and removes the pointer: without a finger, nothing is hovered.
void Fingers::letGo() {
  if (way_ == Way::Pushing || way_ == Way::Dragging) to_.button(kLeft, false);
  if (way_ == Way::Turning) to_.button(kRight, false);
  if (way_ == Way::TurningView) to_.button(kViewButton, false);
  if (way_ != Way::Ended && way_ != Way::None) to_.pointerLeft();
}

// During a push, the wheel changes the push.
void Fingers::pushNotch(double now_s) {
  if (way_ != Way::Pushing) return;
  to_.wheel(0.0, pad_->notches);
  pad_->last_s = now_s;
}

void Fingers::down(int id, glm::dvec2 place, Target on, double now_s, double line_px) {
  if (on == Target::Harder || on == Target::Lighter) {
    if (pad_) return;
    pad_ = Pad{id, on == Target::Harder ? 1.0 : -1.0, now_s};
    pushNotch(now_s);
    return;
  }
  const bool in_view = on == Target::View;
  const auto same = std::find_if(fingers_.begin(), fingers_.end(), [id](const Finger& f) { return f.id == id; });
  if (same != fingers_.end()) return;
  fingers_.push_back({id, place});
  if (fingers_.size() == 1) {
    begun_ = last_ = place;
    begun_s_ = now_s;
    line_px_ = std::max(1.0, line_px);
    way_ = in_view ? Way::Pushing : on == Target::Edge ? Way::Dragging : Way::Waiting;
    to_.pointer(place.x, place.y);
    if (way_ != Way::Waiting) to_.button(kLeft, true);
  } else if (fingers_.size() == 2 && way_ == Way::Pushing) {
    to_.button(kLeft, false);
    way_ = Way::Turning;
    last_ = middle();
    last_spread_ = spread();
    last_direction_ = direction();
    to_.pointer(last_.x, last_.y);
    to_.button(kRight, true);
  } else if (fingers_.size() == 3 && way_ == Way::Turning) {
    to_.button(kRight, false);
    way_ = Way::TurningView;
    last_ = middle();
    to_.pointer(last_.x, last_.y);
    to_.button(kViewButton, true);
  } else {
    letGo();
    way_ = Way::Ended;
  }
}

void Fingers::move(int id, glm::dvec2 place) {
  const auto at = std::find_if(fingers_.begin(), fingers_.end(), [id](const Finger& f) { return f.id == id; });
  if (at == fingers_.end()) return;
  at->place = place;
  const glm::dvec2 way = place - begun_;
  const bool moved = glm::length(way) > kStill_lines * line_px_;
  if ((way_ == Way::Waiting || way_ == Way::Telling) && moved) {
    way_ = std::abs(way.y) > std::abs(way.x) ? Way::Scrolling : Way::Dragging;
    if (way_ == Way::Dragging) to_.button(kLeft, true);
  }
  switch (way_) {
    case Way::Scrolling:
      to_.wheel(0.0, (place.y - last_.y) / (kNotch_lines * line_px_));
      last_ = place;
      break;
    case Way::Dragging:
    case Way::Pushing:
      to_.pointer(place.x, place.y);
      last_ = place;
      break;
    case Way::Turning: {
      last_ = middle();
      to_.pointer(last_.x, last_.y);
      const double now = std::max(1.0, spread()), before = std::max(1.0, last_spread_);
      // The direction is undefined if the fingers are too close.
      const bool apart = std::min(now, before) > kStill_lines * line_px_;
      const double twist_rad = apart ? std::remainder(direction() - last_direction_, kTwoPi) : 0.0;
      to_.wheel(twist_rad / kTwistNotch_rad, std::log(now / before) / std::log(kNotch));
      last_spread_ = now;
      last_direction_ = direction();
      break;
    }
    case Way::TurningView:
      last_ = middle();
      to_.pointer(last_.x, last_.y);
      break;
    default:
      break;
  }
}

void Fingers::up(int id) {
  if (pad_ && pad_->id == id) {
    pad_.reset();
    return;
  }
  if (std::erase_if(fingers_, [id](const Finger& f) { return f.id == id; }) == 0) return;
  if (way_ == Way::Waiting) {
    to_.button(kLeft, true);
    to_.button(kLeft, false);
  }
  letGo();
  way_ = fingers_.empty() ? Way::None : Way::Ended;
}

// The pointer is already there without a button, so the panel shows its tool tip.
void Fingers::advance(double now_s) {
  if (pad_ && now_s - pad_->last_s >= kRepeat_s) pushNotch(now_s);
  if (way_ == Way::Waiting && now_s - begun_s_ > kLong_s) way_ = Way::Telling;
}

}  // namespace moltact
