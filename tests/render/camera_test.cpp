// Oracle: the pinhole camera's closed forms.
#include "engine/render/camera.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "engine/molecule/molecule.h"

using namespace moltact;

TEST_CASE("the ray through a pixel passes through every place that is projected onto it, seed 7") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    Camera camera;
    camera.target.A = 50.0 * Vec3(u(random), u(random), u(random));
    camera.orbit(3 * u(random), 3 * u(random));
    camera.roll(3 * u(random));
    camera.distance_A = 30 + 20 * u(random);
    const PointA place{camera.fromView({8 * u(random), 6 * u(random), -20 + 15 * u(random)}).A};
    const Vec3 px = camera.project(place, 1280, 800);
    const Ray ray = camera.rayThrough(px.x, px.y, 1280, 800);
    CHECK(glm::length(ray.direction) == doctest::Approx(1.0).epsilon(1e-12));
    CHECK(glm::length(glm::cross(place.A - ray.origin.A, ray.direction)) < 1e-9);
    CHECK(glm::dot(place.A - ray.origin.A, ray.direction) > 0);
  }
}

TEST_CASE("the middle of an 800 x 600 picture is the target, and +y lies above it") {
  Camera camera;
  camera.target.A = Vec3(1, 2, 3);
  const Vec3 middle = camera.project(camera.target, 800, 600);
  CHECK(middle.x == doctest::Approx(400));
  CHECK(middle.y == doctest::Approx(300));
  CHECK(middle.z == doctest::Approx(40));
  CHECK(camera.project({Vec3(1, 3, 3)}, 800, 600).y < 300);
  CHECK(camera.project({Vec3(2, 2, 3)}, 800, 600).x > 400);
}

TEST_CASE("panning by 100 pixels moves the target by 100 pixels in the picture") {
  Camera camera;
  camera.orbit(0.7, 0.3);
  const PointA before = camera.target;
  camera.pan(100, -40, 800);
  const Vec3 px = camera.project(before, 1280, 800);
  CHECK(px.x == doctest::Approx(640 + 100));
  CHECK(px.y == doctest::Approx(400 - 40));
}

TEST_CASE("dragging the picture to the right turns what faces the viewer to the right") {
  Camera camera;
  const PointA front{Vec3(0, 0, 5)};
  camera.orbit(0.1, 0);
  CHECK(camera.project(front, 800, 800).x > 400);
  camera.orbit(0, 0.1);
  CHECK(camera.project(front, 800, 800).y > 400);
}

TEST_CASE("zooming by 2 halves the distance, stops at 0.5 A, and ignores invalid factors") {
  Camera camera;
  camera.zoom(2);
  CHECK(camera.distance_A == doctest::Approx(20));
  camera.zoom(1e9);
  CHECK(camera.distance_A == doctest::Approx(0.5));
  for (const double bad : {0.0, -1.0, std::nan(""), double(INFINITY)}) camera.zoom(bad);
  CHECK(camera.distance_A == doctest::Approx(0.5));
}

TEST_CASE(
    "a row of atoms toward the eye is turned to lie across the picture; one that lies aside, and a ring, stay as they "
    "are") {
  std::vector<PlacedAtom> in_row, in_ring;
  for (int k = 0; k < 10; ++k) {
    PlacedAtom a;
    a.position.A = {100.0 + 0.2 * k, -50.0 + 0.3 * k, 1.5 * k};
    in_row.push_back(a);
    a.position.A = {3.0 * std::cos(0.2 * k * std::numbers::pi), 0.0, 3.0 * std::sin(0.2 * k * std::numbers::pi)};
    in_ring.push_back(a);
  }
  Molecule row, ring;
  row.setAtoms(in_row);
  ring.setAtoms(in_ring);
  Camera camera;
  camera.lookSideOn(row);
  CHECK(std::abs(glm::dot(camera.right(), glm::normalize(Vec3(0.2, 0.3, 1.5)))) == doctest::Approx(1.0));
  CHECK(glm::length(camera.orientation) == doctest::Approx(1.0));
  // From there it stays, and so it does where the picture already shows it from the side.
  const glm::dquat turned = camera.orientation;
  camera.lookSideOn(row);
  CHECK(camera.orientation == turned);
  Camera other;
  other.lookSideOn(ring);
  CHECK(other.orientation == Camera().orientation);
  other.lookSideOn(Molecule());
  CHECK(other.orientation == Camera().orientation);
}

TEST_CASE("fitting a long molecule keeps every sphere in the picture and leaves no more than the margin, seed 3") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(-1, 1);
  std::vector<PlacedAtom> atoms;
  for (int i = 0; i < 300; ++i) {
    PlacedAtom a;
    a.position.A = Vec3(1e5 + 60 * u(random), 5 * u(random), 20 * u(random));
    a.radius_A = 1.7;
    atoms.push_back(a);
  }
  Molecule molecule;
  molecule.setAtoms(atoms);
  for (int view = 0; view < 20; ++view) {
    Camera camera;
    camera.orbit(3 * u(random), 3 * u(random));
    camera.fit(molecule, 1.6, 0.08);
    double largest = 0;
    for (const Sphere& a : molecule.spheres) {
      const Vec3 v = camera.toView(PointA{a.centre_A});
      // The tangent plane through the eye that touches the sphere on its outer side.
      for (const auto& [side, tan] :
           {std::pair{std::abs(v.x), camera.tanHalfX(1600, 1000)}, std::pair{std::abs(v.y), camera.tanHalfY()}})
        largest =
            std::max(largest, std::tan(std::atan2(side, -v.z) + std::asin(a.radius_A / std::hypot(side, v.z))) / tan);
    }
    CHECK(largest == doctest::Approx(0.92).epsilon(1e-6));
  }
}

TEST_CASE(
    "a flat molecule of 12 A x 8 A x 1 A, in 50 random poses, is seen along its thinnest axis from the side of that "
    "axis's "
    "largest component, seed 5; two places leave the camera as it is") {
  std::mt19937 random(5);
  std::normal_distribution<double> any;
  std::vector<Vec3> flat;
  for (int x = -6; x <= 6; ++x)
    for (int y = -4; y <= 4; ++y)
      for (const double z : {-0.5, 0.5}) flat.emplace_back(x, y, z);
  for (int pose = 0; pose < 50; ++pose) {
    CAPTURE(pose);
    const glm::dquat turn = glm::normalize(glm::dquat(any(random), any(random), any(random), any(random)));
    const Vec3 shift(100.0 * any(random), any(random), -30.0);
    std::vector<Vec3> placed;
    for (const Vec3& p : flat) placed.push_back(shift + turn * p);
    Camera camera;
    camera.lookAlongThinnest(placed);
    Vec3 normal = turn * Vec3(0, 0, 1);
    int largest = 0;
    for (int k = 1; k < 3; ++k)
      if (std::abs(normal[k]) > std::abs(normal[largest])) largest = k;
    if (normal[largest] < 0.0) normal = -normal;
    CHECK(glm::dot(camera.back(), normal) == doctest::Approx(1.0).epsilon(1e-6));
  }
  Camera camera;
  camera.lookAlongThinnest(std::vector<Vec3>{Vec3(0.0), Vec3(1, 2, 3)});
  CHECK(camera.orientation == Camera().orientation);
}
