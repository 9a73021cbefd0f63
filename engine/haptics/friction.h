// Dry friction between what the hand holds and the surface: a layer on every interaction (interactions.h). It is the
// god-object with a friction cone (Harwin & Melder, EuroHaptics 2002), its normal force that of the contacts
// themselves. The interaction inside is led by a held-back hand: the hand's place, dragged along the surface so that
// the contact rests where it stuck. Between hand and contact acts the felt spring alone, which is thus the bristle of
// Dahl's model with its exponent 0 (P. R. Dahl, AIAA Journal 14, 1675, 1976).
//
// A contact sticks until the spring drags it with more than the coefficient times its normal force; then it slips
// towards the hand until the ratio is that of sliding. A slip lowers the energy of the spring, whatever its path, and a
// contact that sticks stores and returns it, so friction only takes energy from the hand (docs/friction.md). The place
// where a contact sticks moves with the atoms that it touches. A body sticks in its orientation too.
//
// No state depends on the number of calls. Haptic thread; no allocation after construction. Units: angstrom, radian.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/haptics/body/held_body.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/haptics/sphere_motion.h"
#include "engine/haptics/wrapped_interaction.h"

namespace moltact {

/// The factor by which each sphere of the scene multiplies the coefficient of friction, 0 to kMaxRoughness.
using Roughness = std::vector<float>;
inline constexpr float kMaxRoughness = 2.0f;

class FrictionLayer final : public WrappedInteraction {
 public:
  /// `inner` and `scene` must not be null. `body` is what the hand holds; null: the probe. `roughness` has one entry per
  /// sphere of the scene; null: 1 everywhere.
  FrictionLayer(std::unique_ptr<Interaction> inner, std::shared_ptr<const SphereGrid> scene,
                std::shared_ptr<const HeldBody> body, std::shared_ptr<const Roughness> roughness,
                const Friction& friction);

  /// With coefficient 0: the response of the inner interaction.
  Response respond(const PoseA& pose) noexcept override;
  void reset() noexcept override;
  void setProbe(double probe_A) noexcept override;
  void setSurface(const SurfaceProperties& surface) noexcept override;
  SurfaceProperties surface() const noexcept override;
  std::size_t reactions(const Response& last, double spring_N_per_A, double field_share,
                        std::span<AtomForce> out) const noexcept override;
  bool setMotion(const SphereMotion* motion) noexcept override;
  void advanceTo(double fraction) noexcept override;
  MemoryUsage memoryUsage() const noexcept override;

  bool slipped() const noexcept { return slipped_; }  ///< in the last call

 private:
  void setFriction(const Friction& friction) noexcept;
  // How far the held-back hand is from the hand along the surface, and how firmly the hand presses on the contacts.
  struct Lag {
    Vec3 way_A{0.0};     // of the place
    Vec3 turn_rad{0.0};  // of the orientation; zero for a probe
    // The sum over the contacts of roughness times normal force, in units of the spring, and the same times each
    // contact's lever about the body's middle.
    double grip_A = 0.0, grip_turn_A2 = 0.0;
  };
  const Response& ask(const PoseA& held) noexcept;
  void carry() noexcept;
  Vec3 centre_A(std::int32_t atom) const noexcept;
  double roughnessOf(std::int32_t atom) const noexcept;
  Lag lagBehind(const PoseA& hand) const noexcept;
  double load(const Lag& lag) const noexcept;
  void account(double stayed_A2, const PoseA& pose, bool surface_moved) noexcept;
  Response answer(const PoseA& hand) const noexcept;

  std::shared_ptr<const SphereGrid> scene_;
  std::shared_ptr<const HeldBody> body_;
  std::shared_ptr<const Roughness> roughness_;
  Friction friction_;
  const SphereMotion* motion_ = nullptr;
  std::uint64_t motion_serial_ = 0;  // a later motion may have the same address
  double fraction_ = 0.0;

  bool touching_ = false, slipped_ = false, surface_moved_ = false;
  PoseA held_;             // the last pose of the inner interaction
  Response inner_answer_;  // its response to that
  double share_ = 1.0;     // of the spring's force that is felt; below 1 after a slip that lengthened the spring
  double grip_A_ = 0.0, grip_turn_A2_ = 0.0;  // as in Lag, for a hand at held_
  // The atoms touched there, with their shares of the normal force and their centres.
  struct Anchor {
    std::int32_t atom = -1;
    double share = 0.0;
    Vec3 centre_A{0.0};
  };
  std::vector<Anchor> anchors_;
  std::size_t anchor_count_ = 0;
  std::vector<AtomForce> room_;
};

}  // namespace moltact
