// The exact rigid body on any path of the hand: small steps, jumps, lost ticks, numbers that are none, any orientation and
// length of its quaternion, places up to and beyond the limit, among coincident, swelling and exchanged spheres. Its poses
// are free of overlap to 1e-9 A, its forces finite and zero without a pose, its work bounded, and it makes no energy.
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "engine/bench/scenes.h"
#include "engine/haptics/body/exact_body.h"
#include "engine/haptics/sphere_motion.h"
#include "tests/fuzz/target.h"

namespace moltact::fuzz {
namespace {

constexpr double kOverlap_A = 1e-9;
constexpr int kMaxFuzzedTicks = 60;
constexpr double kOdd[] = {0.0,
                           -0.0,
                           5e-324,
                           1e-310,
                           1e-160,
                           1e-12,
                           0.7,
                           1e9,
                           -1e9,
                           3e9,
                           1e160,
                           1e308,
                           std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()};

std::vector<Sphere> madeScene(Choices& choices) {
  const std::size_t seed = choices.pick(256);
  std::vector<Sphere> out;
  switch (choices.pick(8)) {
    case 0:
      out = scenes::oneSphere().spheres;
      break;
    case 1:
      out = scenes::duplicates().spheres;
      break;
    case 2:
      out = scenes::nested().spheres;
      break;
    case 3:
      out = scenes::ring(6, 1e-10).spheres;
      break;
    case 4:
      out = scenes::faceCentred(2).spheres;
      break;
    case 5:  // forty spheres of one centre and of radii that differ by their rounding
      for (int k = 0; k < 40; ++k) out.push_back({Vec3(1, 2, 3), 1.7 + 2e-16 * k});
      break;
    default:
      out = scenes::cluster(int(20 + choices.pick(30)), seed).spheres;
  }
  if (choices.pick(6) == 1)
    for (Sphere& s : out) s.centre_A += Vec3(1e6, -1e6, 1e5);
  return out;
}

std::shared_ptr<const HeldBody> madeBody(Choices& choices) {
  constexpr double kRadii_A[] = {1.4, 0.0, 1.0, 5e-324, 1e-9, 3.0};
  std::vector<Sphere> out;
  const std::size_t shape = choices.pick(4);
  scenes::Random random(choices.pick(256));
  const std::size_t count = shape == 0 ? 1 : 1 + choices.pick(12);
  Vec3 at(0.0);
  for (std::size_t k = 0; k < count; ++k) {
    out.push_back({at, k % 5 == 4 ? kRadii_A[choices.pick(std::size(kRadii_A))] : random.uniform(0.9, 1.4)});
    if (shape != 1) at += 1.5 * random.direction();  // shape 1: coincident centres
  }
  if (shape == 3)
    for (Sphere& s : out) s.centre_A += Vec3(6, 0, 0);  // its middle is outside
  return bodyOfSpheres(std::move(out));
}

Vec3 centreOf(const std::vector<Sphere>& spheres) {
  Vec3 sum(0.0);
  for (const Sphere& s : spheres) sum += s.centre_A / double(spheres.size());
  return sum;
}

double minGap_A(const std::vector<Sphere>& scene, const HeldBody& body, const PoseA& at) {
  const glm::dmat3 axes = glm::mat3_cast(at.orientation);
  double least = 1e300;
  for (const Sphere& b : body.spheres)
    for (const Sphere& s : scene)
      least = std::min(least, glm::length((at.place.A - s.centre_A) + axes * b.centre_A) - b.radius_A - s.radius_A);
  return least;
}

double energy_A2(const PoseA& body, const PoseA& hand, double lever_A) {
  const Vec3 d = hand.place.A - body.place.A;
  const double half = std::min(1.0, std::abs(glm::dot(body.orientation, hand.orientation)));
  // Of a small angle the cosine loses the digits that the difference keeps.
  const Quat minus = hand.orientation - body.orientation, plus = hand.orientation + body.orientation;
  const double chord = 0.5 * std::sqrt(std::min(glm::dot(minus, minus), glm::dot(plus, plus)));
  const double angle = half < 0.9 ? 2.0 * std::acos(half) : 4.0 * std::asin(std::min(1.0, chord));
  return 0.5 * (glm::dot(d, d) + lever_A * lever_A * angle * angle);
}

// The hand, led by choices.
class FuzzedHand {
 public:
  FuzzedHand(const Vec3& middle, double reach_A) : middle_(middle), reach_(reach_A), pose_{{middle}} {
    pose_.place.A.z += reach_A + 8.0;
  }

