// The interactions of the fault suite besides the methods: a tracker with invalid answers, and rigid bodies of which the
// suite computes the stored energy itself. Unit: angstrom.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/haptics/body/exact_body.h"
#include "engine/haptics/body/rigid_body.h"
#include "engine/haptics/methods.h"
#include "engine/haptics/wrapped_interaction.h"
#include "tests/haptics/without_memory.h"

namespace moltact::test {

/// A method that returns invalid positions.
class BadTracker final : public WithoutMemory<Tracker> {
 public:
  explicit BadTracker(Vec3 scp) : scp_(scp) {}
  Contact step(PointA hip) noexcept override {
    Contact out{.scp = {scp_}, .atoms = {0, -1, -1}, .feature = Feature::Sphere};
    stretchToScp(out, hip);
    return out;
  }

 private:
  Vec3 scp_;
};

/// A rigid body of two to six spheres in the hand.
class WatchedBody : public WrappedInteraction {
 public:
  static constexpr double kArm_A = 1.5;
  using WrappedInteraction::WrappedInteraction;
  /// The energy of the springs for the hand at this pose and the surface's last answer, divided by the stiffness.
  virtual double potential_A2(PointA place, const Quat& orientation) const = 0;
  /// The deepest overlap of the last answer with these spheres. Zero where the method permits overlaps.
  virtual double overlap_A(const std::vector<Sphere>&) const { return 0.0; }

  static std::shared_ptr<const HeldBody> bodyOf(const std::vector<Sphere>& spheres) {
    std::vector<std::uint32_t> all(spheres.size());
    for (std::uint32_t k = 0; k < all.size(); ++k) all[k] = k;
    return heldBody(spheres, all);
  }
};

/// The exact body. Its energy follows from its pose alone: one spring to the hand's place, one to its orientation.
class WatchedExactBody final : public WatchedBody {
 public:
  WatchedExactBody(const std::shared_ptr<const SphereGrid>& scene, const std::vector<Sphere>& spheres)
      : WatchedBody(std::make_unique<ExactBody>(scene, bodyOf(spheres))), body_(bodyOf(spheres)) {
    // The lever of the rotational spring: the radius of gyration about the middle.
    Vec3 middle(0.0);
    for (const Sphere& s : body_->spheres) middle += s.centre_A / double(body_->spheres.size());
    for (const Sphere& s : body_->spheres)
      gyration2_ += glm::dot(s.centre_A - middle, s.centre_A - middle) / double(body_->spheres.size());
  }
  Response respond(const PoseA& pose) noexcept override {
    const Response out = inner().respond(pose);
    at_ = out.body_pose;
    return out;
  }
  double potential_A2(PointA place, const Quat& orientation) const override {
    if (!at_) return 0.0;
    const Vec3 d = at_->place.A - place.A;
    const double angle = 2.0 * std::acos(std::min(1.0, std::abs(glm::dot(at_->orientation, orientation))));
    return 0.5 * (glm::dot(d, d) + gyration2_ * angle * angle);
  }
  double overlap_A(const std::vector<Sphere>& scene) const override {
    double out = 0.0;
    for (const Sphere& b : body_->spheres)
      for (const Sphere& s : scene)
        if (at_)
          out = std::max(
              out, s.radius_A + b.radius_A - glm::distance(at_->place.A + at_->orientation * b.centre_A, s.centre_A));
    return out;
  }

 private:
  std::shared_ptr<const HeldBody> body_;
  double gyration2_ = 0.0;
  std::optional<PoseA> at_;
};

/// The interaction `springs`, and a separate tracker with the same poses for each sphere.
class WatchedSprings final : public WatchedBody {
 public:
  WatchedSprings(const std::shared_ptr<const SphereGrid>& scene, const std::vector<Sphere>& spheres)
      : WatchedBody(std::make_unique<RigidBody>(
            bodyOf(spheres), [&](double radius_A) { return methods().front().make(scene, radius_A); })),
        body_(bodyOf(spheres)) {
    for (const Sphere& b : body_->spheres) atoms_.push_back({b.centre_A, methods().front().make(scene, b.radius_A)});
  }
  Response respond(const PoseA& pose) noexcept override {
    const Response out = inner().respond(pose);
    for (Atom& a : atoms_) {
      const Contact c = a.tracker->step({pose.place.A + pose.orientation * a.lever});
      a.scp = c.scp.A;
      a.touching = c.touching();
    }
    if (out.contact.fault == moltact::Fault::StartedInside) resetAtoms();
    return out;
  }
  double potential_A2(PointA place, const Quat& orientation) const override {
    double sum = 0;
    for (const Atom& a : atoms_) {
      const Vec3 d = a.scp - place.A - orientation * a.lever;
      if (a.touching) sum += 0.5 * glm::dot(d, d);
    }
    return sum;
  }
  bool setMotion(const SphereMotion* motion) noexcept override {
    for (Atom& a : atoms_) a.tracker->setMotion(motion);
    return inner().setMotion(motion);
  }
  void advanceTo(double fraction) noexcept override {
    for (Atom& a : atoms_) a.tracker->advanceTo(fraction);
    inner().advanceTo(fraction);
  }
  void reset() noexcept override { resetAtoms(), inner().reset(); }

 private:
  struct Atom {
    Vec3 lever;
    std::unique_ptr<Tracker> tracker;
    Vec3 scp{0.0};
    bool touching = false;
  };
  void resetAtoms() noexcept {
    for (Atom& a : atoms_) a.tracker->reset();
  }
  std::shared_ptr<const HeldBody> body_;
  std::vector<Atom> atoms_;
};

}  // namespace moltact::test
