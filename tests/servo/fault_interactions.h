// What the fault suite has felt beside the methods: a tracker that answers with what no place is, and a rigid body of
// two spheres. Units: angstrom.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "engine/haptics/methods.h"
#include "tests/haptics/without_memory.h"

namespace moltact::test {

/// A method that answers with what no place is.
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

/// Two spheres at the ends of a bar, a rigid body in the hand: each kept out by a tracker of its own, each with its
/// spring.
class RigidPair final : public Interaction {
 public:
  static constexpr double kArm_A = 1.5;

  RigidPair(std::shared_ptr<const BallScene> scene, double probe_A)
      : ends_{methods().front().make(scene, probe_A), methods().front().make(scene, probe_A)} {}
  Response respond(const PoseA& pose) noexcept override {
    Response out;
    out.contact.scp = pose.place;
    for (std::size_t k = 0; k < 2; ++k) {
      const Vec3 arm = armOf(k, pose.orientation);
      const Contact c = ends_[k]->step({pose.place.A + arm});
      scps_[k] = c.scp.A;
      touching_[k] = c.touching();
      if (c.fault != moltact::Fault::None) out.contact.fault = c.fault;
      out.contact.feature = std::max(out.contact.feature, c.feature);
      out.contact.displacement_A += c.displacement_A;
      out.contact.energy_A2 += c.energy_A2;
      out.torque_A2 += glm::cross(arm, c.displacement_A);
    }
    if (out.contact.fault != moltact::Fault::None) return {.contact = {.scp = pose.place, .fault = out.contact.fault}};
    out.contact.scp.A += out.contact.displacement_A;
    return out;
  }
  /// What the springs hold with the SCPs where they are, over the stiffness.
  double potential_A2(PointA place, const Quat& orientation) const {
    double sum = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const Vec3 d = scps_[k] - place.A - armOf(k, orientation);
      if (touching_[k]) sum += 0.5 * glm::dot(d, d);
    }
    return sum;
  }
  bool setMotion(const SphereMotion* motion) noexcept override {
    return ends_[0]->setMotion(motion) && ends_[1]->setMotion(motion);
  }
  void advanceTo(double fraction) noexcept override { ends_[0]->advanceTo(fraction), ends_[1]->advanceTo(fraction); }
  void reset() noexcept override { ends_[0]->reset(), ends_[1]->reset(); }
  void setProbe(double probe_A) noexcept override { ends_[0]->setProbe(probe_A), ends_[1]->setProbe(probe_A); }
  double probe_A() const noexcept override { return ends_[0]->probe_A(); }
  double parallelSprings() const noexcept override { return 2.0; }
  bool hasOrientation() const noexcept override { return true; }
  MemoryUsage memoryUsage() const noexcept override { return {}; }

 private:
  static Vec3 armOf(std::size_t k, const Quat& orientation) { return orientation * Vec3(k ? -kArm_A : kArm_A, 0, 0); }
  std::array<std::unique_ptr<Tracker>, 2> ends_;
  std::array<Vec3, 2> scps_{};
  std::array<bool, 2> touching_{};
};

}  // namespace moltact::test
