// Pictures avoid unnecessary work: unchanged parts are reused, hidden ones are skipped, and a rotating view is coarser
// on a slow machine. The oracle is the same picture, redrawn or drawn completely.
#include <random>
#include <set>

#include "engine/bench/hip_paths.h"
#include "engine/render/adaptive_quality.h"
#include "engine/render/molecule_model.h"
#include "engine/render/sphere_blocks.h"
#include "tests/render/stage.h"

using namespace moltact;
using namespace moltact::test;

namespace {

std::shared_ptr<const Molecule> protein(std::size_t atoms, unsigned seed) {
  std::vector<PlacedAtom> out;
  for (const Sphere& b : bench::proteinLike(atoms, seed))
    out.push_back(atom(b.centre_A, b.radius_A, 6 + int(out.size() % 3)));
  return molecule(std::move(out));
}

ViewScene touched(double x_A) {
  static const auto m = protein(900, 4);
  ViewScene scene;
  scene.molecule = m;
  scene.camera.fit(*m, 1.5);
  scene.shown = {ViewPart::Atoms, ViewPart::Probe, ViewPart::Hip};
  scene.hip = PointA{scene.camera.target.A + scene.camera.back() * 14.0 + scene.camera.right() * x_A};
  return scene;
}

}  // namespace

TEST_CASE(
    "a picture in which only the probe has moved is to the last bit the one drawn again, with one sample and with two, "
    "and "
    "its atoms were not drawn again") {
  for (const int samples : {1, 2}) {
    const RenderOptions options{.samples = samples};
    for (const double x_A : {-6.0, -5.5, 3.0, 0.0}) {
      CAPTURE(samples);
      CAPTURE(x_A);
      drawn(touched(9.0), 300, 200, options);
      drawn(touched(-9.0), 300, 200, options);
      const Picture moved = drawn(touched(x_A), 300, 200, options);
      CHECK_FALSE(renderer().count().atoms_redrawn);
      renderer().invalidate();
      const Picture anew = drawn(touched(x_A), 300, 200, options);
      CHECK(renderer().count().atoms_redrawn);
      CHECK(compare(moved, anew, 0).pixels == 0);
    }
  }
}

TEST_CASE("edges are smooth wherever a molecule is: beside it the filter finds nothing to do") {
  // The same picture with a sphere in each corner, so that all of it is filtered, has the same pixels in the middle.
  std::vector<PlacedAtom> atoms{atom(Vec3(0), 2.0, 8), atom(Vec3(2.5, 1, 0), 1.6, 7)};
  ViewScene scene;
  scene.shown = {ViewPart::Atoms};
  scene.camera = frontCamera(40);
  scene.molecule = molecule(atoms);
  const Picture part = drawn(scene, 240, 160);
  const Vec3 right = scene.camera.right() * 14.0, up = scene.camera.up() * 9.0;
  for (const Vec3& corner : {right + up, right - up, up - right, -right - up}) atoms.push_back(atom(corner, 0.4, 6));
  scene.molecule = molecule(atoms);
  const Picture whole = drawn(scene, 240, 160);
  int differing = 0;
  for (int y = 30; y < 130; ++y)
    for (int x = 60; x < 180; ++x)
      for (int k = 0; k < 3; ++k) differing += std::abs(part.at(x, y)[k] - whole.at(x, y)[k]) > 24;
  CHECK(differing == 0);
}

TEST_CASE("blocks hold every sphere once, at most 48 each, and none reaches out of its block") {
  for (const std::size_t n : {std::size_t(1), std::size_t(48), std::size_t(49), std::size_t(5000)}) {
    std::vector<Sphere> spheres = bench::proteinLike(n, unsigned(n));
    spheres.resize(n);
    const SphereBlocks blocks(spheres);
    std::vector<int> times(n);
    for (const SphereBlocks::Block& block : blocks.blocks()) {
      CHECK(blocks.of(block).size() <= SphereBlocks::kMax);
      for (const std::uint32_t i : blocks.of(block)) {
        ++times[i];
        CHECK(glm::distance(spheres[i].centre_A, block.centre_A) + spheres[i].radius_A <= block.radius_A + 1e-9);
      }
    }
    CHECK(std::all_of(times.begin(), times.end(), [](int t) { return t == 1; }));
  }
  CHECK(SphereBlocks(std::vector<Sphere>()).blocks().empty());
}

TEST_CASE(
    "blocks refitted to spheres that moved by up to 3 A find the same near 200 places as a look at each of 5000; seed "
    "9") {
  std::vector<Sphere> spheres = bench::proteinLike(5000, 9);
  SphereBlocks blocks(spheres);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> by_A(-3.0, 3.0);
  for (Sphere& b : spheres) b.centre_A += Vec3(by_A(random), by_A(random), by_A(random));
  blocks.refit(spheres);
  for (int k = 0; k < 200; ++k) {
    const Vec3 place = spheres[random() % spheres.size()].centre_A + Vec3(by_A(random), by_A(random), by_A(random));
    std::set<std::uint32_t> found, expected;
    blocks.visitNear(spheres, place, 2.0, [&](std::uint32_t i, const Sphere&) { CHECK(found.insert(i).second); });
    for (std::uint32_t i = 0; i < spheres.size(); ++i)
      if (glm::distance(spheres[i].centre_A, place) <= spheres[i].radius_A + 2.0) expected.insert(i);
    CHECK(found == expected);
  }
}

