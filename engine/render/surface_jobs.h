// Surfaces that are computed beside the window's thread, for MoleculeLayer: one for each style that draws one. Window's
// thread.
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
  /// Ends what is under way, which takes some milliseconds.
  ~SurfaceJobs();
  SurfaceJobs(const SurfaceJobs&) = delete;
  SurfaceJobs& operator=(const SurfaceJobs&) = delete;

  struct Made {
    std::shared_ptr<const Molecule> molecule;  ///< the scene's, or where its atoms have moved meanwhile the former one
    double probe_A = 0.0;
    SolventExcluded surface;
  };
  /// The surface that the scene wants; none while it is computed. While atoms move, each surface is finished before the
  /// next is begun.
  std::optional<Made> take(const StyledAtoms& what, const ViewScene& scene, const MoleculeModel& model);

  /// Begins a picture: what take() is not asked for until endPicture() is given up.
  void beginPicture();
  void endPicture();

  /// Whether take() has something new to give.
  bool ready() const;
  /// How far the one is that needs longest, 0 to 1; no value where none is computed.
  std::optional<float> progress() const;

 private:
  struct Job {
    StyledAtoms what;
    AtomList hidden;
    std::shared_ptr<const Molecule> molecule;
    std::size_t most_single_atoms = 0;
    double probe_A = 0.0;
    bool wanted = true;
    std::shared_ptr<SurfaceProgress> progress;
    std::future<SolventExcluded> work;

    bool isDone() const;
    /// The same but for the places of the atoms.
    bool isLike(const StyledAtoms& what, const ViewScene& scene) const;
  };
  void begin(const StyledAtoms& what, const ViewScene& scene, const MoleculeModel& model);

  std::vector<Job> jobs_, given_up_;  // the window does not wait for those either
};

}  // namespace moltact
