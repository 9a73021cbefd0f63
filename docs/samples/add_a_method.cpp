// Adds a method and measures its error against the reference: add_a_method FILE
// The method pushes the hand straight out of the one sphere that it is deepest in, without a memory. On a single atom
// that is exact; where spheres overlap, the point it finds may lie in the next one.
#include <cmath>
#include <cstdio>
#include <memory>

#include "engine/haptics/hip_input.h"
#include "engine/haptics/methods.h"
#include "engine/molecule/reader.h"

using namespace moltact;

struct DeepestSphere final : Tracker {
  std::shared_ptr<const SphereGrid> scene;
  double probe = kWaterProbe_A;
  Vec3 last{0.0};

  explicit DeepestSphere(std::shared_ptr<const SphereGrid> spheres) : scene(std::move(spheres)) {}
  Contact step(PointA hip) noexcept override {
    if (!usableHip(hip.A)) return refusedHip(hip, last);
    Contact out{.scp = hip};
    double deepest_A = 0.0;
    scene->visitNear(hip.A, probe, [&](std::uint32_t index, const Sphere& sphere) {
      const Vec3 away = hip.A - sphere.centre_A;
      const double distance_A = glm::length(away), depth_A = sphere.radius_A + probe - distance_A;
      if (depth_A <= deepest_A || distance_A == 0.0) return;
      deepest_A = depth_A;
      out.scp.A = hip.A + away / distance_A * depth_A;
      out.atoms[0] = std::int32_t(index), out.normals[0] = away / distance_A, out.feature = Feature::Sphere;
    });
    if (out.touching()) stretchToScp(out, hip);
    last = out.scp.A;
    return out;
  }
  void reset() noexcept override {}
  void setProbe(double probe_A) noexcept override { probe = usableProbe_A(probe_A, probe); }
  double probe_A() const noexcept override { return probe; }
  MemoryUsage memoryUsage() const noexcept override { return {.bytes = sizeof *this}; }
};

int main(int argc, char** argv) {
  const Expected<Molecule> molecule = readMolecule(argc > 1 ? argv[1] : "");
  if (!molecule) return std::fprintf(stderr, "%s\n", molecule.problem().text().c_str()), 1;
  const auto scene = std::make_shared<const SphereGrid>(molecule->spheres);
  DeepestSphere own(scene);
  const std::unique_ptr<Tracker> exact = referenceMethod().make(scene, kWaterProbe_A);
  double squares_A2 = 0.0, touching = 0.0;
  for (double x = -8.0; x <= 8.0; x += 0.01) {  // a stroke past the first atom, 2.5 A from its middle
    const PointA hip{scene->spheres()[0].centre_A + Vec3(x, 0.0, 2.5)};
    const Contact truth = exact->step(hip), mine = own.step(hip);
    if (truth.touching()) ++touching, squares_A2 += std::pow(glm::distance(truth.scp.A, mine.scp.A), 2.0);
  }
  std::printf("touching in %.0f ticks, error of the contact %.3f A rms\n", touching, std::sqrt(squares_A2 / touching));
}
