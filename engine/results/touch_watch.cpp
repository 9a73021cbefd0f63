#include "engine/results/touch_watch.h"

#include <algorithm>
#include <utility>

namespace moltact {
namespace {

// A longer wanted force is kept with this length; its direction is what a playback draws (unit: newton).
constexpr double kMaxWanted_N = 100.0;

// The angle between two orientations (unit: radian).
double turned(const Quat& from, const Quat& to) { return glm::length(rotationBetween(from, to)); }

}  // namespace

void TouchWatch::add(const TouchSample& sample, double t_s, InputKind by) {
  if (!finite(sample.hip.A) || !finite(sample.contact.scp.A) || !finite(sample.contact.displacement_A) ||
      !finite(sample.force.N) || !finite(sample.wanted_N))
    return;
  if (sample.body &&
      !(rotates(sample.orientation) && finite(sample.body->place.A) && rotates(sample.body->orientation)))
    return;
  follow(sample, t_s, by);
  keepHip(sample, t_s);
}

void TouchWatch::follow(const TouchSample& s, double t_s, InputKind by) {
  if (!s.contact.touching()) {
    if (touching_ && t_s - touch_.last_s > kTouchGap_s) end();
    return;
  }
  const auto each = [&](auto&& take) {
    for (const std::int32_t a : s.contact.atoms)
      if (a >= 0) take(a);
  };
  if (!touching_) {
    touching_ = true;
    touch_ = Touch();
    touch_.event.from_s = touch_.written_s = t_s;
    touch_.scp_A = s.contact.scp.A;
    touch_.atoms = s.contact.atoms;
    TouchBegan began;
    each([&](std::int32_t a) { began.atoms.push_back(a); });
    ready_.push_back({t_s, std::move(began)});
  }
  TouchEnded& event = touch_.event;
  if (s.contact.atoms != touch_.atoms) {
    ++event.crossings;
    touch_.atoms = s.contact.atoms;
  }
  each([&](std::int32_t a) {
    if (event.atoms.size() < kMaxTouched && std::find(event.atoms.begin(), event.atoms.end(), a) == event.atoms.end())
      event.atoms.push_back(a);
  });
  const double force_N = glm::length(s.force.N);
  event.peak_N = std::max(event.peak_N, force_N);
  event.path_A += glm::distance(s.contact.scp.A, touch_.scp_A);
  event.by = by;
  touch_.scp_A = s.contact.scp.A;
  touch_.force_sum_N += force_N;
  ++touch_.ticks;
  touch_.last_s = t_s;
}

double TouchWatch::mean_N() const { return touch_.force_sum_N / double(std::max<std::size_t>(1, touch_.ticks)); }

void TouchWatch::end() {
  touching_ = false;
  touch_.event.mean_N = mean_N();
  ready_.push_back({touch_.last_s, std::move(touch_.event)});
}

void TouchWatch::keepHip(const TouchSample& s, double t_s) {
  const Contact& c = s.contact;
  HipSample now{t_s, s.hip, c.scp, s.force, c.displacement_A, c.feature, c.atoms};
  if (s.body) now.held = {s.orientation, *s.body};
  if (s.field) now.wanted_N = s.wanted_N * std::min(1.0, kMaxWanted_N / std::max(glm::length(s.wanted_N), 1e-9));
  // A line of the file is either with a body or without one.
  if (has_before_ && now.held.has_value() != before_.held.has_value()) endPath();
  if (has_before_) {
    const bool changed = now.feature != before_.feature || now.atoms != before_.atoms;
    if (t_s - before_.t_s < (changed ? kChange_s : kSample_s)) return;
    const bool still = !changed && glm::distance(now.hip.A, before_.hip.A) < kStill_A &&
                       glm::distance(now.force.N, before_.force.N) < 0.005 &&
                       (!now.held || turned(before_.held->orientation, now.held->orientation) < kUnturned);
    if (still) {
      rested_ = true;
      resting_ = now;
      return;
    }
    // The end of the rest, so that interpolation does not stretch the motion over the rest.
    if (std::exchange(rested_, false) && resting_.t_s > before_.t_s) hips_.push_back(resting_);
  }
  hips_.push_back(now);
  before_ = now;
  has_before_ = true;
}

void TouchWatch::endPath() {
  if (!hips_.empty()) ready_.push_back({hips_.back().t_s, HipChunk{std::exchange(hips_, {})}});
  has_before_ = rested_ = false;
}

void TouchWatch::breakOff() {
  if (touching_) end();
  endPath();
}

std::vector<AttemptEvent> TouchWatch::take(double t_s) {
  if (!hips_.empty() && t_s - hips_.front().t_s >= kHipChunk_s)
    ready_.push_back({hips_.back().t_s, HipChunk{std::exchange(hips_, {})}});
  if (touching_ && touch_.last_s - touch_.written_s >= kHeartbeat_s) {
    const TouchEnded& now = touch_.event;
    ready_.push_back({touch_.last_s, TouchSoFar{now.from_s, now.crossings, now.peak_N, mean_N(), now.path_A, now.by}});
    touch_.written_s = touch_.last_s;
  }
  return std::exchange(ready_, {});
}

}  // namespace moltact