TEST_CASE("a picture's data that are moved are those made again at the new places, and nothing is painted again") {
  const auto one = protein(3000, 4);
  std::vector<Sphere> places = one->spheres.copy();
  for (Sphere& b : places) b.centre_A = Vec3(b.centre_A.y, 1.5 * b.centre_A.x, b.centre_A.z) + Vec3(2, 0, 0);
  const auto two = std::make_shared<const Molecule>(one->movedTo(places));
  MoleculeModel moved(one);
  const unsigned painted = moved.painted;
  REQUIRE(moved.moveTo(two));
  const MoleculeModel made(two);
  CHECK(moved.painted == painted);
  CHECK(moved.colour == made.colour);
  CHECK(moved.middle_A == made.middle_A);
  CHECK(moved.reach_A == made.reach_A);
  CHECK(moved.spheres.sharesWith(two->spheres));
  for (std::size_t i = 0; i < places.size(); i += 100)
    CHECK(nearestAtoms(moved, {places[i].centre_A}, 1.4, 2.0, 9) ==
          nearestAtoms(made, {places[i].centre_A}, 1.4, 2.0, 9));
  CHECK_FALSE(moved.moveTo(protein(3000, 4)));
  CHECK(moved.molecule == two);
}

TEST_CASE("the light of atoms that move is found beside, and the picture is then that which waits for it") {
  ViewScene scene;
  const auto one = protein(1500, 3);
  std::vector<Sphere> places = one->spheres.copy();
  for (Sphere& b : places) b.centre_A.x *= 1.3;
  scene.molecule = one;
  scene.camera = frontCamera(90);
  drawn(scene, 240, 200);
  scene.molecule = std::make_shared<const Molecule>(one->movedTo(places));
  RenderOptions beside;
  beside.wait_for_surfaces = false;
  Picture last = drawn(scene, 240, 200, beside);
  for (int k = 0; k < 100'000 && renderer().count().light_pending; ++k) last = drawn(scene, 240, 200, beside);
  CHECK_FALSE(renderer().count().light_pending);
  const Picture waited = drawn(scene, 240, 200);
  CHECK(compare(last, waited, 0).pixels == 0);
}

TEST_CASE(
    "of 30 000 spheres a few pixels wide fewer than a third are drawn, and no pixel is more than 1 level from the "
    "picture of all") {
  ViewScene scene;
  scene.molecule = protein(30000, 2);
  scene.camera.fit(*scene.molecule, 1.5);
  scene.shown = {ViewPart::Atoms};
  for (const bool rims : {true, false}) {
    const Picture culled = drawn(scene, 300, 200, {.smooth_edges = false, .outlines = rims});
    CHECK(renderer().count().atoms_drawn < 10000);
    const Picture all = drawn(scene, 300, 200, {.smooth_edges = false, .outlines = rims, .occlusion_cull = false});
    CHECK(compare(culled, all, 1).pixels == 0);
  }
}

TEST_CASE(
    "from within a molecule, with blocks before, behind and round the eye, culling changes no pixel by more than 1 "
    "level") {
  ViewScene scene;
  scene.molecule = protein(3000, 6);
  scene.camera.fit(*scene.molecule, 1.5);
  scene.shown = {ViewPart::Atoms};
  for (const double closer : {3.0, 10.0, 40.0}) {
    ViewScene inside = scene;
    inside.camera.zoom(closer);
    const RenderOptions options{.smooth_edges = false, .outlines = true};
    const Picture culled = drawn(inside, 240, 160, options);
    RenderOptions whole = options;
    whole.occlusion_cull = false;
    CHECK(compare(culled, drawn(inside, 240, 160, whole), 1).pixels == 0);
  }
}

TEST_CASE(
    "a machine that takes 72 ms for a molecule draws it at half the width while it turns, one that takes 4 ms with "
    "four "
    "samples a pixel; at rest both smooth it after ten frames") {
  for (const auto& [ms, scale, samples] : {std::tuple{72.0, 0.5, 1}, std::tuple{4.0, 1.0, 2}}) {
    AdaptiveQuality fineness;
    for (int k = 0; k < 40; ++k) {
      const AdaptiveQuality::Choice choice = fineness.choose(true);
      fineness.took(ms * choice.scale * choice.scale * choice.options.samples * choice.options.samples);
    }
    const AdaptiveQuality::Choice moving = fineness.choose(true);
    CHECK(moving.scale == scale);
    CHECK(moving.options.samples == samples);
    CHECK_FALSE(fineness.unfinished());
    for (int k = 0; k < 9; ++k) CHECK(fineness.choose(false).scale == 1.0);
    CHECK(fineness.choose(false).options.samples == 2);
    CHECK_FALSE(fineness.unfinished());
  }
}

TEST_CASE(
    "a view that turns keeps its scale and its light where pictures without the fine light take 0.7 of the time") {
  for (const double ms : {60.0, 76.0, 80.0, 100.0, 140.0}) {
    AdaptiveQuality fineness;
    fineness.choose(true);
    fineness.took(ms);
    std::set<double> scales;
    for (int k = 0; k < 60; ++k) {
      const AdaptiveQuality::Choice choice = fineness.choose(true);
      fineness.took(ms * choice.scale * choice.scale * (choice.options.fine_light ? 1.0 : 0.7));
      scales.insert(choice.scale);
    }
    CHECK(scales.size() == 1);
  }
}

TEST_CASE(
    "a molecule that takes a second is never drawn with four samples a pixel, and no smoother picture is waited for") {
  AdaptiveQuality fineness;
  fineness.choose(true);
  fineness.took(1000.0);
  CHECK(fineness.choose(true).scale == 0.375);
  for (int k = 0; k < 30; ++k) {
    CHECK(fineness.choose(false).options.samples == 1);
    CHECK_FALSE(fineness.unfinished());
  }
}
