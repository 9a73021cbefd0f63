// A guide around an interaction: its force is added to Response::field, which the safety stage bounds, watches and
// brakes like every field. While a guide is on, the field is present also where its force is zero. The guide is constant:
// another strength is another interaction, which begins with a soft start. It exerts no force on atoms, so the reactions
// are those of the inner interaction. Haptic thread; no allocation after construction.
#pragma once

#include <utility>

#include "engine/haptics/guide/guide.h"
#include "engine/haptics/wrapped_interaction.h"

namespace moltact {

class GuideLayer final : public WrappedInteraction {
 public:
  GuideLayer(std::unique_ptr<Interaction> inner, Guide guide)
      : WrappedInteraction(std::move(inner)), guide_(std::move(guide)) {}

  Response respond(const PoseA& pose) noexcept override {
    Response out = inner().respond(pose);
    const FeltForce led = guideForce(guide_, pose.place.A);
    FeltForce& sum = out.field ? *out.field : out.field.emplace();
    sum.force_N += led.force_N;
    sum.energy_N_A += led.energy_N_A;
    sum.stiffness_N_per_A += led.stiffness_N_per_A;
    return out;
  }

 private:
  Guide guide_;
};

}  // namespace moltact
