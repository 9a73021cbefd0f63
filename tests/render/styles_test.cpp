// Drawing styles: hidden, faint or cut atoms, surfaces, spheres near the probe; anti-aliasing and the probe's shadow.
// Expected places come from closed forms and the projection.
#include <cmath>
#include <set>

#include "tests/render/stage.h"

using namespace moltact;
using namespace moltact::test;

namespace {

AtomList stylesList(std::vector<std::uint32_t> atoms) {
  return std::make_shared<const std::vector<std::uint32_t>>(std::move(atoms));
}

// A red sphere before a blue one.
ViewScene twoInLine() {
  ViewScene scene;
  scene.molecule = molecule({atom(Vec3(0, 0, 5), 1.5, 8), atom(Vec3(0, 0, -5), 3.0, 7)});
  scene.camera = frontCamera(40);
  scene.shown = {ViewPart::Atoms};
  return scene;
}

const RenderOptions kStylesPlain{.smooth_edges = false, .outlines = false};

int redOver(const Picture& p, int x, int y) { return int(p.at(x, y)[0]) - int(p.at(x, y)[2]); }

}  // namespace

TEST_CASE("an atom that is hidden is not drawn, and what lies behind it is") {
  ViewScene scene = twoInLine();
  const Picture both = drawn(scene, 200, 160, kStylesPlain);
  CHECK(redOver(both, 100, 80) > 40);
  scene.look.hidden = stylesList({0});
  const Picture without = drawn(scene, 200, 160, kStylesPlain);
  CHECK(redOver(without, 100, 80) < -40);
}

TEST_CASE("an atom at 40 % shows 40 % of itself and 60 % of what lies behind it, and hides no probe's depth") {
  ViewScene scene = twoInLine();
  const Picture opaque = drawn(scene, 200, 160, kStylesPlain);
  scene.look.hidden = stylesList({0});
  const Picture behind = drawn(scene, 200, 160, kStylesPlain);
  scene.look.hidden = nullptr;
  scene.look.styles = {{DrawStyle::Spheres, stylesList({1}), 1.0f}, {DrawStyle::Spheres, stylesList({0}), 0.4f}};
  const Picture faint = drawn(scene, 200, 160, kStylesPlain);
  for (int k = 0; k < 3; ++k) {
    const double expected = 0.4 * opaque.at(100, 80)[k] + 0.6 * behind.at(100, 80)[k];
    CHECK(std::abs(double(faint.at(100, 80)[k]) - expected) < 6.0);  // of 255: the front atom shades what lies behind
  }
}

TEST_CASE(
    "a sphere cut open in its middle shows a flat face as wide as the sphere and of one shade; cut before it, it is "
    "whole") {
  ViewScene scene;
  scene.molecule = molecule({atom(Vec3(0), 2.0, 8)});
  scene.camera = frontCamera(30);
  scene.shown = {};
  const Picture bare = drawn(scene, 301, 241, kStylesPlain);
  scene.shown = {ViewPart::Atoms};
  const Picture whole = drawn(scene, 301, 241, kStylesPlain);
  scene.look.cut = CutPlane{Vec3(0, 0, 1), 2.5};
  CHECK(compare(drawn(scene, 301, 241, kStylesPlain), whole, 0).pixels == 0);
  scene.look.cut->offset_A = -2.5;
  CHECK(compare(drawn(scene, 301, 241, kStylesPlain), bare, 0).pixels == 0);
  scene.look.cut->offset_A = 0.0;
  const Picture open = drawn(scene, 301, 241, kStylesPlain);
  const double radius_px = 2.0 / (30.0 * scene.camera.tanHalfY()) * 241 / 2;
  int across = 0;
  std::set<int> shades;
  for (int x = 0; x < 301; ++x) {
    const bool sphere = std::abs(open.at(x, 120)[0] - bare.at(x, 120)[0]) > 6;
    across += sphere;
    if (sphere) shades.insert(open.at(x, 120)[0]);
  }
  CHECK(across == doctest::Approx(2 * radius_px).epsilon(0.05));
  CHECK(*shades.rbegin() - *shades.begin() <= 12);
}

TEST_CASE("the molecular surface of one sphere covers the same pixels as the sphere, to within 2 at its edge") {
  ViewScene scene;
  scene.molecule = molecule({atom(Vec3(0.3, -0.2, 0.1), 2.0, 8)});
  scene.camera = frontCamera(24);
  scene.shown = {};
  const Picture bare = drawn(scene, 240, 200, kStylesPlain);
  scene.shown = {ViewPart::Atoms};
  const Picture sphere = drawn(scene, 240, 200, kStylesPlain);
  scene.look.styles = {{.style = DrawStyle::Surface}};
  const Picture surface = drawn(scene, 240, 200, kStylesPlain);
  const auto width = [&](const Picture& p, int y) {
    int n = 0;
    for (int x = 0; x < 240; ++x) n += std::abs(p.at(x, y)[0] - bare.at(x, y)[0]) > 6;
    return n;
  };
  for (const int y : {80, 100, 120}) CHECK(std::abs(width(sphere, y) - width(surface, y)) <= 4);
  CHECK(redOver(surface, 122, 101) > 40);
}

