#include "engine/trajectory/frame_store.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/structure/superposition.h"
#include "engine/trajectory/leap_guard.h"

namespace moltact {
namespace {

double leapLimitOf(const TrajectoryFrame& frame) {
  if (!frame.cell_A) return 0.0;
  const glm::dmat3& cell = *frame.cell_A;
  return 0.5 * std::min({glm::length(cell[0]), glm::length(cell[1]), glm::length(cell[2])});
}

}  // namespace

Expected<std::unique_ptr<FrameStore>> FrameStore::open(const std::filesystem::path& path,
                                                       std::shared_ptr<const Molecule> molecule, const FrameFit& fit) {
  auto file = openTrajectory(path);
  if (!file) return file.problem();
  auto placer = FramePlacer::make(std::move(molecule), (*file)->atoms(), path.string(), fit);
  if (!placer) return placer.problem();
  return std::make_unique<FrameStore>(*std::move(file), *std::move(placer));
}

Expected<AtomPositions> FrameStore::placed(std::size_t frame) {
  if (const auto found = kept_.find(frame); found != kept_.end()) return found->second.positions;
  auto read = file_->read(frame);
  if (!read) return read.problem();
  AtomPositions out = std::make_shared<const std::vector<Vec3>>(placer_.place(*read));
  const std::size_t each = out->size() * sizeof(Vec3),
                    most = std::max(kMinFrames, kMaxStored_bytes / std::max<std::size_t>(each, 1));
  while (order_.size() >= most) {
    kept_.erase(order_.front());
    order_.pop_front();
  }
  last_limit_A_ = leapLimitOf(*read);
  kept_.emplace(frame, Kept{out, read->time_ps, last_limit_A_});
  order_.push_back(frame);
  return out;
}

std::optional<double> FrameStore::time_ps(std::size_t frame) const {
  const auto found = kept_.find(frame);
  return found == kept_.end() ? std::nullopt : found->second.time_ps;
}

double FrameStore::leapLimit_A(std::size_t frame) const {
  const auto found = kept_.find(frame);
  return found == kept_.end() ? last_limit_A_ : found->second.leap_limit_A;
}

Expected<AtomPositions> FrameStore::at(std::size_t frame, std::size_t smoothing) {
  if (smoothing == 0) return placed(frame);
  // As many frames before as after, so that the mean is that of this moment.
  const std::size_t reach = std::min({smoothing, frame, file_->frames() - 1 - frame});
  const auto middle = placed(frame);
  if (!middle) return middle.problem();
  const double limit_A = leapLimit_A(frame);
  std::vector<Vec3> sum = **middle;
  std::vector<double> count(sum.size(), 1.0);
  for (std::size_t k = frame - reach; k <= frame + reach; ++k) {
    if (k == frame) continue;
    auto one = placed(k);
    if (!one) return one.problem();
    const std::vector<bool> leaps = leapsBetween(**middle, **one, placer_.partOf(), placer_.parts(), limit_A);
    for (std::size_t i = 0; i < sum.size(); ++i) {
      if (leaps[placer_.partOf()[i]]) continue;
      sum[i] += (**one)[i];
      ++count[i];
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] /= count[i];
  return AtomPositions(std::make_shared<const std::vector<Vec3>>(std::move(sum)));
}

std::vector<Vec3> between(std::span<const Vec3> from, std::span<const Vec3> to, double share) {
  std::vector<Vec3> out(from.begin(), from.end());
  if (share != 0.0)
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += (to[i] - out[i]) * share;
  return out;
}

Expected<TrajectorySurvey> surveyTrajectory(FrameStore& frames, std::size_t first, std::size_t last, std::size_t most) {
  TrajectorySurvey out;
  last = std::min(last, frames.file().frames());
  if (first >= last || most == 0) return out;
  out.every = (last - first + most - 1) / most;
  const Molecule& molecule = frames.placer().molecule();
  const std::size_t n = molecule.atoms.size();
  const std::vector<std::uint32_t> leading = leadingAtoms(molecule);
  std::vector<Vec3> sum(n, Vec3(0.0));
  std::vector<double> squares(n, 0.0);
  std::size_t count = 0;
  for (std::size_t frame = first; frame < last; frame += out.every, ++count) {
    auto read = frames.file().read(frame);
    if (!read) return read.problem();
    const std::vector<Vec3> places = frames.placer().place(*read);
    double squared = 0.0;
    for (const std::uint32_t i : leading) {
      const Vec3 d = places[i] - molecule.spheres[i].centre_A;
      squared += glm::dot(d, d);
    }
    out.rmsd_A.push_back(float(std::sqrt(squared / double(leading.size()))));
    for (std::size_t i = 0; i < n; ++i) {
      // From the structure, which keeps the squares small.
      const Vec3 d = places[i] - molecule.spheres[i].centre_A;
      sum[i] += d;
      squares[i] += glm::dot(d, d);
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 mean = sum[i] / double(count);
    out.fluctuation_A.push_back(float(std::sqrt(std::max(0.0, squares[i] / double(count) - glm::dot(mean, mean)))));
  }
  return out;
}

}  // namespace moltact
