#include "engine/bench/bodies/body_scenes.h"

#include <algorithm>
#include <cmath>

#include "engine/bench/scenes.h"

namespace moltact::bench {
namespace {

constexpr double kWayStep_A = 0.02, kStep_rad = 0.004;
constexpr int kHeld = 200;
const Vec3 kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

// Composes the hand's motion from segments.
class Way {
 public:
  explicit Way(const Vec3& start) { poses.push_back({{start}}); }
  // Straight to a pose, in equal steps of at most the given length, and of 0.004 rad for each 0.02 A of it.
  Way& to(const Vec3& place, const Quat& turn = kNoRotation, double step_A = kWayStep_A) {
    const PoseA from = poses.back();
    const double angle = glm::length(rotationBetween(from.orientation, turn));
    const int n = std::max({1, int(std::ceil(glm::distance(from.place.A, place) / step_A)),
                            int(std::ceil(angle / kStep_rad * kWayStep_A / step_A))});
    for (int k = 1; k <= n; ++k) {
      const double t = double(k) / n;
      poses.push_back({{from.place.A + (place - from.place.A) * t}, glm::slerp(from.orientation, turn, t)});
    }
    return *this;
  }
  Way& hold(int ticks) {
    for (int k = 0; k < ticks; ++k) poses.push_back(PoseA(poses.back()));
    return *this;
  }
  std::vector<PoseA> poses;
};

Quat turned(double angle_rad, const Vec3& axis) { return glm::angleAxis(angle_rad, glm::normalize(axis)); }

// nu by nv spheres about `middle` in the plane of u and v, with centres `apart` from each other.
void addPlate(std::vector<Sphere>& out, const Vec3& middle, const Vec3& u, const Vec3& v, int nu, int nv, double apart,
              double radius) {
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j)
      out.push_back({middle + apart * ((i - 0.5 * (nu - 1)) * u + (j - 0.5 * (nv - 1)) * v), radius});
}

std::shared_ptr<const HeldBody> row(int n, const Vec3& along, double apart, double radius) {
  std::vector<Sphere> out;
  for (int k = 0; k < n; ++k) out.push_back({apart * (k - 0.5 * (n - 1)) * along, radius});
  return bodyOfSpheres(std::move(out));
}

std::shared_ptr<const HeldBody> square(double apart, double radius) {
  std::vector<Sphere> out;
  addPlate(out, Vec3(0.0), kX, kY, 2, 2, apart, radius);
  return bodyOfSpheres(std::move(out));
}

BodyScene made(std::string name, std::string question, std::vector<Sphere> spheres,
               std::shared_ptr<const HeldBody> body, Way way) {
  return {std::move(name), std::move(question),   std::move(spheres),
          std::move(body), way.hold(kHeld).poses, std::size_t(kHeld)};
}

BodyScene keyInSlot() {
  std::vector<Sphere> slot;
  for (const double side : {-1.0, 1.0}) addPlate(slot, side * 3.0 * kY, kX, kZ, 8, 4, 2.0, 1.7);
  auto key = bodyOfSpheres({{{-2.25, 0, 0.3}, 1.2},
                            {{-0.75, 0, 0.3}, 1.2},
                            {{0.75, 0, 0.3}, 1.2},
                            {{2.25, 0, 0.3}, 1.2},
                            {{-2.25, 0, -1.2}, 1.2}});
  return made("key in a slot", "Does a key that two walls guide keep its orientation when it is twisted?",
              std::move(slot), std::move(key),
              Way({0, 0, 9}).to({0, 0, 0}).to({0, 0.3, 0}, turned(0.5, kZ)).to({1, 0, 0}, turned(-0.5, kZ + 0.3 * kX)));
}

BodyScene peg() {
  std::vector<Sphere> tube;
  for (const double z : {-2.4, 0.0, 2.4})
    for (const Sphere& s : scenes::ring(6, 0.01).spheres) tube.push_back({s.centre_A + z * kZ, s.radius_A});
  return made(
      "peg that fits to 0.01 A", "Does it slide into its hole, and tilt no farther than the hole allows?",
      std::move(tube), row(3, kZ, 2.4, 1.4),
      Way({0.01, 0.02, 9}).to({0.01, 0.02, 0}).to({0.4, 0, -1}, turned(0.25, kY)).to({0, 0.3, -2}, turned(0.2, kX)));
}

BodyScene squeezed() {
  std::vector<Sphere> walls;
  const double lean = 0.2;
  for (const double side : {-1.0, 1.0}) {
    const Vec3 up = glm::normalize(Vec3(0, side * std::sin(lean), std::cos(lean)));
    addPlate(walls, Vec3(0, side * 3.4, 0), kX, up, 7, 6, 2.2, 1.7);
  }
  return made(
      "squeezed between two walls", "Does a wedged body stay between the walls, however hard the hand pushes?",
      std::move(walls), square(1.7, 1.2),
      Way({0.1, 0.05, 10}).to({0.1, 0.05, -4}).to({0.4, 1, -4}, turned(0.4, kX)).to({0, -1, -4}, turned(0.3, kZ)));
}

BodyScene saddle() {
  return made("stick on a saddle", "Does a stick stay between two spheres while it is rolled and turned?",
              {{{2.4, 0, 0}, 2.5}, {{-2.4, 0, 0}, 2.5}}, row(7, kY, 1.0, 1.0),
              Way({0.05, 0, 8})
                  .to({0.05, 0, 1.2})
                  .to({0.6, 0.5, 1.2}, turned(0.4, kZ))
                  .to({-0.5, 0, 1.2}, turned(0.5, kX))
                  .to({0.1, 0.2, 1.4}, turned(0.3, kY)));
}

BodyScene corner() {
  std::vector<Sphere> walls;
  addPlate(walls, {5, 5, 0}, kX, kY, 6, 6, 2.0, 1.7);
  addPlate(walls, {5, 0, 5}, kX, kZ, 6, 6, 2.0, 1.7);
  addPlate(walls, {0, 5, 5}, kY, kZ, 6, 6, 2.0, 1.7);
  return made(
      "dumbbell in a corner", "Does a dumbbell rest on three walls at once while it is turned?", std::move(walls),
      row(2, kX, 3.0, 1.2),
      Way({12, 12, 12}).to({3, 2.2, 2}).to({3, 2.2, 2}, turned(0.8, kZ)).to({2.5, 2, 2.2}, turned(0.6, kY + 0.5 * kZ)));
}

BodyScene twist() {
  std::vector<Sphere> wall;
  addPlate(wall, Vec3(0.0), kX, kY, 9, 5, 2.0, 1.7);
  return made(
      "twist against a wall", "Does a bar that a wall keeps from turning give its torque, and no overlap?",
      std::move(wall), row(5, kX, 1.5, 1.2),
      Way({0.1, 0.1, 8}).to({0.1, 0.1, 2.6}).to({0.1, 0.1, 2.6}, turned(0.9, kY)).to({0.5, 0, 2.4}, turned(1.1, kY)));
}

BodyScene manyContacts() {
  std::vector<Sphere> lattice, body;
  addPlate(lattice, Vec3(0.0), kX, kY, 5, 5, 2.6, 1.5);
  addPlate(body, Vec3(0.0), kX, kY, 4, 4, 2.6, 1.2);
  return made(
      "64 contacts at once", "Is the force that of one spring, however many spheres touch?", std::move(lattice),
      bodyOfSpheres(std::move(body)),
      Way({0.3, -0.2, 7}).to({0.3, -0.2, 2}).to({0.1, 0, 1}, turned(0.02, kZ)).to({0, 0.2, 0.8}, turned(0.1, kX)));
}

BodyScene passes() {
  std::vector<Sphere> wall;
  addPlate(wall, Vec3(0.0), kX, kY, 9, 9, 3.0, 1.7);
  Way way({0.2, 0.3, 18});
  for (const double step : {0.1, 0.5, 2.0, 12.0})
    for (const Vec3& at : {Vec3(0.2, 0.3, 0), Vec3(-1.4, 0.8, 0), Vec3(2.1, -1.9, 0)})
      way.to(at + 18.0 * kZ, kNoRotation, step)
          .to(at - 18.0 * kZ, turned(0.3, kX), step)
          .hold(3)
          .to(at + 18.0 * kZ, kNoRotation, step);
  return made("passes a thin wall at up to 12 A a tick", "Is a fast body held by one layer of spheres?",
              std::move(wall), row(2, kX, 2.4, 1.2), way.to({0.2, 0.3, 6}, kNoRotation, 0.5).to({0.2, 0.3, 1.5}));
}

BodyScene jumps(std::uint64_t seed) {
  scenes::Random random(seed);
  std::vector<Sphere> cluster = scenes::cluster(80, seed).spheres;
  Vec3 middle(0.0);
  for (const Sphere& s : cluster) middle += s.centre_A / double(cluster.size());
  for (Sphere& s : cluster) s.centre_A -= middle;
  Way way({0, 0, 20});
  for (int k = 0; k < 40; ++k) {
    const double far = k % 4 == 3 ? 16.0 : random.uniform(0.0, 9.0);
    way.poses.push_back({{far * random.direction()}, turned(random.uniform(0.0, 0.6), random.direction())});
    way.hold(20);
  }
  way.poses.push_back({{{0, 0, 20}}});
  return made("jumps of the hand", "Does the body find a free rest after every jump?", std::move(cluster),
              bodyOfSpheres({{{1.2, 0, 0}, 1.2}, {{-1.2, 0, 0}, 1.2}, {{0, 1.3, 0.4}, 1.1}, {{0, -0.4, 1.5}, 1.0}}),
              way.hold(20).to({0, 0, 6}, kNoRotation, 0.1));
}

BodyScene cleft() {
  std::vector<Sphere> walls;
  for (const double side : {-1.0, 1.0}) addPlate(walls, side * 3.15 * kZ, kX, kY, 6, 6, 2.2, 1.7);
  std::vector<Sphere> swollen = walls;
  for (Sphere& s : swollen) s.radius_A += 0.2;
  BodyScene out =
      made("swelling cleft", "Is a body in a cleft pressed along by walls that swell, and never overlapped?",
           std::move(walls), square(1.7, 1.2), Way({0.1, 0.1, 0}).to({0.1, 0.3, 0.8}).hold(760));
  out.swollen = std::move(swollen);
  out.motion_ticks = 200, out.motions = 4;
  return out;
}

}  // namespace

std::vector<BodyScene> bodyScenes(std::uint64_t seed) {
  return {keyInSlot(), peg(), squeezed(), saddle(), corner(), twist(), manyContacts(), passes(), jumps(seed), cleft()};
}

std::vector<BodyScene> drawnBodyScenes(std::uint64_t seed, std::size_t draw) {
  std::vector<BodyScene> out = bodyScenes(seed + draw);
  if (draw == 0) return out;
  scenes::Random random(seed * 1000 + draw);
  for (BodyScene& scene : out) {
    const Quat by = turned(random.uniform(0.0, kTwoPi), random.direction());
    const Vec3 shift = 0.02 * random.direction();
    for (auto* spheres : {&scene.spheres, &scene.swollen})
      for (Sphere& s : *spheres) s.centre_A = by * s.centre_A;
    for (PoseA& p : scene.path) p = {{by * (p.place.A + shift)}, glm::normalize(by * p.orientation)};
  }
  return out;
}

}  // namespace moltact::bench
