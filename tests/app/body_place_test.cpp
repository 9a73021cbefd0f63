// A held body beside its original place. Oracle: its own atoms in the molecule's file.
#include "app/ui/scene/body_place.h"

#include <cmath>
#include <span>

#include "tests/app/scripted_user_fixture.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

std::unique_ptr<ScriptedUser> drugInHand(const std::string& keys, const ScratchFolder& scratch) {
  writeFile(scratch.path / "back.md",
            "---\ntitle: Back\nminutes: 5\ngoals: G\nmolecules: 1hpv\nauthor: A\nlicence: L\n---\n## One\n"
            "```scene\nmolecule: 1hpv\nin-hand: ligand\n" +
                keys + "```\nText.\n");
  return startWith((scratch.path / "back.md").string());
}

ServoSample heldAt(const Vec3& middle_A, const Quat& turned = kNoRotation) {
  ServoSample s;
  s.hip.A = middle_A;
  s.orientation = turned;
  return s;
}

}  // namespace

TEST_CASE("all 35 atoms of the drug are in place where it lay and 0.99 A beside it, and none at 1.01 A") {
  const ScratchFolder scratch;
  auto d = drugInHand("", scratch);
  const TouchableModel& stage = d->app().scene.stage();
  REQUIRE(stage.body);
  const Vec3 home_A = stage.body->middle.A;
  CHECK(bodyPlace(stage, heldAt(home_A)).atoms == 35);
  CHECK(bodyPlace(stage, heldAt(home_A)).in_place == 35);
  CHECK(bodyPlace(stage, heldAt(home_A + Vec3(0.99, 0, 0))).in_place == 35);
  CHECK(bodyPlace(stage, heldAt(home_A + Vec3(0, 1.01, 0))).in_place == 0);
  // Turned by 180 degrees about x, as many as lie within 0.5 A of that axis.
  std::size_t near = 0;
  for (const Sphere& b : stage.body->spheres) near += std::hypot(b.centre_A.y, b.centre_A.z) <= 0.5;
  CHECK(bodyPlace(stage, heldAt(home_A, Quat(0, 1, 0, 0))).in_place == near);
}

TEST_CASE("atoms of a body that the hand presses into others are stopped; in its own place, and untouched, none is") {
  const ScratchFolder scratch;
  auto d = drugInHand("", scratch);
  const TouchableModel& stage = d->app().scene.stage();
  CHECK(bodyPlace(stage, heldAt(stage.body->middle.A)).stopped.empty());
  d->point("view");
  d->press();
  d->frames(90);
  REQUIRE(d->app().scene.log().touching());
  const ServoSample now = d->app().scene.log().latest();
  const BodyPlace place = bodyPlace(stage, now);
  REQUIRE_FALSE(place.stopped.empty());
  CHECK(place.stopped.size() < 35);
  // Each of them, and no other, is inside an atom of the protein.
  std::vector<std::uint32_t> inside;
  const std::span<const Sphere> all = stage.spheres->spheres();
  const std::vector<std::uint32_t> gone = stage.spheres->untouchable();
  for (std::size_t k = 0; k < stage.body->spheres.size(); ++k) {
    const Sphere& mine = stage.body->spheres[k];
    const Vec3 at = now.hip.A + now.orientation * mine.centre_A;
    for (std::size_t a = 0; a < all.size(); ++a) {
      if (std::binary_search(gone.begin(), gone.end(), std::uint32_t(a))) continue;
      if (glm::distance(at, all[a].centre_A) >= all[a].radius_A + mine.radius_A) continue;
      inside.push_back(std::uint32_t(k));
      break;
    }
  }
  CHECK(place.stopped == inside);
}

TEST_CASE("the number of atoms in place is shown if the scene marks the place of the held body, and only then") {
  const ScratchFolder scratch;
  {
    auto d = drugInHand("", scratch);
    CHECK_FALSE(d->shows("view/in place"));
  }
  auto d = drugInHand("highlight: ligand\n", scratch);
  ViewScene marks;
  d->app().lesson.decorate(marks);
  CHECK(marks.highlighted.size() == 35);  // its place is drawn
  d->point("view", 0.1, 0.1);
  d->frames(20);
  CHECK(d->text("view/in place") == "0 of 35 atoms in place, to 1\u00A0Å");
}

}  // namespace moltact
