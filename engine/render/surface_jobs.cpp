#include "engine/render/surface_jobs.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "engine/platform/background.h"
#include "engine/render/style_shapes.h"
#include "engine/render/styled_part.h"

namespace moltact {

SurfaceJobs::~SurfaceJobs() {
  for (auto* jobs : {&jobs_, &given_up_})
    for (Job& job : *jobs) job.progress->cancelled.store(true);
}

bool SurfaceJobs::Job::isDone() const { return work.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }

bool SurfaceJobs::Job::isLike(const StyledAtoms& other, const ViewScene& scene) const {
  return other.style == what.style && other.atoms == what.atoms && scene.look.hidden == hidden &&
         scene.max_single_atoms == max_single_atoms && scene.probe_A == probe_A &&
         scene.molecule->atoms.size() == molecule->atoms.size() && scene.molecule->id == molecule->id;
}

void SurfaceJobs::begin(const StyledAtoms& what, const ViewScene& scene, const MoleculeModel& model) {
  Job job{what,
          scene.look.hidden,
          scene.molecule,
          scene.max_single_atoms,
          scene.probe_A,
          true,
          std::make_shared<SurfaceProgress>(),
          {}};
  job.work = inBackground([progress = job.progress, molecule = scene.molecule, probe_A = scene.probe_A,
                           shown = StyledPart::shownOf(what, scene.look.hidden, model)] {
    return surfaceOf(*molecule, shown, probe_A, progress.get());
  });
  jobs_.push_back(std::move(job));
}

std::optional<SurfaceJobs::Made> SurfaceJobs::take(const StyledAtoms& what, const ViewScene& scene,
                                                   const MoleculeModel& model) {
  auto job = std::find_if(jobs_.begin(), jobs_.end(), [&](const Job& j) { return j.isLike(what, scene); });
  if (job == jobs_.end()) {
    begin(what, scene, model);
    job = jobs_.end() - 1;
  }
  job->wanted = true;
  if (!job->isDone()) return std::nullopt;
  Made made{job->molecule, job->probe_A, job->work.get()};
  jobs_.erase(job);
  if (made.molecule != scene.molecule) begin(what, scene, model);
  return made;
}

void SurfaceJobs::beginPicture() {
  for (Job& job : jobs_) job.wanted = false;
}

void SurfaceJobs::endPicture() {
  std::erase_if(given_up_, [](const Job& job) { return job.isDone(); });
  for (Job& job : jobs_)
    if (!job.wanted) {
      job.progress->cancelled.store(true);
      given_up_.push_back(std::move(job));
    }
  std::erase_if(jobs_, [](const Job& job) { return !job.work.valid(); });
}

bool SurfaceJobs::ready() const {
  return std::any_of(jobs_.begin(), jobs_.end(), [](const Job& job) { return job.isDone(); });
}

std::optional<float> SurfaceJobs::progress() const {
  std::optional<float> smallest;
  for (const Job& job : jobs_) smallest = std::min(smallest.value_or(1.0f), job.progress->share.load());
  return smallest;
}

}  // namespace moltact
