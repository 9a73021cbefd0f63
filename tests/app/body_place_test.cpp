// A held body beside its original place. Oracle: its own atoms in the molecule's file.
#include "app/ui/scene/body_place.h"

#include <algorithm>
#include <cmath>

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

TEST_CASE(
    "the stopped atoms of a body are those of its contacts: each touches an atom named beside it to 1e-6 A where the "
    "body rests, and the shares add up to 1 on either side") {
  const ScratchFolder scratch;
  auto d = drugInHand("", scratch);
  const HapticSession& scene = d->app().scene;
  CHECK(scene.bodyContacts() == LoadedAtoms());
  d->point("view");
  d->press();
  d->frames(90);
  REQUIRE(scene.log().touching());
  const LoadedAtoms& contacts = scene.bodyContacts();
  CHECK(contacts.count >= 1);
  CHECK(contacts.count <= 6);
  const TouchableModel& stage = scene.stage();
  const auto farthest_A = [&] {
    const PoseA rest = scene.log().latest().shownBody();
    double out = 0.0;
    for (const LoadedAtom& mine : contacts.body) {
      const Sphere& sphere = stage.body->spheres[mine.atom];
      double gap_A = 1e9;
      for (const LoadedAtom& other : contacts.scene) {
        const Sphere& b = (*stage.spheres)[other.atom];
        gap_A = std::min(gap_A, glm::distance(rest.place.A + rest.orientation * sphere.centre_A, b.centre_A) -
                                    sphere.radius_A - b.radius_A);
      }
      out = std::max(out, std::abs(gap_A));
    }
    return out;
  };
  // The reactions are those of the newest tick; while the body still moves, that of the log is an earlier one.
  for (int k = 0; k < 300 && (contacts.body.empty() || farthest_A() >= 1e-6); ++k) d->frames(1);
  CHECK(farthest_A() < 1e-6);
  double shares = 0.0;
  for (const LoadedAtom& mine : contacts.body) shares += mine.share;
  CHECK(shares == doctest::Approx(1.0));
  shares = 0.0;
  for (const LoadedAtom& other : contacts.scene) shares += other.share;
  CHECK(shares == doctest::Approx(1.0));
  // Without reactions, as in a playback, the same atoms and perhaps others that are as near.
  const LoadedAtoms near = bodyContacts(stage, scene.log().latest(), {});
  CHECK(near.count == 0);
  for (const LoadedAtom& mine : contacts.body)
    CHECK(std::any_of(near.body.begin(), near.body.end(), [&](const LoadedAtom& n) { return n.atom == mine.atom; }));
  d->release();
  d->frames(60);
  CHECK(scene.bodyContacts() == LoadedAtoms());
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
