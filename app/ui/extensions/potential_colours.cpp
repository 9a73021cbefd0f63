#include "app/ui/extensions/potential_colours.h"

#include <chrono>
#include <utility>

#include "engine/haptics/field/compute_grid.h"
#include "engine/haptics/field/force_choices.h"
#include "engine/platform/background.h"

namespace moltact {
namespace {

using PotentialClock = std::chrono::steady_clock;
// Of a page's frame.
constexpr std::chrono::milliseconds kSliceOfFrame{4};

template <class Result>
bool potentialReady(const std::future<Result>& work) {
  return !work.valid() || work.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace

PotentialColours::~PotentialColours() {
  drop();
  for (const auto& job : dropped_)
    if (job->found.valid()) job->found.wait();
}

PotentialColours::Subject PotentialColours::subject() const {
  const TouchableModel& stage = scene_.stage();
  return {stage.molecule, scene_.touch().dielectric, stage.spheres->untouchable()};
}

std::optional<std::vector<float>> PotentialColours::run(Job& job) {
  SurfacePotential work(*job.of.molecule, dielectricChoice(job.of.dielectric), job.of.held);
  job.pieces = work.pieces();
  runGridWork(
      work.pieces(), 0,
      [&](std::size_t piece) {
        if (job.cancelled) return;
        work.compute(piece);
        ++job.done;
      },
      [&](double) { return !job.cancelled; });
  if (job.cancelled) return std::nullopt;
  return work.take();
}

void PotentialColours::begin(Subject of) {
  job_ = std::make_shared<Job>();
  job_->of = std::move(of);
  if (threadsAvailable()) {
    job_->found = inBackground([job = job_] { return run(*job); });
  } else {
    job_->work =
        std::make_unique<SurfacePotential>(*job_->of.molecule, dielectricChoice(job_->of.dielectric), job_->of.held);
    job_->pieces = job_->work->pieces();
  }
}

void PotentialColours::drop() {
  if (!job_) return;
  job_->cancelled = true;
  dropped_.push_back(std::move(job_));
  job_.reset();
}

// The result, when there is one.
std::optional<std::vector<float>> PotentialColours::advance() {
  Job& job = *job_;
  if (!job.work) return potentialReady(job.found) ? job.found.get() : std::nullopt;
  for (const auto end = PotentialClock::now() + kSliceOfFrame; job.done < job.pieces && PotentialClock::now() < end;
       ++job.done)
    job.work->compute(job.done);
  return job.done < job.pieces ? std::nullopt : std::optional(job.work->take());
}

void PotentialColours::beforeTicks() {
  std::erase_if(dropped_, [](const auto& job) { return potentialReady(job->found); });
  std::shared_ptr<const Colouring>& shown = scene_.look.atoms.colouring;
  if (!scene_.stage() || !shown || !shown->pending) {
    // What is known serves as long as its molecule is on the stage.
    if (known_.molecule && known_.molecule != scene_.stage().molecule) known_ = {}, colours_ = nullptr;
    return drop();
  }
  Subject now = subject();
  if (job_ && job_->of.isLike(now)) {
    if (const auto potential = advance()) {
      colours_ = std::make_shared<const Colouring>(potentialColouring(*potential));
      known_ = std::move(job_->of);
      job_.reset();
    }
  } else if (!(known_ == now)) {
    drop();
    begin(std::move(now));
    return;
  }
  if (!job_ && colours_) shown = colours_;
}

std::optional<float> PotentialColours::progress() const {
  if (!job_) return std::nullopt;
  const std::size_t pieces = job_->pieces;
  return pieces ? float(job_->done) / float(pieces) : 0.0f;
}

}  // namespace moltact
