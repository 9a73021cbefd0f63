// Which source of motion moves the atoms. Oracle: the order of the claims and their ranks.
#include "app/ui/scene/motion_owner.h"

#include <doctest/doctest.h>

#include <optional>
#include <vector>

#include "app/ui/application/application.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {

TEST_CASE("of two sources of a scene the first owns the atoms until it releases them") {
  MotionOwner owner;
  MotionSource states(owner, MotionRank::Scene), trajectory(owner, MotionRank::Scene);
  CHECK_FALSE(owner.holder());
  CHECK(states.claim());
  CHECK(states.claim());
  CHECK_FALSE(trajectory.claim());
  trajectory.release();  // what it does not own
  CHECK(owner.holder() == &states);
  states.release();
  CHECK_FALSE(states.owns());
  CHECK(trajectory.claim());
}

TEST_CASE("a playback takes the atoms from a source of the scene, which cannot take them back before its release") {
  MotionOwner owner;
  MotionSource states(owner, MotionRank::Scene);
  std::optional<MotionSource> playback(std::in_place, owner, MotionRank::Playback);
  CHECK(states.claim());
  CHECK(playback->claim());
  CHECK_FALSE(states.owns());
  CHECK_FALSE(states.claim());
  playback.reset();  // a source that is destroyed releases
  CHECK_FALSE(owner.holder());
  CHECK(states.claim());
}

TEST_CASE("a scene moves its atoms by 1 A for the owner and not at all for another source") {
  const auto d = startWith("argon-pair");
  HapticSession& scene = d->app().scene;
  const auto first = [&] { return scene.atoms().seen()->spheres[0].centre_A; };
  const Vec3 rest = first();
  std::vector<Sphere> there(scene.stage().spheres->spheres().begin(), scene.stage().spheres->spheres().end());
  for (Sphere& s : there) s.centre_A.x += 1.0;
  MotionSource trajectory(scene.atoms().owner, MotionRank::Scene), simulation(scene.atoms().owner, MotionRank::Scene);
  REQUIRE(trajectory.claim());
  CHECK_FALSE(scene.moveAtoms(simulation, there, 33));
  CHECK_FALSE(scene.placeAtoms(simulation, there));
  d->frames(10);
  CHECK(glm::distance(first(), rest) == 0.0);
  CHECK(scene.moveAtoms(trajectory, there, 33));
  d->frames(10);
  CHECK(glm::distance(first(), rest + Vec3(1, 0, 0)) < 1e-9);
  trajectory.release();
  REQUIRE(simulation.claim());
  CHECK(scene.placeAtoms(simulation, scene.atoms().resting().spheres->spheres()));
  CHECK(glm::distance(first(), rest) == 0.0);
}

}  // namespace moltact
