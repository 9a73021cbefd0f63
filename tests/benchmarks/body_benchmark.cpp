// Tick times of the exact rigid body: bodies of 1 to 5000 atoms, pressed into a scene, dragged and twisted. Each time is
// the minimum over three runs of the same tick, divided by the time of a plain loop of 1000 sphere distances in the same
// process, so that figures of different machines can be compared. `moltact bench bodies` compares methods.
// A second table times the sum of the body's energies with the scene (PairSum) at the poses in which the body rested. All
// atoms are carbon there, with charges of 0.2 and -0.2 in turn; heavy atoms only.
// A third table does so for a ligand, 200 atoms and two chains of haemoglobin with all hydrogens that carry charges, 1 298
// atoms against 1 358 (2 142 against 2 241 with all hydrogens), and for one of them in 498 copies of the other, as many
// atoms as a capsid has.
// Run: build/release/body_benchmark [name of a scene, see body_tasks.h]
//      build/release/body_benchmark chains     the third table alone
//      build/release/body_benchmark leaps      the first tick of a motion that does not continue another, as when
//                                              molecules of a trajectory leap
//      build/release/body_benchmark points     the penalty of points with other stiffnesses of its pushes, in the scenes
//                                              of the matrix
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "engine/bench/bodies/body_matrix.h"
#include "engine/bench/bodies/body_tasks.h"
#include "engine/bench/bodies/body_trade_off.h"
#include "engine/bench/energies/energy_task.h"
#include "engine/bench/methods/point_penalty.h"
#include "engine/haptics/body/exact_body.h"
#include "engine/haptics/field/pair_sum.h"
#include "engine/haptics/sphere_motion.h"
#include "engine/molecule/reader.h"

namespace {

using namespace moltact;

constexpr int kTicks = 4000, kRuns = 3;

void timeTicks(const bench::BodyTask& task) {
  const std::vector<PoseA> path = bench::pathOf(task, kTicks);
  ExactBody felt(task.scene, task.body);
  felt.respond({{task.home}});
  std::size_t touching = 0, resting = 0;
  long steps = 0;
  for (const PoseA& hand : path) {
    const Response r = felt.respond(hand);
    touching += r.contact.touching();
    resting += r.at_rest;
    steps += felt.steps();
  }
  const double loop = bench::distanceLoop_ns(), n = double(path.size());
  const std::vector<double> ns = bench::bodyTickTimes_ns(
      task, [&] { return std::make_unique<ExactBody>(task.scene, task.body); }, path, kRuns);
  const auto at_us = [&](double share) { return ns[std::min(ns.size() - 1, std::size_t(share * n))] / 1e3; };
  const double mean_us = std::accumulate(ns.begin(), ns.end(), 0.0) / n / 1e3;
  std::printf("| %s | %.1f %% | %.2f %% | %.2f | %.1f | %.1f | %.0f | %.0f | %.0f | %.2f | %.0f |\n", task.name.c_str(),
              100.0 * double(touching) / n, 100.0 * double(resting) / n, double(steps) / n, mean_us, at_us(0.5),
              at_us(0.99), at_us(0.999), ns.back() / 1e3, 1e3 * mean_us / loop, 1e3 * at_us(0.999) / loop);
  std::fflush(stdout);
}

std::vector<PairAtom> carbon(std::span<const Sphere> spheres) {
  std::vector<PairAtom> out;
  for (const Sphere& s : spheres) out.push_back({s.centre_A, 1.908f, 0.086f, out.size() % 2 ? -0.2f : 0.2f});
  return out;
}

void timePairs(const bench::BodyTask& task, Dielectric kind, const char* title) {
  ExactBody felt(task.scene, task.body);
  felt.respond({{task.home}});
  std::vector<PoseA> rests;
  for (const PoseA& hand : bench::pathOf(task, kTicks)) rests.push_back(felt.respond(hand).shownBody(hand));
  PairModel model;
  model.kind = kind;
  std::vector<double> us(rests.size(), 1e9);
  std::size_t pairs = 0;
  for (int run = 0; run < kRuns; ++run) {
    PairSum sum(task.scene, carbon({task.scene->spheres().begin(), task.scene->size()}), carbon(task.body->spheres),
                model);
    sum.at(rests.front());  // the first lists
    for (std::size_t k = 0; k < rests.size(); ++k) {
      const auto begun = std::chrono::steady_clock::now();
      sum.at(rests[k]);
      us[k] =
          std::min(us[k], std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begun).count());
      pairs = std::max(pairs, sum.listedPairs());
    }
  }
  const double loop_us = bench::distanceLoop_ns() / 1e3,
               mean = std::accumulate(us.begin(), us.end(), 0.0) / double(us.size());
  std::sort(us.begin(), us.end());
  const double tail = us[std::min(us.size() - 1, us.size() * 999 / 1000)];
  std::printf("| %s | %s | %zu | %.1f | %.1f | %.1f | %.2f | %.1f |\n", task.name.c_str(), title, pairs, mean,
              us[us.size() / 2], tail, mean / loop_us, tail / loop_us);
  std::fflush(stdout);
}

