// Pictures against closed forms: the perspective image of a sphere, the plane of intersection of two spheres, and the
// same picture with and without culling and far from the origin.
#include <cmath>
#include <random>

#include "engine/core/sphere_intersections.h"
#include "engine/render/gl_objects.h"
#include "tests/render/stage.h"

using namespace moltact;
using namespace moltact::test;

namespace {

const RenderOptions kPlain{.smooth_edges = false, .outlines = false};

ViewScene atomsOnly(std::vector<PlacedAtom> atoms, double distance_A) {
  ViewScene scene;
  scene.molecule = molecule(std::move(atoms));
  scene.camera = frontCamera(distance_A);
  scene.shown = {ViewPart::Atoms};
  return scene;
}

std::vector<PlacedAtom> crowd(Vec3 where_A, unsigned seed, int count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(-12, 12);
  std::vector<PlacedAtom> atoms;
  for (int i = 0; i < count; ++i) {
    // Quarters of an angstrom are exact in double precision at any place within 1e9 A.
    const Vec3 p = glm::round(4.0 * Vec3(u(random), u(random), u(random))) / 4.0;
    atoms.push_back(atom(where_A + p, 1.0 + 0.25 * (i % 5), i % 4 + 5));
  }
  return atoms;
}

bool isRed(const std::uint8_t* p) { return p[0] > p[2] + 25; }
bool isBlue(const std::uint8_t* p) { return p[2] > p[0] + 25; }

}  // namespace

TEST_CASE("a sphere of radius R at distance d spans tan(asin(R/d)) to within 1 pixel, near and far") {
  for (const double d : {4.0, 10.0, 60.0}) {
    const double radius = 0.13 * d;
    const int w = 401, h = 301;
    ViewScene scene = atomsOnly({atom(Vec3(0), radius, 8)}, d);
    const Picture with = drawn(scene, w, h, kPlain);
    scene.shown = {};
    const Picture without = drawn(scene, w, h, kPlain);
    const double expected = std::tan(std::asin(radius / d)) / scene.camera.tanHalfY() * h / 2;
    int across = 0, down = 0;
    for (int x = 0; x < w; ++x) across += std::abs(with.at(x, h / 2)[0] - without.at(x, h / 2)[0]) > 6;
    for (int y = 0; y < h; ++y) down += std::abs(with.at(w / 2, y)[0] - without.at(w / 2, y)[0]) > 6;
    CAPTURE(d);
    CHECK(across == doctest::Approx(2 * expected).epsilon(1.0 / expected));
    CHECK(down == doctest::Approx(2 * expected).epsilon(1.0 / expected));
  }
}

TEST_CASE("a sphere at the picture's corner covers the pixels whose rays meet it, and no others but at its edge") {
  const int w = 320, h = 240;
  const Vec3 centre(4.5, 3.5, 0);
  const double radius = 2.0;
  ViewScene scene = atomsOnly({atom(centre, radius, 8)}, 20);
  const Picture with = drawn(scene, w, h, kPlain);
  scene.shown = {};
  const Picture without = drawn(scene, w, h, kPlain);
  int wrong = 0;
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      const Ray ray = scene.camera.rayThrough(x + 0.5, y + 0.5, w, h);
      const double off = glm::length(glm::cross(centre - ray.origin.A, ray.direction)) - radius;
      if (std::abs(off) < 0.03) continue;  // half a pixel
      bool differs = false;
      for (int k = 0; k < 3; ++k) differs |= std::abs(with.at(x, y)[k] - without.at(x, y)[k]) > 4;
      wrong += differs != (off < 0);
    }
  CHECK(wrong == 0);
}

TEST_CASE("two spheres that overlap part along the plane in which they meet to within 1 pixel, on every row") {
  const int w = 400, h = 300;
  const Sphere red{Vec3(-1, 0, 0), 2.0}, blue{Vec3(1.2, 0, 0.6), 1.5};
  const ViewScene scene = atomsOnly({atom(red.centre_A, red.radius_A, 8), atom(blue.centre_A, blue.radius_A, 7)}, 12);
  const Picture picture = drawn(scene, w, h, kPlain);
  const auto circle = circleOf(red, blue);
  REQUIRE(circle);
  const Vec3 u = anyNormal(circle->axis), v = glm::cross(circle->axis, u);
  int checked = 0;
  for (int i = 0; i < 720; ++i) {
    const double t = i * 3.14159265358979 / 360;
    const Vec3 p = circle->centre_A + circle->radius_A * (std::cos(t) * u + std::sin(t) * v);
    const Vec3 to_eye = glm::normalize(scene.camera.eye().A - p);
    if (glm::dot(to_eye, p - red.centre_A) < 0.6 || glm::dot(to_eye, p - blue.centre_A) < 0.6) continue;
    const Vec3 px = scene.camera.project({p}, w, h);
    CHECK(isRed(picture.at(int(px.x - 1.5), int(px.y))));
    CHECK(isBlue(picture.at(int(px.x + 1.5), int(px.y))));
    ++checked;
  }
  CHECK(checked > 50);
}