TEST_CASE("beside a surface, atoms whose own surface is within 2 A of the probe's appear as spheres, others do not") {
  ViewScene scene;
  scene.molecule = molecule({atom(Vec3(-4, 0, 0), 1.5, 8), atom(Vec3(4, 0, 0), 1.5, 8)});
  scene.camera = frontCamera(40);
  scene.shown = {ViewPart::Atoms};
  scene.look.styles = {{DrawStyle::Spheres, stylesList({}), 1.0f}};
  scene.hip = PointA{Vec3(-4, 4, 0)};  // 1.1 A from the first, 5.7 A from the second
  const Picture bare = drawn(scene, 240, 160, kStylesPlain);
  scene.look.spheres_near_A = 2.0;
  const Picture near = drawn(scene, 240, 160, kStylesPlain);
  const Vec3 first = scene.camera.project({Vec3(-4, 0, 0)}, 240, 160),
             second = scene.camera.project({Vec3(4, 0, 0)}, 240, 160);
  CHECK(redOver(near, int(first.x), int(first.y)) > redOver(bare, int(first.x), int(first.y)) + 40);
  CHECK(redOver(near, int(second.x), int(second.y)) == redOver(bare, int(second.x), int(second.y)));
}

TEST_CASE("the probe's shadow darkens the surface below it, the more the nearer it is, and nothing 15 A away") {
  ViewScene scene;
  scene.molecule = molecule({atom(Vec3(0), 6.0, 6), atom(Vec3(20, 0, 0), 6.0, 6)});
  scene.camera = frontCamera(80);
  scene.camera.target.A = Vec3(10, 0, 0);
  scene.shown = {ViewPart::Atoms};
  const Picture bare = drawn(scene, 400, 240, kStylesPlain);
  scene.shown.set(ViewPart::Probe);
  const auto brightness = [&](const Picture& p, const Vec3& place) {
    const Vec3 px = scene.camera.project({place}, 400, 240);
    return int(p.at(int(px.x), int(px.y))[1]);
  };
  // Beside the probe as it is seen, on the near sphere.
  const Vec3 place = 6.0 * glm::normalize(Vec3(-0.30, 0.0, 1.0));
  scene.hip = PointA{7.5 * glm::normalize(Vec3(-0.62, 0.0, 1.0))};
  const Picture close = drawn(scene, 400, 240, kStylesPlain);
  scene.hip = PointA{11.0 * glm::normalize(Vec3(-0.62, 0.0, 1.0))};
  const Picture far = drawn(scene, 400, 240, kStylesPlain);
  CHECK(brightness(close, place) < brightness(bare, place) - 4);
  CHECK(brightness(far, place) > brightness(close, place));
  const Vec3 away(20, 0, 6.0);
  CHECK(brightness(close, away) == brightness(bare, away));
}

TEST_CASE(
    "with one sample a pixel the filter gives the edge of a sphere shades between, and leaves what is plain as it is") {
  ViewScene scene;
  scene.molecule = molecule({atom(Vec3(0), 2.0, 1)});
  scene.camera = frontCamera(24);
  scene.shown = {ViewPart::Atoms};
  const Picture hard = drawn(scene, 240, 200, kStylesPlain), soft = drawn(scene, 240, 200, {.outlines = false});
  const Picture fine = drawn(scene, 240, 200, {.samples = 4, .outlines = false});
  // The error against the picture with 16 samples a pixel, where it is more than the noise of the background.
  double before = 0, after = 0;
  for (std::size_t k = 0; k < fine.rgb.size(); ++k) {
    const int off = std::abs(int(hard.rgb[k]) - int(fine.rgb[k]));
    if (off <= 8) continue;
    before += off;
    after += std::abs(int(soft.rgb[k]) - int(fine.rgb[k]));
  }
  CAPTURE(before);
  CAPTURE(after);
  CHECK(after < 0.8 * before);
  CHECK(compare(hard, soft, 0).pixels < 240 * 200 / 20);
}

TEST_CASE(
    "a surface that is computed beside the window shows the former style meanwhile, and then what waiting shows") {
  ViewScene scene = twoInLine();
  scene.camera.orbit(0.4, 0.2);
  const Picture spheres = drawn(scene, 200, 160, kStylesPlain);
  scene.look.styles = {{.style = DrawStyle::Surface}};
  scene.probe_A = 1.4;
  const Picture waited = drawn(scene, 200, 160, kStylesPlain);
  CHECK(compare(spheres, waited, 8).pixels > 100);
  renderer().invalidate();
  Molecule other = *scene.molecule;  // nothing of another is kept
  other.atoms = other.atoms.copy();
  scene.molecule = std::make_shared<const Molecule>(std::move(other));
  RenderOptions beside = kStylesPlain;
  beside.wait_for_surfaces = false;
  const Picture first = drawn(scene, 200, 160, beside);
  // The thread may have been quick; else there are spheres.
  if (renderer().count().surface_progress) CHECK(compare(first, spheres, 8).pixels == 0);
  Picture last = first;
  while (renderer().count().surface_progress) last = drawn(scene, 200, 160, beside);
  CHECK(compare(last, waited, 0).pixels == 0);
  // Another probe: the surface that is there stays until the other is.
  scene.probe_A = 3.0;
  const Picture kept = drawn(scene, 200, 160, beside);
  if (renderer().count().surface_progress) CHECK(compare(kept, waited, 0).pixels == 0);
  while (renderer().count().surface_progress) last = drawn(scene, 200, 160, beside);
  CHECK(compare(last, drawn(scene, 200, 160, kStylesPlain), 0).pixels == 0);
}