// Copies of the scene's atoms in a cubic lattice beside it; none comes near the body.
bench::EnergyTask amongCopies(const bench::EnergyTask& task, int copies) {
  bench::EnergyTask out = task;
  out.name += " among copies";
  const int edge = int(std::ceil(std::cbrt(double(copies))));
  for (int k = 1; k < copies; ++k) {
    const Vec3 by = 90.0 * Vec3(k % edge, k / edge % edge, k / edge / edge);
    for (PairAtom a : task.atoms) {
      a.centre_A += by;
      out.atoms.push_back(a);
    }
  }
  std::vector<Sphere> places;
  for (const PairAtom& a : out.atoms) places.push_back({a.centre_A, 1.0});
  out.scene = std::make_shared<const SphereGrid>(std::move(places));
  return out;
}

void timeField(const bench::EnergyTask& task, Dielectric kind, const char* title) {
  const std::vector<PoseA> path = bench::energyPath(task, kTicks);
  PairModel model;
  model.kind = kind;
  std::vector<double> us(path.size(), 1e9);
  std::size_t pairs = 0;
  for (int run = 0; run < kRuns; ++run) {
    PairSum sum(task.scene, task.atoms, task.held, model);
    for (int warm = 0; warm < PairSum::kCurvatureTicks; ++warm) sum.at(path.front());
    for (std::size_t k = 0; k < path.size(); ++k) {
      const auto begun = std::chrono::steady_clock::now();
      sum.at(path[k]);
      us[k] =
          std::min(us[k], std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begun).count());
      pairs = std::max(pairs, sum.listedPairs());
    }
  }
  const double loop_us = bench::distanceLoop_ns() / 1e3,
               mean = std::accumulate(us.begin(), us.end(), 0.0) / double(us.size());
  std::sort(us.begin(), us.end());
  const double tail = us[std::min(us.size() - 1, us.size() * 999 / 1000)];
  std::printf("| %s | %zu | %zu | %s | %zu | %.1f | %.1f | %.1f | %.1f |\n", task.name.c_str(), task.held.size(),
              task.atoms.size(), title, pairs, mean, tail, mean / loop_us, tail / loop_us);
  std::fflush(stdout);
}

// The penalty of points with one stiffness of its pushes.
template <int kStiffness>
class Points final : public bench::BodyUnderTest {
 public:
  Points(std::shared_ptr<const SphereGrid> scene, std::shared_ptr<const HeldBody> body)
      : felt_(std::move(scene), std::move(body), 0.0, double(kStiffness)) {}
  Interaction& interaction() noexcept override { return felt_; }
  Response tick(const PoseA& hand, double& made_A2) override {
    made_A2 = 0.0;
    return felt_.respond(hand);
  }

 private:
  bench::PointPenalty felt_;
};

template <int kStiffness>
void sweepPoints() {
  static const bench::BodyMethod method{
      "points", "", nullptr,
      [](std::shared_ptr<const SphereGrid> scene,
         std::shared_ptr<const HeldBody> body) -> std::unique_ptr<bench::BodyUnderTest> {
        return std::make_unique<Points<kStiffness>>(std::move(scene), std::move(body));
      }};
  double overlap = 0, force = 0, jitter = 0;
  std::size_t sound = 0, tunnelled = 0, unrested = 0;
  const std::vector<bench::BodyScene> scenes = bench::bodyScenes(1);
  std::vector<double> forces;
  for (const bench::BodyScene& scene : scenes) {
    const bench::BodyResult r = bench::runBodyScene(scene, method);
    sound += bench::failuresOf(r).empty();
    overlap = std::max(overlap, r.overlap_A), force = std::max(force, r.force_N), jitter = std::max(jitter, r.jitter_N);
    tunnelled += r.tunnelled, unrested += r.unrested;
    forces.push_back(r.force_N);
  }
  std::sort(forces.begin(), forces.end());
  std::printf("| %d | %zu | %.3g | %.3g | %.3g | %zu | %zu | %.2g |\n", kStiffness, sound, overlap,
              forces[forces.size() / 2], force, tunnelled, unrested, jitter);
  std::fflush(stdout);
}