TEST_CASE("of two atoms in line the nearer is seen, and one behind the eye is not") {
  const Picture near_red = drawn(
      atomsOnly({atom(Vec3(0, 0, 4), 1, 8), atom(Vec3(0), 1, 7), atom(Vec3(0, 0, 60), 1, 7)}, 20), 100, 100, kPlain);
  CHECK(isRed(near_red.at(50, 50)));
  const Picture near_blue = drawn(atomsOnly({atom(Vec3(0, 0, -4), 1, 8), atom(Vec3(0), 1, 7)}, 20), 100, 100, kPlain);
  CHECK(isBlue(near_blue.at(50, 50)));
}

TEST_CASE(
    "leaving out hidden atoms changes no pixel by more than 1 level; 3000 atoms, seeds 1 to 4, with and without rims") {
  for (const unsigned seed : {1u, 2u, 3u, 4u})
    for (const bool rims : {false, true}) {
      ViewScene scene = atomsOnly(crowd(Vec3(0), seed, 3000), 60 - 8.0 * seed);
      scene.camera.orbit(seed, 0.4);
      const Picture with = drawn(scene, 400, 300, {.smooth_edges = false, .outlines = rims});
      const std::size_t few = renderer().count().atoms_drawn;
      const Picture without =
          drawn(scene, 400, 300, {.smooth_edges = false, .outlines = rims, .occlusion_cull = false});
      const std::size_t all = renderer().count().atoms_drawn;
      const Difference difference = compare(with, without, 1);
      CAPTURE(seed);
      CHECK(difference.pixels == 0);
      CHECK(few * 2 < all);
    }
}

TEST_CASE("a molecule 1 000 000 A from the origin gives the same picture as at the origin") {
  const Vec3 far(1e6, -1e6, 1e6);
  ViewScene here = atomsOnly(crowd(Vec3(0), 5, 300), 70), there = atomsOnly(crowd(far, 5, 300), 70);
  there.camera.target.A = far;
  const Picture a = drawn(here, 320, 240), b = drawn(there, 320, 240);
  CHECK(compare(a, b, 1).pixels == 0);
}

TEST_CASE("two samples a pixel's edge give the same mean picture with smoother edges") {
  const ViewScene scene = atomsOnly(crowd(Vec3(0), 6, 200), 70);
  const Picture one = drawn(scene, 320, 240), two = drawn(scene, 320, 240, {.samples = 2});
  const Difference difference = compare(one, two, 40);
  CHECK(difference.mean < 4.0);
  CHECK(difference.pixels < 320 * 240 / 8);
}

TEST_CASE("a picture is kept while nothing changes, and the atoms are kept while only the HIP moves") {
  ViewScene scene = atomsOnly(crowd(Vec3(0), 7, 50), 70);
  scene.shown = {ViewPart::Atoms, ViewPart::Hip};
  const Picture before = drawn(scene, 600, 450);
  CHECK(renderer().count().atoms_redrawn);
  scene.hip = PointA{Vec3(0, 0, 20)};
  const Picture after = drawn(scene, 600, 450);
  CHECK_FALSE(renderer().count().atoms_redrawn);
  CHECK(compare(before, after, 8).pixels > 5);
  scene.camera.orbit(0.1, 0);
  (void)drawn(scene, 600, 450);
  CHECK(renderer().count().atoms_redrawn);
}

TEST_CASE("a size of 0 or 100 000 pixels is refused in words, and the next picture is good again") {
  const ViewScene scene = atomsOnly({atom(Vec3(0), 1, 8)}, 10);
  CHECK(renderer().draw(scene, 0, 100));
  CHECK(renderer().draw(scene, 100000, 100));
  CHECK(isRed(drawn(scene, 64, 64).at(32, 32)));
}

TEST_CASE("a shader with a fault is refused with its name and the driver's words") {
  (void)renderer();
  const auto program = GlProgram::build("broken", "void main() { nonsense; }", "void main() {}");
  REQUIRE_FALSE(bool(program));
  CHECK(program.problem().text().find("'broken'") != std::string::npos);
  CHECK(program.problem().text().find("nonsense") != std::string::npos);
}
