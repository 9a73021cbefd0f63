// Computes molecular surfaces in the background for MoleculeLayer, one per style that draws one. Window's thread.
#pragma once

#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "engine/render/molecule_model.h"
#include "engine/render/solvent_excluded.h"
#include "engine/render/view_scene.h"

namespace moltact {

class SurfaceJobs {
 public:
  SurfaceJobs() = default;
  /// Cancels the running work, which takes some milliseconds.
  ~SurfaceJobs();
  SurfaceJobs(const SurfaceJobs&) = delete;
  SurfaceJobs& operator=(const SurfaceJobs&) = delete;

  struct Made {
    std::shared_ptr<const Molecule> molecule;  ///< the scene's, or an earlier one if its atoms have moved meanwhile
    double probe_A = 0.0;
    SolventExcluded surface;
  };
  /// Returns the surface for the scene; empty while it is being computed. While atoms move, each surface is completed
  /// before the next is started.
  std::optional<Made> take(const StyledAtoms& what, const ViewScene& scene, const MoleculeModel& model);

  /// Starts a picture. A surface that take() does not request until endPicture() is abandoned.
  void beginPicture();
  void endPicture();

  /// True if take() would return a new surface.
  bool ready() const;
  /// The progress of the slowest surface, 0 to 1; empty if none is being computed.
  std::optional<float> progress() const;

 private:
  struct Job {
    StyledAtoms what;
    AtomList hidden;
    std::shared_ptr<const Molecule> molecule;
    std::size_t max_single_atoms = 0;
    double probe_A = 0.0;
    bool wanted = true;
    std::shared_ptr<SurfaceProgress> progress;
    std::future<SolventExcluded> work;

    bool isDone() const;
    /// True if both differ at most in the positions of the atoms.
    bool isLike(const StyledAtoms& what, const ViewScene& scene) const;
  };
  void begin(const StyledAtoms& what, const ViewScene& scene, const MoleculeModel& model);

  std::vector<Job> jobs_, given_up_;  // abandoned jobs are kept until they end, so that the window does not wait
};

}  // namespace moltact