  PoseA next(Choices& choices) {
    constexpr double kFar_A[] = {30.0, 1e3, 1e6, 9.9e8, 1e9, 2e9};
    scenes::Random random(choices.pick(65'536));
    const std::size_t how = choices.pick(16);
    if (how < 5) drift_ = random.uniform(0.0, 0.4) * random.direction();
    if (how < 8) {
      const double lost = how == 7 ? double(1 + choices.pick(40)) : 1.0;  // the hand moves on while no tick comes
      pose_.place.A += lost * (drift_ + 0.3 * glm::normalize(middle_ - pose_.place.A + Vec3(0, 0, 1e-3)));
      turn(0.02 * lost * random.uniform(0.0, 1.0), random.direction());
    } else if (how == 8 || how == 9) {
      pose_.place.A = middle_ + random.uniform(0.0, 1.0) * (reach_ + 6.0) * random.direction();
    } else if (how == 10) {
      turn(random.uniform(-20.0, 20.0), random.direction());
    } else if (how == 11) {
      turn(kTwoPi / 2 - 1e-12 * double(choices.pick(4)), random.direction());
    } else if (how == 12) {
      PoseA far = pose_;
      far.place.A += kFar_A[choices.pick(std::size(kFar_A))] * random.direction();
      return far;
    } else if (how == 13) {
      PoseA odd = pose_;
      odd.place.A[int(choices.pick(3))] = kOdd[choices.pick(std::size(kOdd))];
      return odd;
    } else if (how == 14) {
      PoseA odd = pose_;
      odd.orientation[int(choices.pick(4))] = kOdd[choices.pick(std::size(kOdd))];
      return odd;
    } else {
      PoseA odd = pose_;
      odd.orientation = odd.orientation * (choices.pick(2) ? 1.0 + 4e-4 : kOdd[choices.pick(std::size(kOdd))]);
      return odd;
    }
    return pose_;
  }

 private:
  void turn(double angle_rad, const Vec3& axis) {
    pose_.orientation = glm::normalize(glm::angleAxis(angle_rad, axis) * pose_.orientation);
  }

  Vec3 middle_, drift_{0.0};
  double reach_;
  PoseA pose_;
};

// A scene, the body, and the motions of the spheres.
class FuzzedBody {
 public:
  explicit FuzzedBody(Choices& choices)
      : resting_(madeScene(choices)), spheres_(resting_), body_(madeBody(choices)), felt_(made(choices)) {}

  const std::vector<Sphere>& spheres() const { return spheres_; }
  double reach_A() const { return body_->reach_A; }

  // What happens to the scene between two ticks.
  void change(Choices& choices) {
    const std::size_t how = choices.pick(24);
    if (how == 1) {
      felt_->reset();
      before_.reset();
    } else if (how == 2) {
      move(choices);
    } else if (how == 3) {
      felt_->setMotion(nullptr);
      moving_ = nullptr;
      spheres_ = resting_;
      before_.reset();
    } else if (how == 4) {  // another scene, in the middle of a press
      resting_ = spheres_ = madeScene(choices);
      felt_ = made(choices);
      moving_ = nullptr;
      before_.reset();
    }
    if (!moving_ || fraction_ >= 1.0) return;
    fraction_ = std::min(1.0, fraction_ + 1.0 / moving_->ticks());
    felt_->advanceTo(fraction_);
    if (choices.pick(16) == 1) felt_->advanceTo(kOdd[choices.pick(std::size(kOdd))]), felt_->advanceTo(fraction_);
    spheres_ = moving_->at(fraction_);
    before_.reset();
  }

  void tick(const PoseA& hand) {
    const Response r = felt_->respond(hand);
    const Contact& c = r.contact;
    mustBe(finite(c.displacement_A) && finite(r.torque_A2) && std::isfinite(c.energy_A2) && finite(c.scp.A),
           "a force, an energy and a place that are numbers");
    const double far_A = glm::length(hand.place.A);
    const bool usable = finite(hand.place.A) && rotates(hand.orientation) && far_A <= kMaxPosition_A - reach_A();
    mustBe(usable == (c.fault != Fault::NotFinite), "a fault exactly where the hand has no pose");
    mustBe(felt_->steps() <= ExactBody::kMaxSteps, "at most so many steps");
    mustBe(felt_->changes() <= ExactBody::kMaxSceneChanges + ExactBody::kMaxChanges, "at most so many programs");
    mustBe(felt_->listWork() <= BodyPairs::kMaxWork + 2 * BodyPairs::kMaxFar, "at most so much work on the lists");
    AtomForce shared[6];
    const std::size_t reactions = felt_->reactions(r, 1.0, 1.0, shared);
    mustBe(reactions <= felt_->maxReactionCount(), "reactions that have room");
    Vec3 sum = c.displacement_A;
    for (std::size_t k = 0; k < reactions; ++k) sum += shared[k].force_N;
    mustBe(glm::length(sum) <= 1e-9 * (1.0 + glm::length(c.displacement_A)), "reactions opposite to the force");
    if (c.fault != Fault::None) {
      mustBe(!r.acts() && !r.body_pose, "no force without a pose");
      if (c.fault == Fault::StartedInside) before_.reset();
      return;
    }
    mustBe(r.body_pose && finite(r.body_pose->place.A), "a pose");
    const PoseA at = *r.body_pose;
    mustBe(std::abs(glm::dot(at.orientation, at.orientation) - 1.0) < 1e-12, "an orientation of unit length");
    if (!r.springsPull()) mustBe(c.energy_A2 == 0.0, "no energy without a force");
    // A coordinate of 1e9 A has a rounding of 1e-7 A.
    const double rounding_A = 1e-15 * (far_A + glm::length(at.place.A));
    mustBe(minGap_A(spheres_, *body_, at) >= -kOverlap_A - rounding_A, "no overlap");
    const PoseA to = felt_->coupledHand();
    const double energy = energy_A2(at, to, felt_->lever_A());
    if (r.springsPull()) {
      mustBe(glm::distance(c.displacement_A, at.place.A - to.place.A) <= 1e-9 + rounding_A, "the force of the spring");
      mustBe(std::abs(c.energy_A2 - energy) <= 1e-9 * (1.0 + energy) + 4.0 * rounding_A * std::sqrt(energy),
             "the energy of the springs");
      mustBe(std::abs(0.5 * (glm::dot(c.displacement_A, c.displacement_A) +
                             glm::dot(r.torque_A2, r.torque_A2) / (felt_->lever_A() * felt_->lever_A())) -
                      c.energy_A2) <= 1e-9 * (1.0 + energy),
             "the torque of the spring");
    }
    if (before_) {
      const double could = energy_A2(*before_, to, felt_->lever_A());
      mustBe(energy <= could + 1e-9 * (1.0 + could) + 4.0 * rounding_A * std::sqrt(could), "no energy made");
    }
    before_ = at;
  }

 private:
  std::unique_ptr<ExactBody> made(Choices& choices) {
    constexpr double kLevers_A2[] = {0.0, 0.0, 0.0, 1.0, 1e-6, 1e6};
    return std::make_unique<ExactBody>(std::make_shared<const SphereGrid>(spheres_), body_,
                                       kLevers_A2[choices.pick(std::size(kLevers_A2))]);
  }

  // Spheres that swell, shrink or move from where they are; or that jump to where another motion begins.
  void move(Choices& choices) {
    scenes::Random random(choices.pick(256));
    const std::size_t how = choices.pick(4);
    const int ticks = 1 + int(choices.pick(20));
    std::vector<Sphere> to = resting_;
    const double by_A = random.uniform(0.0, how == 2 ? 5.0 : 0.6);
    for (Sphere& s : to) {
      if (how != 1) s.radius_A = std::max(0.0, s.radius_A + random.uniform(-0.5, 1.0) * by_A);
      if (how != 0) s.centre_A += by_A * random.direction();
    }
    auto next = how == 3 || !moving_ ? SphereMotion::make(how == 3 ? resting_ : spheres_, to, ticks)
                                     : SphereMotion::after(*moving_, to, ticks);
    mustBe(bool(next), "a motion");
    motions_.push_back(std::move(*next));
    moving_ = motions_.back().get();
    fraction_ = 0.0;
    mustBe(felt_->setMotion(moving_), "a body that follows a motion");
    spheres_ = moving_->at(0.0);
    before_.reset();
  }

  std::vector<Sphere> resting_, spheres_;
  std::shared_ptr<const HeldBody> body_;
  std::vector<std::unique_ptr<const SphereMotion>> motions_;
  const SphereMotion* moving_ = nullptr;
  double fraction_ = 0.0;
  std::unique_ptr<ExactBody> felt_;
  std::optional<PoseA> before_;  // of the last tick, where the scene has not changed since
};

}  // namespace

void bodyPath(std::string_view bytes) {
  Choices choices(bytes);
  FuzzedBody felt(choices);
  FuzzedHand hand(centreOf(felt.spheres()), felt.reach_A());
  for (int k = 0; k < kMaxFuzzedTicks && choices.more(); ++k) {
    felt.change(choices);
    felt.tick(hand.next(choices));
  }
}

}  // namespace moltact::fuzz
