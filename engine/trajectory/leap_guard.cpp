#include "engine/trajectory/leap_guard.h"

#include <algorithm>
#include <utility>

namespace moltact {
namespace {

// The displacement of the centre of each molecule.
template <class At>
std::vector<Vec3> stepsOf(std::span<const Vec3> from, std::span<const std::uint32_t> part_of, std::size_t parts,
                          At to) {
  std::vector<Vec3> out(parts, Vec3(0.0));
  std::vector<double> count(parts, 0.0);
  for (std::size_t i = 0; i < from.size(); ++i) {
    out[part_of[i]] += to(i) - from[i];
    ++count[part_of[i]];
  }
  for (std::size_t p = 0; p < parts; ++p) out[p] /= std::max(count[p], 1.0);
  return out;
}

}  // namespace

std::vector<bool> leapsBetween(std::span<const Vec3> from, std::span<const Vec3> to,
                               std::span<const std::uint32_t> part_of, std::size_t parts, double limit_A) {
  std::vector<bool> out(parts, false);
  if (!(limit_A > 0.0) || from.size() != to.size() || from.size() != part_of.size()) return out;
  const std::vector<Vec3> steps = stepsOf(from, part_of, parts, [&](std::size_t i) { return to[i]; });
  for (std::size_t p = 0; p < parts; ++p) out[p] = glm::length(steps[p]) > limit_A;
  return out;
}

LeapGuard::LeapGuard(std::span<const std::uint32_t> part_of, std::size_t parts)
    : part_of_(part_of.begin(), part_of.end()), states_(parts, State::Here), grown_A_(parts, 0.0) {}

void LeapGuard::place(std::span<const Sphere> at) {
  places_A_.clear();
  if (at.size() != part_of_.size()) return;
  for (const Sphere& s : at) places_A_.push_back(s.centre_A);
  std::fill(states_.begin(), states_.end(), State::Here);
  before_s_ = 0.0;
  unsettled_ = 0;
}

bool LeapGuard::step(std::vector<Sphere>& to, double limit_A, double piece_s, const Occupied& occupied) {
  if (to.size() != part_of_.size() || places_A_.size() != to.size()) return false;
  const std::size_t parts = states_.size();
  std::vector<bool> leaps(parts, false), held(parts, false), growing(parts, false);
  if (limit_A > 0.0) {
    const std::vector<Vec3> steps = stepsOf(places_A_, part_of_, parts, [&](std::size_t i) { return to[i].centre_A; });
    for (std::size_t p = 0; p < parts; ++p) leaps[p] = glm::length(steps[p]) > limit_A;
  }
  const double growth_A = kGrowth_A_per_s * piece_s, room_A = kHand_A_per_s * (before_s_ + kFrame_s);
  before_s_ = piece_s;
  // Where a molecule that is away would appear.
  for (std::size_t i = 0; i < to.size(); ++i)
    if (const std::uint32_t p = part_of_[i]; states_[p] == State::Away && !held[p]) held[p] = occupied(to[i], room_A);
  for (std::size_t p = 0; p < parts; ++p) {
    State& state = states_[p];
    switch (state) {
      case State::Here:
      case State::Growing:
        if (leaps[p])
          state = State::Shrunk;
        else if (state == State::Growing)
          grown_A_[p] += growth_A;
        break;
      case State::Shrunk:
        state = State::Away;
        break;
      case State::Away:
        if (leaps[p] || held[p]) break;
        state = State::Growing;
        grown_A_[p] = growth_A;
        break;
    }
    growing[p] = false;
  }
  for (std::size_t i = 0; i < to.size(); ++i) {
    const std::uint32_t p = part_of_[i];
    switch (states_[p]) {
      case State::Here:
        break;
      case State::Shrunk:
        to[i] = {places_A_[i], 0.0};
        break;
      case State::Away:
        to[i].radius_A = 0.0;
        break;
      case State::Growing:
        growing[p] = growing[p] || grown_A_[p] < to[i].radius_A;
        to[i].radius_A = std::min(to[i].radius_A, grown_A_[p]);
        break;
    }
    places_A_[i] = to[i].centre_A;
  }
  unsettled_ = 0;
  for (std::size_t p = 0; p < parts; ++p) {
    if (states_[p] == State::Growing && !growing[p]) states_[p] = State::Here;
    unsettled_ += states_[p] != State::Here;
  }
  return true;
}

}  // namespace moltact
