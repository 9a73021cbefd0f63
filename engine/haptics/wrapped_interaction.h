// A wrapper around an interaction, for a field or a surface property such as friction: a layer of interactions.h. It
// forwards every call; a derived class overrides what it changes. `respond` runs on the haptic thread.
#pragma once

#include <memory>
#include <utility>

#include "engine/haptics/interaction.h"

namespace moltact {

class WrappedInteraction : public Interaction {
 public:
  /// `inner` must not be null.
  explicit WrappedInteraction(std::unique_ptr<Interaction> inner) : inner_(std::move(inner)) {}

  Response respond(const PoseA& pose) noexcept override { return inner_->respond(pose); }
  void reset() noexcept override { inner_->reset(); }
  void setProbe(double probe_A) noexcept override { inner_->setProbe(probe_A); }
  double probe_A() const noexcept override { return inner_->probe_A(); }
  void setSurface(const SurfaceProperties& surface) noexcept override { inner_->setSurface(surface); }
  SurfaceProperties surface() const noexcept override { return inner_->surface(); }
  /// `last` is the response of this wrapper. Override if the wrapper changes more than the force of a point's contact.
  std::size_t reactions(const Response& last, double spring_N_per_A, double field_share,
                        std::span<AtomForce> out) const noexcept override {
    return inner_->reactions(last, spring_N_per_A, field_share, out);
  }
  std::size_t maxReactionCount() const noexcept override { return inner_->maxReactionCount(); }
  bool setMotion(const SphereMotion* motion) noexcept override { return inner_->setMotion(motion); }
  void advanceTo(double fraction) noexcept override { inner_->advanceTo(fraction); }
  MemoryUsage memoryUsage() const noexcept override { return inner_->memoryUsage(); }
  bool hasOrientation() const noexcept override { return inner_->hasOrientation(); }

 protected:
  Interaction& inner() noexcept { return *inner_; }
  const Interaction& inner() const noexcept { return *inner_; }

 private:
  std::unique_ptr<Interaction> inner_;
};

}  // namespace moltact
