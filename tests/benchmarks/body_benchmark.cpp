// Tick times of the exact rigid body: bodies of 1 to 5000 atoms, pressed into a scene, dragged and twisted. Each time is
// the minimum over three runs of the same tick, divided by the time of a plain loop of 1000 sphere distances in the same
// process, so that figures of different machines can be compared.
// Run: build/release/body_benchmark [name of a scene]; `body_benchmark springs [name of a scene]` compares the interaction
// `springs` with the exact body instead.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "engine/bench/hip_paths.h"
#include "engine/bench/scenes.h"
#include "engine/haptics/body/exact_body.h"
#include "engine/haptics/body/rigid_body.h"
#include "engine/haptics/methods.h"
#include "engine/molecule/reader.h"

namespace {

using namespace moltact;

constexpr int kTicks = 4000, kRuns = 3;

double now_ns() {
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Task {
  std::string name;
  std::shared_ptr<const SphereGrid> scene;
  std::shared_ptr<const HeldBody> body;
  Vec3 home;  // of the body's middle, free of overlap
  Vec3 into;  // unit vector: where the hand presses first
  double depth_A, twist_rad;
};

// From home the hand presses along a direction that turns, and twists the body back and forth.
std::vector<PoseA> pathOf(const Task& task) {
  const Vec3 u = task.into, v = glm::normalize(glm::cross(u, std::abs(u.z) < 0.8 ? Vec3(0, 0, 1) : Vec3(1, 0, 0)));
  const Vec3 axis = glm::normalize(u + 0.5 * v);
  std::vector<PoseA> out;
  for (int k = 0; k < kTicks; ++k) {
    const double t = double(k) / kTicks, phi = 1.2 * std::sin(kTwoPi * 2.3 * t);
    const double depth = task.depth_A * std::abs(std::sin(kTwoPi * t));
    out.push_back({{task.home + depth * (u * std::cos(phi) + v * std::sin(phi))},
                   glm::angleAxis(task.twist_rad * std::sin(kTwoPi * 1.3 * t), axis)});
  }
  return out;
}

const Molecule& molecule(const std::string& name) {
  static std::vector<std::pair<std::string, Molecule>> read;
  for (const auto& [id, m] : read)
    if (id == name) return m;
  auto made = readMolecule(std::string(MOLTACT_SOURCE_DIR "/molecules/") + name + ".pdb");
  if (!made) std::fprintf(stderr, "cannot read %s\n", name.c_str()), std::exit(2);
  return read.emplace_back(name, std::move(*made)).second;
}

double leastGap(std::span<const Sphere> scene, const HeldBody& body, const Vec3& place) {
  const SphereGrid grid(std::vector<Sphere>(scene.begin(), scene.end()));
  double least = 1e9;
  for (const Sphere& b : body.spheres) {
    const Vec3 c = place + b.centre_A;
    grid.visitNear(c, b.radius_A + 1.0, [&](std::uint32_t, const Sphere& s) {
      least = std::min(least, glm::distance(c, s.centre_A) - s.radius_A - b.radius_A);
    });
  }
  return least;
}

// The body of the given atoms, and the others as its scene. Moved outward along `out` until it is free.
Task taken(std::string name, std::span<const Sphere> spheres, const std::function<bool(std::size_t)>& held,
           const Vec3& out, double depth_A, double twist_rad) {
  std::vector<std::uint32_t> in;
  std::vector<Sphere> scene;
  for (std::size_t i = 0; i < spheres.size(); ++i)
    if (held(i))
      in.push_back(std::uint32_t(i));
    else
      scene.push_back(spheres[i]);
  Task task{std::move(name), nullptr, heldBody(spheres, in), {}, out, depth_A, twist_rad};
  if (!task.body) std::fprintf(stderr, "%s: no body\n", task.name.c_str()), std::exit(2);
  task.home = task.body->middle.A;
  while (leastGap(scene, *task.body, task.home) < 0.01) task.home += 0.05 * out;
  for (int k = 0; k < 2000 && leastGap(scene, *task.body, task.home) > 0.3; ++k) task.home -= 0.1 * out;
  task.into = -out;
  task.scene = std::make_shared<const SphereGrid>(std::move(scene));
  return task;
}

std::vector<Task> tasks(std::string_view only) {
  std::vector<Task> out;
  const auto wanted = [&](std::string_view name) { return only.empty() || only == name; };
  const Molecule& hpv = molecule("1hpv");
  const auto ligand = [&](std::size_t i) {
    const Atom& a = hpv.atoms[i];
    return a.residue != kNoResidue && hpv.residues[a.residue].kind == ResidueKind::Ligand;
  };
  std::vector<std::size_t> drug;
  for (std::size_t i = 0; i < hpv.spheres.size(); ++i)
    if (ligand(i)) drug.push_back(i);
  const Vec3 along = glm::normalize(Vec3(1, 2, 3));
  std::vector<Sphere> others;
  for (std::size_t i = 0; i < hpv.spheres.size(); ++i)
    if (!ligand(i)) others.push_back(hpv.spheres[i]);
  // The rest of the drug is left out of the scene of a part of it.
  const auto part = [&](std::string name, std::size_t n) {
    std::vector<Sphere> all = others;
    for (std::size_t k = 0; k < n; ++k) all.push_back(hpv.spheres[drug[k]]);
    return taken(
        std::move(name), all, [&](std::size_t i) { return i >= others.size(); }, along, 6.0, 0.8);
  };
  if (wanted("1")) out.push_back(part("1", 1));
  if (wanted("10")) out.push_back(part("10", 10));
  if (wanted("35")) out.push_back(part("35", drug.size()));
  if (wanted("35 in 122796")) {
    std::vector<Sphere> many;
    const Vec3 size(90.0);
    for (int k = 0; k < 81; ++k)
      for (const Sphere& s : others) many.push_back({s.centre_A + size * Vec3(k % 3, k / 3 % 3, k / 9), s.radius_A});
    const std::size_t scene = many.size();
    for (const std::size_t i : drug) many.push_back(hpv.spheres[i]);
    out.push_back(taken(
        "35 in 122796", many, [&](std::size_t i) { return i >= scene; }, along, 6.0, 0.8));
  }
  if (wanted("200")) {
    std::vector<Sphere> all = others;
    const Molecule& ubq = molecule("1ubq");
    Vec3 middle(0.0);
    for (const Sphere& s : others) middle += s.centre_A / double(others.size());
    const Vec3 by = middle - ubq.spheres[0].centre_A;
    for (std::size_t i = 0; i < 200; ++i) all.push_back({ubq.spheres[i].centre_A + by, ubq.spheres[i].radius_A});
    out.push_back(taken(
        "200", all, [&](std::size_t i) { return i >= others.size(); }, along, 6.0, 0.5));
  }
  if (wanted("1069")) {
    const Molecule& hhb = molecule("2hhb");
    const auto inA = [&](std::size_t i) {
      const Residue& r = hhb.residues[hhb.atoms[i].residue];
      return r.chain == 0 && r.kind == ResidueKind::AminoAcid;
    };
    Vec3 a(0.0), b(0.0);
    std::size_t n = 0;
    for (std::size_t i = 0; i < hhb.spheres.size(); ++i) (inA(i) ? (++n, a) : b) += hhb.spheres[i].centre_A;
    const Vec3 outward = glm::normalize(a / double(n) - b / double(hhb.spheres.size() - n));
    out.push_back(taken("1069", hhb.spheres, inA, outward, 6.0, 0.3));
  }
  if (wanted("5000")) {
    // Five thousand spheres packed as a protein's against a wall of four such bodies.
    std::vector<Sphere> all;
    const std::vector<Sphere> one = bench::proteinLike(5'000, 3);
    Vec3 low(1e9), high(-1e9);
    for (const Sphere& s : one) low = glm::min(low, s.centre_A), high = glm::max(high, s.centre_A);
    const Vec3 size = high - low;
    for (int k = 0; k < 4; ++k)
      for (const Sphere& s : one)
        all.push_back(
            {s.centre_A + 0.7 * size * Vec3(k % 2 ? 1 : -1, k / 2 ? 1 : -1, 0) - Vec3(0, 0, 0.9 * size.z), s.radius_A});
    const std::size_t scene = all.size();
    for (const Sphere& s : one) all.push_back(s);
    out.push_back(taken(
        "5000", all, [&](std::size_t i) { return i >= scene; }, Vec3(0, 0, 1), 6.0, 0.15));
  }
  return out;
}

// The time of a plain loop of 1000 sphere distances: the least of many.
double loop_ns() {
  std::vector<Sphere> spheres;
  scenes::Random random(1);
  for (int k = 0; k < 1000; ++k) spheres.push_back({50.0 * random.direction(), 1.7});
  double best = 1e9;
  volatile double sink = 0.0;
  for (int run = 0; run < 3000; ++run) {
    const Vec3 p(0.001 * run, 0, 0);
    double least = 1e9;
    const double from = now_ns();
    for (const Sphere& s : spheres) least = std::min(least, glm::distance(p, s.centre_A) - s.radius_A);
    best = std::min(best, now_ns() - from);
    sink = sink + least;
  }
  return best;
}

// Times the exact body, which is made anew for each run.
void timeTicks(const Task& task) {
  const std::vector<PoseA> path = pathOf(task);
  std::vector<double> least(path.size(), 1e12);
  std::size_t touching = 0, resting = 0;
  long steps = 0;
  for (int k = 0; k < kRuns; ++k) {
    ExactBody felt(task.scene, task.body);
    felt.respond({{task.home}});
    touching = resting = 0, steps = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const double from = now_ns();
      const Response r = felt.respond(path[i]);
      least[i] = std::min(least[i], now_ns() - from);
      touching += r.contact.touching();
      resting += r.at_rest;
      steps += felt.steps();
    }
  }
  const double loop = loop_ns();
  std::sort(least.begin(), least.end());
  const auto at = [&](double share) {
    return least[std::min(least.size() - 1, std::size_t(share * double(least.size())))] / 1e3;
  };
  const double mean = std::accumulate(least.begin(), least.end(), 0.0) / double(least.size()) / 1e3;
  std::printf("| %s | %.1f %% | %.2f %% | %.2f | %.1f | %.1f | %.0f | %.0f | %.0f | %.2f | %.0f |\n", task.name.c_str(),
              100.0 * double(touching) / double(path.size()), 100.0 * double(resting) / double(path.size()),
              double(steps) / double(path.size()), mean, at(0.5), at(0.99), at(0.999), least.back() / 1e3,
              1e3 * mean / loop, 1e3 * at(0.999) / loop);
  std::fflush(stdout);
}

// How far the interaction `springs` is from the exact body on the same path: its sum of springs, the same divided by
// the number of springs (as the safety stage softens it), and the overlap of the body as it is drawn. Stiffness 1 N/A.
void compareSprings(const Task& task) {
  ExactBody exact(task.scene, task.body);
  RigidBody springs(task.body, [&](double radius_A) { return referenceMethod().make(task.scene, radius_A); });
  exact.respond({{task.home}}), springs.respond({{task.home}});
  int both = 0;
  double force = 0.0, torque = 0.0, force_off = 0.0, torque_off = 0.0, soft_force_off = 0.0, soft_torque_off = 0.0,
         overlap = 0.0, most_overlap = 0.0, middle_off = 0.0, turned_off = 0.0, count = 0.0;
  for (const PoseA& hand : pathOf(task)) {
    const Response right = exact.respond(hand), felt = springs.respond(hand);
    if (!right.contact.touching() || !felt.contact.touching() || !right.at_rest) continue;
    ++both;
    force += glm::length(right.contact.displacement_A), torque += glm::length(right.torque_A2);
    force_off += glm::distance(felt.contact.displacement_A, right.contact.displacement_A);
    torque_off += glm::distance(felt.torque_A2, right.torque_A2);
    soft_force_off += glm::distance(felt.contact.displacement_A / felt.stiffness_factor, right.contact.displacement_A);
    soft_torque_off += glm::distance(felt.torque_A2 / felt.stiffness_factor, right.torque_A2);
    count += felt.stiffness_factor;
    const PoseA shown = felt.shownBody(hand);
    double deepest = 0.0;
    for (const Sphere& b : task.body->spheres) {
      const Vec3 c = shown.place.A + shown.orientation * b.centre_A;
      task.scene->visitNear(c, b.radius_A, [&](std::uint32_t, const Sphere& s) {
        deepest = std::max(deepest, b.radius_A + s.radius_A - glm::distance(c, s.centre_A));
      });
    }
    overlap += deepest, most_overlap = std::max(most_overlap, deepest);
    middle_off += glm::distance(shown.place.A, right.body_pose->place.A);
    turned_off += glm::length(rotationBetween(shown.orientation, right.body_pose->orientation));
  }
  const double n = std::max(1, both);
  std::printf("| %s | %.1f, %.1f | %.1f | %.1f, %.1f | %.1f, %.1f | %.2f (%.2f) | %.2f | %.2f |\n", task.name.c_str(),
              force / n, torque / n, count / n, force_off / n, torque_off / n, soft_force_off / n, soft_torque_off / n,
              overlap / n, most_overlap, middle_off / n, turned_off / n);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const bool springs = argc > 1 && std::string_view(argv[1]) == "springs";
  const std::vector<Task> all = tasks(argc > 1 + springs ? argv[1 + springs] : "");
  if (springs) {
    std::printf(
        "| body | force, torque | springs | off by: sum | divided by the springs | overlap drawn | middle | angle |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (const Task& task : all) compareSprings(task);
    return 0;
  }
  std::printf(
      "| body | contact | at rest | steps | mean us | p50 | p99 | p99.9 | max | mean / loop | p99.9 / loop |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const Task& task : all) timeTicks(task);
  std::printf("loop of 1000 sphere distances: %.2f us\n", loop_ns() / 1e3);
}
