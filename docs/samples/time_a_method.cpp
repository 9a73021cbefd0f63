// Times every method, or those that are named, sliding over a molecule: time_a_method FILE [METHOD…]
// The path runs round the middle of the molecule on a circle, 1 A below the surface that the first lap finds.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "engine/haptics/methods.h"
#include "engine/molecule/reader.h"

using namespace moltact;

namespace {

constexpr int kTicks = 20'000, kLaps = 10;

// The probe's contacts on rays to the middle, moved 1 A inward.
std::vector<Vec3> pathUnderSurface(const std::shared_ptr<const SphereGrid>& scene) {
  const Vec3 middle = 0.5 * (scene->low_A() + scene->high_A());
  const double far_A = 0.5 * glm::length(scene->high_A() - scene->low_A()) + 2.0 * kWaterProbe_A;
  const auto probe = referenceMethod().make(scene, kWaterProbe_A);
  std::vector<Vec3> path;
  for (int k = 0; k < kTicks; ++k) {
    const double angle = kTwoPi * k / kTicks;
    const Vec3 out(std::cos(angle), std::sin(angle), 0.0);
    probe->reset();
    probe->step({middle + far_A * out});
    path.push_back(probe->step({middle}).scp.A - out);
  }
  return path;
}

}  // namespace

int main(int argc, char** argv) {
  const Expected<Molecule> molecule = readMolecule(argc > 1 ? argv[1] : "");
  if (!molecule) {
    std::fprintf(stderr, "%s\n", molecule.problem().text().c_str());
    return 1;
  }
  const auto scene = std::make_shared<const SphereGrid>(molecule->spheres);
  const std::vector<Vec3> path = pathUnderSurface(scene);
  std::vector<std::string_view> names(argv + 2, argv + argc);
  for (const std::string_view name : names.empty() ? methodNames() : names) {
    const Method* method = findMethod(name);
    if (!method) {
      std::fprintf(stderr, "there is no method \"%s\"\n", std::string(name).c_str());
      return 1;
    }
    const std::unique_ptr<Tracker> tracker = method->make(scene, kWaterProbe_A);
    tracker->step({2.0 * scene->high_A() - scene->low_A() + Vec3(10.0)});  // the force begins after a tick outside
    long touching = 0;
    const auto start = std::chrono::steady_clock::now();
    for (int lap = 0; lap < kLaps; ++lap)
      for (const Vec3& hip_A : path) touching += tracker->step({hip_A}).touching();
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
    const double ticks = double(kLaps) * kTicks;
    std::printf("%-15s %8.1f ns per tick, touching in %.1f %% of ticks\n", std::string(name).c_str(),
                time.count() / ticks, 100.0 * double(touching) / ticks);
  }
}
