// The matrix of forces between atoms: the coupled field is sound in every scene, its rivals fail as the literature expects.
#include "engine/bench/energies/field_matrix.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/bench/closed_loop.h"
#include "engine/bench/scenes.h"
#include "engine/haptics/touch_setup.h"
#include "tests/haptics/body_paths.h"

using namespace moltact;
using namespace moltact::bench;

namespace {

const FieldScene& fieldSceneNamed(const std::vector<FieldScene>& all, std::string_view name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const FieldScene& s) { return s.name == name; });
  REQUIRE(found != all.end());
  return *found;
}

// The touch panel's slider "Stiffness" and the scenes' key `coupling`. The least is the default of one atom.
constexpr double kSlider_N_per_mm[] = {0.05, 0.3, 0.5, 1.0, 2.0};
constexpr double kCoupling_N_per_mm[] = {1.8e-3, 1e-2, 1e-1, kMaxCoupling_N_per_mm};

// A scene felt with this stiffness and coupling. The scale of the forces follows from both.
FieldScene feltWith(FieldScene scene, double slider_N_per_mm, double coupling_N_per_mm) {
  scene.loop_N_per_mm = slider_N_per_mm;
  const double coupling_kcal_mol_A2 = coupling_N_per_mm / (1e-5 * kForceUnit_pN);
  scene.N_per_kcal_mol_A = slider_N_per_mm / LoopSettings().workspace.A_per_mm / coupling_kcal_mol_A2;
  return scene;
}

// A chain of six charged atoms, led by a hand from outside over a cluster of 60, pressed half an angstrom deep, held, and
// taken away.
FieldScene heldBodyScene(std::uint64_t seed) {
  scenes::Random random(seed);
  FieldScene out{.name = "a body of six atoms over a cluster"};
  const auto atom = [&](const Vec3& at) { return PairAtom{at, 1.908f, 0.1094f, float(random.uniform(-0.5, 0.5))}; };
  out.spheres = scenes::cluster(60, seed).spheres;
  double radius_A = 0.0;
  for (const Sphere& s : out.spheres) {
    out.atoms.push_back(atom(s.centre_A));
    radius_A = std::max(radius_A, glm::length(s.centre_A) + s.radius_A);
  }
  out.body = moltact::test::chainBody(6, seed + 1);
  for (const Sphere& s : out.body->spheres) out.body_atoms.push_back(atom(s.centre_A));
  const double reach_A = out.body->reach_A;
  Vec3 direction = random.direction(), drift = random.direction();
  out.path.push_back({direction * (radius_A + reach_A + 12.0)});
  const auto to = [&](double height_A, int ticks) {
    const double from_A = glm::length(out.path.back());
    for (int k = 1; k <= ticks; ++k) {
      direction = glm::normalize(direction + drift * 0.0015);
      out.path.push_back(direction * (from_A + (height_A - from_A) * k / ticks));
    }
    drift = random.direction();
  };
  const double speed_A = random.uniform(0.01, 0.08);
  to(0.8 * radius_A, int((12.0 + reach_A + 0.2 * radius_A) / speed_A));
  for (int k = 0; k < 3; ++k) to(random.uniform(0.3, 0.8) * radius_A, 400);
  out.held_from = out.path.size();
  out.path.insert(out.path.end(), 800, Vec3(out.path.back()));
  out.held_to = out.path.size();
  to(radius_A + reach_A + 12.0, int((14.0 + radius_A + reach_A) / speed_A));
  out.path.insert(out.path.end(), 1000, Vec3(out.path.back()));
  return out;
}

}  // namespace

TEST_CASE("in the eight scenes of forces, as defined and in one draw, the coupled field is sound") {
  for (const std::size_t draw : {0u, 1u})
    for (const FieldScene& scene : fieldScenes(1, draw)) {
      CAPTURE(scene.name);
      const FieldResult r = runFieldScene(scene, "coupled");
      CHECK(failuresOf(r).empty());
      CHECK(r.overlap_A < 1e-9);
      CHECK(r.ticks == scene.path.size());
    }
}

TEST_CASE("at each gain of weak forces that the panel offers the coupled field is sound in the eight scenes") {
  for (double gain = 1.5; gain <= 8.0; gain += 0.5)
    for (FieldScene scene : fieldScenes(1, 0)) {
      CAPTURE(gain);
      CAPTURE(scene.name);
      scene.model.weak_gain = gain;
      const FieldResult r = runFieldScene(scene, "coupled");
      CHECK(failuresOf(r) == "");
      CHECK(r.overlap_A < 1e-9);
    }
}

