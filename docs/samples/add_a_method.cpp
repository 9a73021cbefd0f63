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

namespace {

class DeepestSphere final : public Tracker {
 public:
  DeepestSphere(std::shared_ptr<const SphereGrid> scene, double probe_A) : scene_(std::move(scene)), probe_(probe_A) {}

  Contact step(PointA hip) noexcept override {
    if (!usableHip(hip.A)) return refusedHip(hip, last_);
    Contact out{.scp = hip};
    double deepest_A = 0.0;
    scene_->visitNear(hip.A, probe_, [&](std::uint32_t index, const Sphere& sphere) {
      const Vec3 away = hip.A - sphere.centre_A;
      const double distance_A = glm::length(away), depth_A = sphere.radius_A + probe_ - distance_A;
      if (depth_A <= deepest_A || distance_A == 0.0) return;
      deepest_A = depth_A;
      out.scp.A = hip.A + away / distance_A * depth_A;
      out.atoms[0] = std::int32_t(index);
      out.normals[0] = away / distance_A;
      out.feature = Feature::Sphere;
    });
    if (out.touching()) stretchToScp(out, hip);
    last_ = out.scp.A;
    return out;
  }
  void reset() noexcept override {}
  void setProbe(double probe_A) noexcept override { probe_ = usableProbe_A(probe_A, probe_); }
  double probe_A() const noexcept override { return probe_; }
  MemoryUsage memoryUsage() const noexcept override { return {.bytes = sizeof *this}; }

 private:
  std::shared_ptr<const SphereGrid> scene_;
  double probe_;
  Vec3 last_{0.0};
};

}  // namespace

int main(int argc, char** argv) {
  const Expected<Molecule> molecule = readMolecule(argc > 1 ? argv[1] : "");
  if (!molecule) {
    std::fprintf(stderr, "%s\n", molecule.problem().text().c_str());
    return 1;
  }
  const auto scene = std::make_shared<const SphereGrid>(molecule->spheres);
  DeepestSphere own(scene, kWaterProbe_A);
  const std::unique_ptr<Tracker> exact = referenceMethod().make(scene, kWaterProbe_A);
  // A stroke along x past the first atom, 2.5 A from its middle.
  double squares_A2 = 0.0;
  int touching = 0;
  for (double x = -8.0; x <= 8.0; x += 0.01) {
    const PointA hip{scene->spheres()[0].centre_A + Vec3(x, 0.0, 2.5)};
    const Contact truth = exact->step(hip), mine = own.step(hip);
    if (!truth.touching()) continue;
    ++touching;
    squares_A2 += std::pow(glm::distance(truth.scp.A, mine.scp.A), 2.0);
  }
  std::printf("touching in %d ticks, error of the contact %.3f A rms\n", touching,
              touching ? std::sqrt(squares_A2 / touching) : 0.0);
}
