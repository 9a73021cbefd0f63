// The shipped lesson on HIV protease in the dark: the tunnel with the drug against the tunnel without it, as felt by a
// hand that follows the instructions.
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/haptics/methods.h"
#include "tests/lesson/scripted_learner/step_picture.h"
#include "tests/lesson/shipped_hand.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE(
    "in the dark, pushed in at the middle of the view, a water molecule comes to rest on the drug, and without it 10 A "
    "deeper on the blades; round about, by up to 5 % of the view's width, 6 A deeper or more; either place counts, and "
    "the rim does not") {
  const std::string line =
      lineSaying("a-drug-in-its-tunnel", "a water molecule comes to rest 10 Å deeper without the medicine");
  CAPTURE(line);
  const Lesson lesson = shippedLesson("a-drug-in-its-tunnel");
  const TaskSpec& spec = taskOf(lesson, "in-or-out", "same");
  const StepPicture picture(lesson.steps[lesson.find("in-or-out").value()]);
  const Molecule& molecule = *picture.molecule;
  const AtomSet counted(spec.values["same"].selection, molecule), drug(spec.values["remove"].selection, molecule);
  const auto spheres = [&](bool with) {
    return with ? std::make_shared<const SphereGrid>(molecule.spheres)
                : std::make_shared<const SphereGrid>(molecule.spheres, drug.atoms());
  };
  const std::shared_ptr<const SphereGrid> scenes[] = {spheres(true), spheres(false)};
  const Camera& c = picture.camera();
  const auto pushed = [&](bool with, glm::dvec2 at_px) {
    const auto exact = findMethod("exact")->make(scenes[with ? 0 : 1], kWaterProbe_A);
    const Ray ray = c.rayThrough(at_px.x, at_px.y, StepPicture::kSize_px, StepPicture::kSize_px);
    Contact contact;
    // 1.5 A deep, as with a light push.
    for (double a = c.distance_A - 30; a < c.distance_A + 30; a += 0.01) {
      const Vec3 hand = ray.origin.A + ray.direction * a;
      contact = exact->step({hand});
      if (contact.touching() && glm::distance(contact.scp.A, hand) > 1.5) break;
    }
    return std::pair(contact, glm::dot(contact.scp.A - ray.origin.A, ray.direction));
  };
  const glm::dvec2 middle(0.5 * StepPicture::kSize_px);
  const auto [on_drug, drug_A] = pushed(true, middle);
  const auto [in_tunnel, tunnel_A] = pushed(false, middle);
  CHECK(drug.touchedBy(on_drug));
  const std::vector<std::uint32_t> blades = ShippedScene("1hpv").select("residue 25");
  CHECK(std::any_of(in_tunnel.atoms.begin(), in_tunnel.atoms.end(),
                    [&](std::int32_t a) { return std::find(blades.begin(), blades.end(), a) != blades.end(); }));
  CHECK(tunnel_A - drug_A == doctest::Approx(10).epsilon(0.05));
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      CAPTURE(x);
      CAPTURE(y);
      const glm::dvec2 at = middle + 0.05 * StepPicture::kSize_px * glm::dvec2(x, y);
      const auto [full, full_A] = pushed(true, at);
      const auto [empty, empty_A] = pushed(false, at);
      CHECK(empty_A - full_A >= 6.0);
      CHECK(counted.touchedBy(full));
      CHECK(counted.touchedBy(empty));
    }
  // Pulled by 4 A up, up to the left, and to the left.
  const std::string tip =
      lineSaying("a-drug-in-its-tunnel", "as soon as you pull it up or to the left a wall holds it");
  CAPTURE(tip);
  const Ray ray = c.rayThrough(middle.x, middle.y, StepPicture::kSize_px, StepPicture::kSize_px);
  for (const Vec3& on_screen : {Vec3(0, 1, 0), Vec3(-std::sqrt(0.5), std::sqrt(0.5), 0), Vec3(-1, 0, 0)}) {
    const Vec3 way = c.orientation * on_screen;
    const auto moved = [&](bool with) {
      const auto exact = findMethod("exact")->make(scenes[with ? 0 : 1], kWaterProbe_A);
      Contact contact;
      Vec3 hand;
      for (double a = c.distance_A - 30; !contact.touching() || glm::distance(contact.scp.A, hand) < 1.0; a += 0.01)
        contact = exact->step({hand = ray.origin.A + ray.direction * a});
      const Vec3 from = contact.scp.A;
      for (double s = 0; s < 4.0; s += 0.01) contact = exact->step({hand + way * s});
      return glm::dot(contact.scp.A - from, way);
    };
    CHECK(moved(false) < 1.2);
    CHECK(moved(true) > 1.8);
  }
  for (const char* rim : {"chain A and residue 48 and name O", "chain B and residue 8", "residue 29"})
    for (const std::uint32_t a : ShippedScene("1hpv").select(rim)) CHECK_FALSE(counted.has(std::int32_t(a)));
}