TEST_CASE(
    "at stiffnesses from 0.05 to 2 N/mm and couplings from 1.8 to 1000 N/m, with the gain of weak forces 1 and 8, the "
    "coupled field makes no energy and enters no atom in the eight scenes") {
  for (const double slider_N_per_mm : kSlider_N_per_mm)
    for (const double coupling_N_per_mm : kCoupling_N_per_mm)
      for (const double gain : {1.0, kMaxWeakGain})
        for (FieldScene scene : fieldScenes(1, 0)) {
          CAPTURE(slider_N_per_mm);
          CAPTURE(coupling_N_per_mm);
          CAPTURE(gain);
          CAPTURE(scene.name);
          scene.model.weak_gain = gain;
          const FieldResult r = runFieldScene(feltWith(scene, slider_N_per_mm, coupling_N_per_mm), "coupled");
          CHECK(r.made_J < FieldLimits().made_J);
          CHECK(r.overlap_A < 1e-9);
          CHECK(r.broken == 0);
        }
}

TEST_CASE(
    "a held body of six atoms returns less than 10 microjoules more than it got in 48 random closed loops, at any "
    "stiffness, coupling, gain, medium and path; of fields given at the hand a fourth returns more or enters an atom "
    "by "
    "0.5 A") {
  double greatest_J = 0.0, rivals_J = 0.0;
  int pressed = 0, rivals_fail = 0;
  for (std::uint64_t seed = 100; seed < 148; ++seed) {
    scenes::Random random(seed);
    const double slider_N_per_mm = 0.05 * std::pow(40.0, random.uniform(0.0, 1.0)),
                 coupling_N_per_mm = 1.8e-3 * std::pow(kMaxCoupling_N_per_mm / 1.8e-3, random.uniform(0.0, 1.0)),
                 gain = random.uniform(1.0, kMaxWeakGain);
    FieldScene scene = feltWith(heldBodyScene(seed), slider_N_per_mm, coupling_N_per_mm);
    scene.model.weak_gain = gain;
    scene.model.kind = seed % 2 ? Dielectric::Distance : Dielectric::MehlerSolmajer;
    CAPTURE(seed);
    CAPTURE(slider_N_per_mm);
    CAPTURE(coupling_N_per_mm);
    CAPTURE(gain);
    const FieldResult r = runFieldScene(scene, "coupled"), rival = runFieldScene(scene, "direct");
    CHECK(r.ticks == scene.path.size());
    // Without any allowance for what sampling can make.
    CHECK(r.returned_J < FieldLimits().made_J);
    CHECK(r.overlap_A < 1e-9);
    CHECK(r.broken == 0);
    pressed += r.force_N > 0.3;
    rivals_fail += rival.returned_J > FieldLimits().made_J || rival.overlap_A > FieldLimits().overlap_A;
    greatest_J = std::max(greatest_J, r.returned_J), rivals_J = std::max(rivals_J, rival.returned_J);
  }
  MESSAGE("pressed by 0.3 N or more in ", pressed, " of 48 loops; the coupled field returned at most ", greatest_J,
          " J more than it got, a field at the hand ", rivals_J, " J; ", rivals_fail, " of these failed");
  CHECK(pressed >= 12);
  CHECK(rivals_fail >= 12);
}

TEST_CASE(
    "a field that is given at the hand: it goes into an atom at speed, makes energy from a start inside, vibrates by "
    "over "
    "1 mm in a well deeper than the device bears; a trilinear grid steps by over 1 N at a cell's face") {
  const std::vector<FieldScene> all = fieldScenes(1, 0);
  const auto fails = [&](const char* scene, std::string_view method, char criterion) {
    return failuresOf(runFieldScene(fieldSceneNamed(all, scene), method)).find(criterion) != std::string::npos;
  };
  for (const std::string_view m : {"direct", "bounded", "trilinear", "tricubic"}) {
    CAPTURE(m);
    CHECK(fails("steep wall at speed", m, 'O'));
    CHECK(fails("jump by 5 A", m, 'O'));
    CHECK(fails("overlapping hydrogen", m, 'O'));
    CHECK(fails("start inside an atom", m, 'E'));
    CHECK(fails("well deeper than the device bears", m, 'J'));
  }
  CHECK(runFieldScene(fieldSceneNamed(all, "well deeper than the device bears"), "direct").jitter_mm > 1.0);
  CHECK(fails("face of a cell, to and fro", "trilinear", 'S'));
  CHECK_FALSE(fails("face of a cell, to and fro", "tricubic", 'S'));
}

TEST_CASE("the table of the matrix has a row per scene, and a draw moves scene and hand together") {
  const std::vector<FieldResult> results = measureFieldMatrix({.seed = 1, .draws = 2}, {});
  CHECK(results.size() == 8 * kFieldMethods.size() * 2);
  const ReportTable table = fieldMatrix(results);
  CHECK(table.rows.size() == 8);
  CHECK(table.columns.size() == 1 + kFieldMethods.size());
  CHECK(fieldMatrixSentences(results).starts_with("* `coupled` is sound in 8 of 8 scenes."));
  const FieldScene a = fieldScenes(1, 0)[2], b = fieldScenes(1, 1)[2];
  CHECK(glm::distance(b.atoms[0].centre_A, b.path[100]) ==
        doctest::Approx(glm::distance(a.atoms[0].centre_A, a.path[100])));
  CHECK(b.path[100] != a.path[100]);
}