// The first tick of a motion that does not continue another: the list of pairs is made anew within it.
void timeLeaps(const bench::BodyTask& task) {
  const std::vector<PoseA> path = bench::pathOf(task, kTicks);
  const auto motion = SphereMotion::make(task.scene->spheres(), task.scene->spheres(), 16);
  if (!motion) {
    std::printf("| %s | %s |\n", task.name.c_str(), motion.problem().text().c_str());
    return;
  }
  ExactBody felt(task.scene, task.body);
  felt.respond({{task.home}});
  std::vector<double> us;
  for (std::size_t k = 0; k < path.size(); ++k) {
    const bool leap = k % 20 == 19;
    const auto begun = std::chrono::steady_clock::now();
    if (leap) {
      felt.setMotion(motion->get());
      felt.advanceTo(1.0 / 16.0);
    }
    felt.respond(path[k]);
    if (!leap) continue;
    us.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begun).count());
    felt.setMotion(nullptr);
  }
  const double loop_us = bench::distanceLoop_ns() / 1e3;
  std::sort(us.begin(), us.end());
  std::printf("| %s | %zu | %.0f | %.0f | %.0f | %.0f |\n", task.name.c_str(), us.size(), us[us.size() / 2], us.back(),
              us[us.size() / 2] / loop_us, us.back() / loop_us);
  std::fflush(stdout);
}

void sweepAllPoints() {
  std::printf(
      "| push / spring | sound of 10 | overlap (A) | force error, rms: median (N) | greatest (N) | tunnelled | not at "
      "rest | "
      "jitter (N) |\n| ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n");
  sweepPoints<3>(), sweepPoints<10>(), sweepPoints<30>(), sweepPoints<100>(), sweepPoints<300>(), sweepPoints<1000>();
}

}  // namespace

int main(int argc, char** argv) {
  const auto open = [](const std::string& id) {
    return readMolecule(std::string(MOLTACT_SOURCE_DIR "/molecules/") + id + ".pdb");
  };
  if (argc > 1 && argv[1] == std::string_view("points")) {
    sweepAllPoints();
    return 0;
  }
  std::vector<bench::BodyTask> tasks;
  for (const std::string_view name : bench::kBodyTasks) {
    if (argc > 1 && name != argv[1] && argv[1] != std::string_view("leaps")) continue;
    auto task = bench::bodyTask(name, open);
    if (!task) {
      std::fprintf(stderr, "%s\n", task.problem().text().c_str());
      return 2;
    }
    tasks.push_back(std::move(*task));
  }
  if (argc > 1 && argv[1] == std::string_view("leaps")) {
    std::printf(
        "| body | leaps | median us | max | median / loop | max / loop |\n| --- | --- | --- | --- | --- | --- |\n");
    for (const bench::BodyTask& task : tasks) timeLeaps(task);
    return 0;
  }
  std::printf(
      "| body | contact | at rest | steps | mean us | p50 | p99 | p99.9 | max | mean / loop | p99.9 / loop |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const bench::BodyTask& task : tasks) timeTicks(task);
  std::printf(
      "\n| body | dielectric | pairs in lists | mean us | p50 | p99.9 | mean / loop | p99.9 / loop |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const bench::BodyTask& task : tasks) {
    timePairs(task, Dielectric::Distance, "distance");
    timePairs(task, Dielectric::MehlerSolmajer, "Mehler-Solmajer");
  }
  if (argc < 2 || std::string_view(argv[1]) == "chains") {
    std::vector<bench::EnergyTask> fields;
    for (const std::string_view name : bench::kEnergyTasks) {
      auto task = bench::energyTask(name, open);
      if (!task) {
        std::fprintf(stderr, "%s\n", task.problem().text().c_str());
        return 2;
      }
      fields.push_back(*std::move(task));
    }
    fields.push_back(amongCopies(fields.back(), 498));
    std::printf(
        "\n| body | held | scene | dielectric | pairs in lists | mean us | p99.9 | mean / loop | p99.9 / loop |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (const bench::EnergyTask& task : fields) {
      timeField(task, Dielectric::Distance, "distance");
      timeField(task, Dielectric::MehlerSolmajer, "Mehler-Solmajer");
    }
  }
  std::printf("loop of 1000 sphere distances: %.2f us\n", bench::distanceLoop_ns() / 1e3);
}
