// The table of interactions, and the probe as one of them.
#include <doctest/doctest.h>

#include <set>

#include "engine/bench/scenes.h"
#include "engine/haptics/interactions.h"
#include "engine/haptics/methods.h"
#include "tests/haptics/walk.h"

using namespace moltact;

TEST_CASE("every interaction has a name of its own, is made over a scene and says nothing of a hand outside it") {
  std::set<std::string_view> names;
  for (const InteractionKind& kind : interactionKinds()) {
    CAPTURE(std::string(kind.name));
    CHECK(names.insert(kind.name).second);
    CHECK_FALSE(kind.title.empty());
    CHECK_FALSE(kind.sentence.empty());
    CHECK(findInteractionKind(kind.name) == &kind);
    const auto spheres = test::makeScene({{{0, 0, 0}, 1.6}});
    // A kind that needs chemistry gets one atom without element and charge.
    const auto chemistry = std::make_shared<const AtomChemistry>(AtomChemistry{{0}, {0}, {}, {""}});
    const auto felt = kind.make({.spheres = spheres,
                                 .body = heldBody(spheres->spheres(), std::vector<std::uint32_t>{0}),
                                 .chemistry = chemistry});
    REQUIRE(felt);
    if (!kind.former_name.empty()) CHECK(findInteractionKind(kind.former_name) == &kind);
    // What has no probe says 0 and passes another radius over.
    const bool has_probe = felt->probe_A() != 0.0;
    if (&kind == &interactionKinds().front()) CHECK(has_probe);
    if (has_probe) CHECK(felt->probe_A() == 1.4);
    felt->setProbe(2.0);
    CHECK(felt->probe_A() == (has_probe ? 2.0 : 0.0));
    CHECK_FALSE(felt->respond({{Vec3(0, 0, 9)}, kNoRotation}).acts());
    CHECK(felt->respond({{Vec3(std::nan(""), 0, 0)}, kNoRotation}).contact.fault == Fault::NotFinite);
  }
}

TEST_CASE(
    "the probe answers 2000 poses as its tracker answers their places, however they are turned, and without a torque") {
  const scenes::Scene scene = scenes::cluster(20, 5);
  const auto spheres = test::makeScene(scene.spheres);
  for (const Method& method : methods()) {
    CAPTURE(std::string(method.name));
    TouchSetup touch;
    touch.method = method.name;
    touch.probe_A = scene.probe_A;
    const auto felt = makeInteraction({.spheres = spheres, .touch = touch});
    REQUIRE(felt);
    const auto tracker = method.make(spheres, scene.probe_A);
    int touching = 0, different = 0;
    for (const Vec3& place : scenes::walk(scene, 2000, 5)) {
      const Quat turned = glm::angleAxis(place.x, glm::normalize(Vec3(1, 2, 3)));
      const Response response = felt->respond({{place}, turned});
      const Contact c = tracker->step({place});
      touching += c.touching();
      different += response.contact.scp.A != c.scp.A || response.contact.displacement_A != c.displacement_A ||
                   response.contact.energy_A2 != c.energy_A2 || response.torque_A2 != Vec3(0.0);
    }
    CHECK(touching > 500);
    CHECK(different == 0);
  }
}

TEST_CASE("a method is judged by the reference method, with all other properties as felt") {
  for (const TouchProperty& p : touchProperties()) {
    CAPTURE(std::string(p.key));
    TouchSetup felt;
    felt.method = "penalty";
    felt.probe_A = 2.5;
    felt.stiffness_N_per_mm = 0.25;
    felt.force_on = false;
    const TouchSetup reference = referenceOf(felt);
    if (p.member == TouchMember(&TouchSetup::method))
      CHECK(isReference(*findMethod(reference.method)));
    else
      CHECK(touchValue(reference, p) == touchValue(felt, p));
  }
}

TEST_CASE("an unknown name creates neither an interaction nor a method") {
  const auto spheres = test::makeScene({{{0, 0, 0}, 1.6}});
  TouchSetup touch;
  CHECK(makeInteraction({.spheres = spheres, .touch = touch}));
  touch.method = "none";
  CHECK_FALSE(makeInteraction({.spheres = spheres, .touch = touch}));
  touch = {};
  touch.interaction = "none";
  CHECK_FALSE(makeInteraction({.spheres = spheres, .touch = touch}));
  touch = resolveInteraction(touch, true);
  CHECK_FALSE(makeInteraction({.spheres = spheres, .touch = touch}));  // no body
  CHECK(findInteractionKind("none") == nullptr);
}

TEST_CASE(
    "a setup is settled to what the hand holds: a body's interaction with a body, a probe's without, else as wanted") {
  TouchSetup wanted;
  wanted.method = "penalty";
  wanted.probe_A = 2.5;
  for (const bool body : {false, true})
    for (const char* interaction : {"probe", "springs", "exact-body", "body", "none"}) {
      wanted.interaction = interaction;
      const TouchSetup now = resolveInteraction(wanted, body);
      CHECK(findInteractionKind(now.interaction)->holds_body == body);
      TouchSetup otherwise = now;
      otherwise.interaction = interaction;
      CHECK(otherwise == wanted);
    }
  CHECK(resolveInteraction(TouchSetup{}, false) == TouchSetup{});
}
