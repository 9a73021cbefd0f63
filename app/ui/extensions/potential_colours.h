// Computes the colouring `potential` of the scene on a thread of its own and gives it to the scene when it is done. Until
// then the atoms are grey. Another molecule, medium or colouring cancels it. In a page, which has no threads, a few
// milliseconds of it are computed in each frame. Window's thread. Unit: kcal/mol.
#pragma once

#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/application/extension.h"
#include "engine/structure/colouring.h"
#include "engine/structure/surface_potential.h"

namespace moltact {

class PotentialColours final : public Extension {
 public:
  explicit PotentialColours(HapticSession& scene) : scene_(scene) {}
  /// Cancels the work and waits for what is not interrupted: a piece, some milliseconds, or the charges, 0.3 s for 100 000
  /// atoms (build/release/potential_benchmark).
  ~PotentialColours() override;

  void beforeTicks() override;
  bool live() const override { return job_ != nullptr; }
  /// The computed share, 0 to 1; empty while nothing is computed.
  std::optional<float> progress() const;

 private:
  // What the potential depends on.
  struct Subject {
    std::shared_ptr<const Molecule> molecule;
    std::string dielectric;
    std::vector<std::uint32_t> held;
    friend bool operator==(const Subject&, const Subject&) = default;
    /// True if both differ at most in the positions of the atoms, which may move while the job runs.
    bool isLike(const Subject& other) const {
      return dielectric == other.dielectric && held == other.held && molecule->sameTopology(*other.molecule);
    }
  };
  struct Job {
    Subject of;
    std::atomic<bool> cancelled{false};
    std::atomic<std::size_t> done{0}, pieces{0};
    std::unique_ptr<SurfacePotential> work;  // in a page; else the thread's own
    std::future<std::optional<std::vector<float>>> found;
  };
  Subject subject() const;
  void begin(Subject of);
  void drop();
  std::optional<std::vector<float>> advance();
  static std::optional<std::vector<float>> run(Job& job);

  HapticSession& scene_;
  std::shared_ptr<Job> job_;
  std::vector<std::shared_ptr<Job>> dropped_;  // kept until they end, so that the window does not wait
  Subject known_;                              // of colours_
  std::shared_ptr<const Colouring> colours_;
};

}  // namespace moltact
