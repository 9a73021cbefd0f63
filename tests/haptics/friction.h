// Coulomb friction at the SCP, an example of a layer that changes the contact's force. Unit: angstrom.
#pragma once

#include <cmath>
#include <memory>
#include <utility>

#include "engine/haptics/wrapped_interaction.h"

namespace moltact::test {

// The SCP sticks until the spring pulls it along the surface with more than `coefficient` times what it presses with;
// then it slides after the hand, so that the ratio stays. What is kept is a place and no count of calls: the hand's own
// place, held back along the surface, with which the tracker inside is asked.
class Friction final : public WrappedInteraction {
 public:
  Friction(std::unique_ptr<Interaction> inner, double coefficient)
      : WrappedInteraction(std::move(inner)), coefficient_(coefficient) {}

  Response respond(const PoseA& pose) noexcept override {
    Response out;
    if (!touching_ || !finite(pose.place.A)) return remember(pose.place, inner().respond(pose));
    Vec3 held = held_;
    // How far it may lag follows from how deep it presses there, and where that is from how far it lags.
    for (int k = 0; k < 8; ++k) {
      const Vec3 away = held - pose.place.A, along = away - outward_ * glm::dot(away, outward_);
      const double slack = glm::length(along), most = coefficient_ * pressed_A_;
      const Vec3 next = pose.place.A + (slack > most ? along * (most / slack) : along);
      if (k > 0 && glm::distance(next, held) < 1e-10) break;
      held = next;
      out = remember({held}, inner().respond({{held}, pose.orientation}));
      if (!touching_) return held == pose.place.A ? out : remember(pose.place, inner().respond(pose));
    }
    // Along the surface the displacement grows by the lag, whatever the method made of it; so does the energy stored.
    const Vec3 lag = held - pose.place.A;
    out.contact.energy_A2 += glm::dot(lag, out.contact.displacement_A) + 0.5 * glm::dot(lag, lag);
    out.contact.displacement_A += lag;
    return out;
  }
  void reset() noexcept override {
    touching_ = false;
    WrappedInteraction::reset();
  }

 private:
  const Response& remember(PointA asked, const Response& answer) noexcept {
    held_ = asked.A;
    pressed_A_ = glm::length(answer.contact.displacement_A);
    touching_ = answer.contact.touching() && pressed_A_ > 0.0;
    if (touching_) outward_ = answer.contact.displacement_A / pressed_A_;
    return answer;
  }

  double coefficient_;
  bool touching_ = false;
  Vec3 held_{0.0}, outward_{0.0};  // where the tracker was asked last, and the surface's normal there
  double pressed_A_ = 0.0;         // how far its SCP was from there
};

}  // namespace moltact::test
