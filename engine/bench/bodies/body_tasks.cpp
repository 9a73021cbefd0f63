#include "engine/bench/bodies/body_tasks.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>

#include "engine/bench/hip_paths.h"
#include "engine/bench/scenes.h"

namespace moltact::bench {
namespace {

double smallestGap_A(const SphereGrid& scene, const HeldBody& body, const Vec3& place) {
  double least = 1e9;
  for (const Sphere& b : body.spheres) {
    const Vec3 c = place + b.centre_A;
    scene.visitNear(c, b.radius_A + 1.0, [&](std::uint32_t, const Sphere& s) {
      least = std::min(least, glm::distance(c, s.centre_A) - s.radius_A - b.radius_A);
    });
  }
  return least;
}

// The body of the given spheres, and the others as its scene. Moved along `out` until it is free and near the scene.
BodyTask taken(std::string_view name, std::span<const Sphere> spheres, const std::function<bool(std::size_t)>& held,
               const Vec3& out, double twist_rad) {
  std::vector<std::uint32_t> in;
  std::vector<Sphere> scene;
  for (std::size_t i = 0; i < spheres.size(); ++i)
    if (held(i))
      in.push_back(std::uint32_t(i));
    else
      scene.push_back(spheres[i]);
  BodyTask task{
      std::string(name), std::make_shared<const SphereGrid>(std::move(scene)), heldBody(spheres, in), {}, -out, 6.0,
      twist_rad};
  task.home = task.body->middle.A;
  const auto gap_A = [&] { return smallestGap_A(*task.scene, *task.body, task.home); };
  while (gap_A() < 0.01) task.home += 0.05 * out;
  for (int k = 0; k < 2000 && gap_A() > 0.3; ++k) task.home -= 0.1 * out;
  return task;
}

// Spheres of a scene, followed by those of a body.
BodyTask beside(std::string_view name, std::vector<Sphere> scene, std::span<const Sphere> body, const Vec3& out,
                double twist_rad) {
  const std::size_t first = scene.size();
  scene.insert(scene.end(), body.begin(), body.end());
  return taken(
      name, scene, [&](std::size_t i) { return i >= first; }, out, twist_rad);
}

BodyTask chainOf(const Molecule& haemoglobin, std::string_view name) {
  const auto held = [&](std::size_t i) {
    const Residue& r = haemoglobin.residues[haemoglobin.atoms[i].residue];
    return r.chain == 0 && r.kind == ResidueKind::AminoAcid;
  };
  Vec3 inside(0.0), others(0.0);
  std::size_t n = 0;
  const std::size_t all = haemoglobin.spheres.size();
  for (std::size_t i = 0; i < all; ++i) (held(i) ? (++n, inside) : others) += haemoglobin.spheres[i].centre_A;
  return taken(name, haemoglobin.spheres, held, glm::normalize(inside / double(n) - others / double(all - n)), 0.3);
}

// Five thousand spheres packed as a protein's against a wall of four such bodies.
BodyTask packed(std::string_view name) {
  const std::vector<Sphere> one = proteinLike(5'000, 3);
  Vec3 low(1e9), high(-1e9);
  for (const Sphere& s : one) low = glm::min(low, s.centre_A), high = glm::max(high, s.centre_A);
  const Vec3 size = high - low;
  std::vector<Sphere> wall;
  for (int k = 0; k < 4; ++k)
    for (const Sphere& s : one)
      wall.push_back(
          {s.centre_A + 0.7 * size * Vec3(k % 2 ? 1 : -1, k / 2 ? 1 : -1, 0) - Vec3(0, 0, 0.9 * size.z), s.radius_A});
  return beside(name, std::move(wall), one, Vec3(0, 0, 1), 0.15);
}

}  // namespace

Expected<BodyTask> bodyTask(std::string_view name, const OpenMolecule& open) {
  if (name == "5000") return packed(name);
  if (name == "1069") {
    const auto haemoglobin = open("2hhb");
    if (!haemoglobin) return haemoglobin.problem();
    return chainOf(*haemoglobin, name);
  }
  const auto protease = open("1hpv");
  if (!protease) return protease.problem();
  std::vector<Sphere> drug, others;
  for (std::size_t i = 0; i < protease->spheres.size(); ++i) {
    const Atom& a = protease->atoms[i];
    const bool ligand = a.residue != kNoResidue && protease->residues[a.residue].kind == ResidueKind::Ligand;
    (ligand ? drug : others).push_back(protease->spheres[i]);
  }
  const Vec3 along = glm::normalize(Vec3(1, 2, 3));
  if (name == "200") {
    const auto ubiquitin = open("1ubq");
    if (!ubiquitin) return ubiquitin.problem();
    Vec3 middle(0.0);
    for (const Sphere& s : others) middle += s.centre_A / double(others.size());
    const Vec3 by = middle - ubiquitin->spheres[0].centre_A;
    std::vector<Sphere> part;
    for (std::size_t i = 0; i < 200; ++i)
      part.push_back({ubiquitin->spheres[i].centre_A + by, ubiquitin->spheres[i].radius_A});
    return beside(name, std::move(others), part, along, 0.5);
  }
  if (name == "35 in 122796") {
    std::vector<Sphere> many;
    for (int k = 0; k < 81; ++k)
      for (const Sphere& s : others) many.push_back({s.centre_A + 90.0 * Vec3(k % 3, k / 3 % 3, k / 9), s.radius_A});
    return beside(name, std::move(many), drug, along, 0.8);
  }
  // The rest of the drug is left out of the scene of a part of it.
  const std::size_t atoms = name == "1" ? 1 : name == "10" ? 10 : drug.size();
  return beside(name, std::move(others), std::span(drug).first(std::min(atoms, drug.size())), along, 0.8);
}

std::vector<PoseA> pathOf(const BodyTask& task, int ticks) {
  const Vec3 u = task.into, v = glm::normalize(glm::cross(u, std::abs(u.z) < 0.8 ? Vec3(0, 0, 1) : Vec3(1, 0, 0)));
  const Vec3 axis = glm::normalize(u + 0.5 * v);
  std::vector<PoseA> out;
  for (int k = 0; k < ticks; ++k) {
    const double t = double(k) / ticks, phi = 1.2 * std::sin(kTwoPi * 2.3 * t);
    const double depth = task.depth_A * std::abs(std::sin(kTwoPi * t));
    out.push_back({{task.home + depth * (u * std::cos(phi) + v * std::sin(phi))},
                   glm::angleAxis(task.twist_rad * std::sin(kTwoPi * 1.3 * t), axis)});
  }
  return out;
}

double distanceLoop_ns() {
  using Clock = std::chrono::steady_clock;
  std::vector<Sphere> spheres;
  scenes::Random random(1);
  for (int k = 0; k < 1000; ++k) spheres.push_back({50.0 * random.direction(), 1.7});
  double best = 1e9;
  volatile double sink = 0.0;
  for (int run = 0; run < 3000; ++run) {
    const Vec3 p(0.001 * run, 0, 0);
    double least = 1e9;
    const auto from = Clock::now();
    for (const Sphere& s : spheres) least = std::min(least, glm::distance(p, s.centre_A) - s.radius_A);
    best = std::min(best, std::chrono::duration<double, std::nano>(Clock::now() - from).count());
    sink = sink + least;
  }
  return best;
}

}  // namespace moltact::bench
