// TRR, the uncompressed trajectories of GROMACS in single or double precision, with or without velocities and forces.
// All numbers are big-endian.
#include <cmath>
#include <numeric>

#include "engine/language/catalogue.h"
#include "engine/molecule/reader.h"
#include "engine/trajectory/frame_formats.h"

namespace moltact {
namespace {

constexpr std::int32_t kTrrMagic = 1993;
constexpr std::size_t kTitle_bytes = 4 + 4 + 4 + 12;  // magic number, two lengths, "GMX_trn_file"

/// The sizes of a frame's parts (unit: byte), in their order in the file.
enum TrrPart {
  kRecord,
  kEnergies,
  kCell,
  kVirial,
  kPressure,
  kTopology,
  kSymbols,
  kPlaces,
  kVelocities,
  kForces,
  kParts
};

struct TrrHead {
  std::int64_t bytes[kParts] = {};
  std::int32_t atoms = 0;
  std::size_t real_bytes = 4;
  std::optional<double> time_ps;
  std::uint64_t size = 0;  // of the head
  std::uint64_t partBegins(int part) const {
    return size + static_cast<std::uint64_t>(std::accumulate(bytes, bytes + part, std::int64_t(0)));
  }
};

class Trr final : public FoundFrames {
 public:
  using FoundFrames::FoundFrames;
  std::string_view format() const override { return "TRR"; }
  std::optional<Problem> open() { return findFirst(); }
  Expected<TrajectoryFrame> read(std::size_t frame) override;

 protected:
  Expected<std::optional<Ending>> endOf(std::uint64_t at) override;

 private:
  static double real(const char* bytes, std::size_t size) {
    return size == 8 ? orderedNumber<double>(bytes, true) : double(orderedNumber<float>(bytes, true));
  }
  Expected<TrrHead> headAt(std::uint64_t at, std::size_t frame);
};

Expected<TrrHead> Trr::headAt(std::uint64_t at, std::size_t frame) {
  constexpr std::size_t kNumbers = 13;
  char bytes[kTitle_bytes + 4 * kNumbers + 16];
  if (!file_.read(at, bytes, kTitle_bytes + 4 * kNumbers)) return frameCutShort(file_.name(), frame);
  const auto integer = [&](std::size_t place) { return orderedNumber<std::int32_t>(bytes + place, true); };
  const auto damaged = [&] {
    return frame ? frameProblem(file_.name(), frame, tr("it is damaged")) : notOfFormat(file_.name(), format());
  };
  if (integer(0) != kTrrMagic || integer(4) != 13 || integer(8) != 12) return damaged();
  TrrHead out;
  for (std::size_t k = 0; k < kParts; ++k) {
    out.bytes[k] = integer(kTitle_bytes + 4 * k);
    if (out.bytes[k] < 0) return damaged();
  }
  out.atoms = integer(kTitle_bytes + 4 * kParts);
  if (out.atoms < 1 || std::size_t(out.atoms) > kMaxMoleculeAtoms) return damaged();
  // The precision follows from the size of what there is.
  const std::int64_t all = 3 * std::int64_t(out.atoms);
  for (const auto& [part, numbers] :
       {std::pair<int, std::int64_t>{kCell, 9}, {kPlaces, all}, {kVelocities, all}, {kForces, all}}) {
    if (out.bytes[part] == 0) continue;
    if (out.bytes[part] != 4 * numbers && out.bytes[part] != 8 * numbers) return damaged();
    out.real_bytes = static_cast<std::size_t>(out.bytes[part] / numbers);
  }
  if (!file_.read(at + kTitle_bytes + 4 * kNumbers, bytes, 2 * out.real_bytes))
    return frameCutShort(file_.name(), frame);
  if (const double time = real(bytes, out.real_bytes); std::isfinite(time)) out.time_ps = time;
  out.size = kTitle_bytes + 4 * kNumbers + 2 * out.real_bytes;
  return out;
}

Expected<std::optional<FoundFrames::Ending>> Trr::endOf(std::uint64_t at) {
  if (at == file_.size()) return std::optional<Ending>();
  Expected<TrrHead> head = headAt(at, frames_);
  if (!head) return head.problem();
  Ending out{at + head->partBegins(kParts), head->bytes[kPlaces] == 0};
  if (out.end > file_.size()) return frameCutShort(file_.name(), frames_);
  if (out.skipped) return std::optional<Ending>(out);
  if (atoms_ == 0) atoms_ = std::size_t(head->atoms);
  if (std::size_t(head->atoms) != atoms_)
    return frameProblem(file_.name(), frames_, trf("it has {0} atoms and not {1}", head->atoms, atoms_));
  return std::optional<Ending>(out);
}

Expected<TrajectoryFrame> Trr::read(std::size_t frame) {
  const std::uint64_t at = begins_[frame];
  Expected<TrrHead> head = headAt(at, frame);
  if (!head) return head.problem();
  const std::size_t size = head->real_bytes;
  std::vector<char> bytes(static_cast<std::size_t>(head->bytes[kPlaces]));
  if (bytes.size() != 3 * atoms_ * size || !file_.read(at + head->partBegins(kPlaces), bytes.data(), bytes.size()))
    return frameProblem(file_.name(), frame, tr("it is damaged"));
  TrajectoryFrame out;
  out.time_ps = head->time_ps;
  out.positions_A.resize(atoms_);
  for (std::size_t i = 0; i < atoms_; ++i)
    for (int k = 0; k < 3; ++k)
      out.positions_A[i][k] = real(bytes.data() + size * (3 * i + std::size_t(k)), size) * kAngstrom_per_nanometre;
  if (head->bytes[kCell] > 0) {
    char vectors[9 * 8];
    if (!file_.read(at + head->partBegins(kCell), vectors, 9 * size))
      return frameProblem(file_.name(), frame, tr("it is damaged"));
    glm::dmat3 cell(0.0);
    for (int k = 0; k < 9; ++k)
      cell[k / 3][k % 3] = real(vectors + size * std::size_t(k), size) * kAngstrom_per_nanometre;
    out.cell_A = cellOf(cell);
  }
  if (auto problem = checkPositions(file_.name(), frame, out.positions_A)) return *problem;
  return out;
}

}  // namespace

OpenedTrajectory openTrr(RandomAccessFile file) {
  auto out = std::make_unique<Trr>(std::move(file));
  if (auto problem = out->open()) return *problem;
  return std::unique_ptr<TrajectoryFile>(std::move(out));
}

}  // namespace moltact
