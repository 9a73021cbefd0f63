// The interactions of the fault suite besides the methods: a tracker with invalid answers, and a rigid body with known
// springs. Unit: angstrom.
#pragma once

#include <memory>
#include <utility>
#include <vector>

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

/// A rigid body of two to six spheres in the hand, and a separate tracker with the same poses for each of them, to
/// compute the stored energy.
class WatchedBody final : public WrappedInteraction {
 public:
  static constexpr double kArm_A = 1.5;

  WatchedBody(const std::shared_ptr<const SphereGrid>& scene, std::vector<Sphere> spheres)
      : WrappedInteraction(std::make_unique<RigidBody>(
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
  /// The energy of the springs for the present SCPs, divided by the stiffness.
  double potential_A2(PointA place, const Quat& orientation) const {
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
  static std::shared_ptr<const HeldBody> bodyOf(const std::vector<Sphere>& spheres) {
    std::vector<std::uint32_t> all(spheres.size());
    for (std::uint32_t k = 0; k < all.size(); ++k) all[k] = k;
    return heldBody(spheres, all);
  }
  void resetAtoms() noexcept {
    for (Atom& a : atoms_) a.tracker->reset();
  }
  std::shared_ptr<const HeldBody> body_;
  std::vector<Atom> atoms_;
};

}  // namespace moltact::test
