#include "engine/bench/methods/body_methods.h"

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "engine/bench/methods/point_penalty.h"
#include "engine/haptics/body/exact_body.h"
#include "engine/haptics/body/rigid_body.h"
#include "engine/haptics/interactions.h"
#include "engine/haptics/methods.h"
#include "engine/haptics/wrapped_interaction.h"

namespace moltact::bench {
namespace {

class Exact final : public BodyUnderTest {
 public:
  Exact(std::shared_ptr<const SphereGrid> scene, std::shared_ptr<const HeldBody> body)
      : felt_(std::move(scene), std::move(body)) {}
  Interaction& interaction() noexcept override { return felt_; }
  Response tick(const PoseA& hand, double& made_A2) override {
    const Response out = felt_.respond(hand);
    const PoseA to = felt_.coupledHand();
    made_A2 = out.body_pose && before_ ? energy(*out.body_pose, to) - energy(*before_, to) : 0.0;
    before_ = out.body_pose;
    return out;
  }
  bool observe(BodyPathObserver* observer) override {
    felt_.observe(observer);
    return true;
  }

 private:
  double energy(const PoseA& body, const PoseA& hand) const {
    const Vec3 by = hand.place.A - body.place.A,
               turn = felt_.lever_A() * rotationBetween(body.orientation, hand.orientation);
    return 0.5 * (glm::dot(by, by) + glm::dot(turn, turn));
  }
  ExactBody felt_;
  std::optional<PoseA> before_;
};

class Points final : public BodyUnderTest {
 public:
  Points(std::shared_ptr<const SphereGrid> scene, std::shared_ptr<const HeldBody> body)
      : felt_(std::move(scene), std::move(body)) {}
  Interaction& interaction() noexcept override { return felt_; }
  Response tick(const PoseA& hand, double& made_A2) override {
    const double before_A2 = felt_.energyFor_A2(hand);
    const Response out = felt_.respond(hand);
    const bool held = out.contact.fault == Fault::None;
    made_A2 = held && held_ ? felt_.energyFor_A2(hand) - before_A2 : 0.0;
    held_ = held;
    return out;
  }

 private:
  PointPenalty felt_;
  bool held_ = false;
};

// Remembers the sphere's last position and SCP.
class Remembered final : public WrappedInteraction {
 public:
  explicit Remembered(std::unique_ptr<Interaction> inner) : WrappedInteraction(std::move(inner)) {}
  Response respond(const PoseA& pose) noexcept override {
    const Response out = inner().respond(pose);
    at = pose.place.A;
    scp = out.contact.scp.A;
    return out;
  }
  Vec3 at{0.0}, scp{0.0};
};

class Springs final : public BodyUnderTest {
 public:
  Springs(std::shared_ptr<const SphereGrid> scene, std::shared_ptr<const HeldBody> body)
      : felt_(std::move(body), [&](double radius_A) {
          auto sphere = std::make_unique<Remembered>(referenceMethod().make(scene, radius_A));
          spheres_.push_back(sphere.get());
          return sphere;
        }) {}
  Interaction& interaction() noexcept override { return felt_; }
  Response tick(const PoseA& hand, double& made_A2) override {
    before_.clear();
    for (const Remembered* s : spheres_) before_.push_back(s->scp);
    const Response out = felt_.respond(hand);
    const bool held = out.contact.fault == Fault::None;
    made_A2 = 0.0;
    for (std::size_t k = 0; held && held_ && k < spheres_.size(); ++k) {
      const Vec3 is = spheres_[k]->scp - spheres_[k]->at, was = before_[k] - spheres_[k]->at;
      made_A2 += 0.5 * (glm::dot(is, is) - glm::dot(was, was));
    }
    held_ = held;
    return out;
  }

 private:
  std::vector<Remembered*> spheres_;  // owned by felt_, which is created after them
  std::vector<Vec3> before_;
  bool held_ = false;
  RigidBody felt_;
};

using Scene = std::shared_ptr<const SphereGrid>;
using Body = std::shared_ptr<const HeldBody>;

template <class T>
std::unique_ptr<BodyUnderTest> test(Scene scene, Body body) {
  return std::make_unique<T>(std::move(scene), std::move(body));
}

std::unique_ptr<Interaction> makePoints(Scene scene, Body body) {
  return std::make_unique<PointPenalty>(std::move(scene), std::move(body));
}

// As the program creates it; the exact body of one sphere about its middle is the tracker exact.
std::unique_ptr<Interaction> ofProgram(const char* interaction, Scene scene, Body body) {
  InteractionInput input{.spheres = std::move(scene), .body = std::move(body)};
  input.touch.interaction = interaction;
  return makeInteraction(input);
}
std::unique_ptr<Interaction> makeExact(Scene scene, Body body) {
  return ofProgram("exact-body", std::move(scene), std::move(body));
}
std::unique_ptr<Interaction> makeSprings(Scene scene, Body body) {
  return ofProgram("springs", std::move(scene), std::move(body));
}

constexpr std::array kBodyTable{
    BodyMethod{"exact-body", "the rigid body that rests where its two springs are in balance and overlaps nothing",
               &makeExact, &test<Exact>, true},
    BodyMethod{"springs", "each atom is a god-object of its own; the sum of their springs", &makeSprings,
               &test<Springs>},
    BodyMethod{"point-penalty", "each atom that penetrates pushes; two springs to the hand, quasi-static", &makePoints,
               &test<Points>},
};

}  // namespace

std::span<const BodyMethod> bodyMethods() { return kBodyTable; }

const BodyMethod* findBodyMethod(std::string_view name) {
  for (const BodyMethod& m : kBodyTable)
    if (m.name == name) return &m;
  return nullptr;
}

}  // namespace moltact::bench
