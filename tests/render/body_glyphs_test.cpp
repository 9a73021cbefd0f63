// What is drawn of a body in the hand: its outline at the hand, the torque's arc, the glow of the atoms in contact.
#include <cmath>

#include "engine/render/glyphs.h"
#include "tests/render/stage.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE(
    "the outline of a body at the hand runs on its atoms' silhouettes there, and none is drawn where hand and body "
    "agree or for a probe") {
  ViewScene scene = rodInHand();
  scene.shown = {ViewPart::Probe};
  const MoleculeModel model(scene.molecule);
  Glyphs glyphs;
  addGlyphs(scene, &model, glyphs);
  REQUIRE_FALSE(glyphs.strokes.lines().empty());
  const glm::dmat3 hand = glm::mat3_cast(*scene.hand_orientation);
  for (const Strokes::Line& line : glyphs.strokes.lines())
    for (std::size_t i = line.begin; i < line.end; ++i) {
      const Vec3 p = scene.camera.fromView(Vec3(glyphs.strokes[i])).A;
      double off = 1e9;
      for (const Sphere& s : scene.body->spheres)
        off = std::min(off, std::abs(glm::distance(p, scene.hip->A + hand * s.centre_A) - 1.4));
      CHECK(off < 1e-4);
    }
  scene.hip = scene.body_place;
  scene.hand_orientation = kNoRotation;
  glyphs.clear();
  addGlyphs(scene, &model, glyphs);
  CHECK(glyphs.strokes.lines().empty());
}

TEST_CASE(
    "the arc of a torque lies about its axis at the body's radius of gyration, and is as long as the arrow of the "
    "force that gives the torque there; a torque the other way turns its head over") {
  ViewScene scene = rodInHand();
  scene.shown = {ViewPart::Force};
  scene.force_N = 0.0;
  scene.arrow_A_per_N = 2.0;
  const MoleculeModel model(scene.molecule);
  const double r = radiusOfGyration_A(*scene.body);
  REQUIRE(r == doctest::Approx(std::sqrt(8.0 / 3.0)));
  scene.camera.distance_A = 8.0;  // near enough for the arc of that radius to be 40 pixels wide
  for (const double sign : {-1.0, 1.0}) {
    scene.torque_N_A = Vec3(0, 0, sign * 1.5);
    Glyphs glyphs;
    addGlyphs(scene, &model, glyphs);
    REQUIRE(glyphs.cones.size() >= 3);
    double length = 0.0;
    for (std::size_t k = 0; k + 1 < glyphs.cones.size(); ++k) {
      const Vec3 a = scene.camera.fromView(Vec3(glyphs.cones[k].a)).A,
                 b = scene.camera.fromView(Vec3(glyphs.cones[k].b)).A;
      CHECK(glm::distance(a, scene.body_place->A) == doctest::Approx(r).epsilon(1e-4));
      CHECK(std::abs(a.z - scene.body_place->A.z) < 1e-4);
      CHECK(glm::cross(a - scene.body_place->A, b - a).z * sign > 0.0);
      length += glm::distance(a, b);
    }
    CHECK(length == doctest::Approx(2.0 * 1.5 / r).epsilon(0.01));
    CHECK(glyphs.cones.back().radius_b == 0.0f);
  }
  scene.body = nullptr;
  Glyphs glyphs;
  addGlyphs(scene, &model, glyphs);
  CHECK(glyphs.cones.empty());
}

TEST_CASE("an atom with half the share of another glows less, on the body and on the molecule; hidden atoms do not") {
  ViewScene scene = rodInHand();
  scene.shown = {ViewPart::Atoms, ViewPart::Probe};
  scene.body_stopped = {{0, 2.0 / 3.0}, {2, 1.0 / 3.0}};
  const MoleculeModel model(scene.molecule);
  Glyphs glyphs;
  addGlyphs(scene, &model, glyphs);
  REQUIRE(glyphs.shell.size() == 3);  // the molecule's atom, two of the body
  const auto alpha = [](const LooseSphere& s) { return s.colour >> 24; };
  CHECK(alpha(glyphs.shell[0]) == alpha(glyphs.shell[1]));
  CHECK(alpha(glyphs.shell[2]) < alpha(glyphs.shell[1]));
  CHECK(glyphs.shell[2].radius < glyphs.shell[1].radius);
  scene.look.hidden = std::make_shared<const std::vector<std::uint32_t>>(std::vector<std::uint32_t>{0, 1, 2, 3});
  glyphs.clear();
  addGlyphs(scene, &model, glyphs);
  CHECK(glyphs.shell.size() == 2);
}

// A golden picture allows for another driver's rounding: the mean within 1.5 levels and at most 1.5 % of the pixels off
// by more than 24. MOLTACT_UPDATE_GOLDEN=1 writes them anew; look at them before keeping them.
