// DCD, the trajectories of CHARMM, NAMD and OpenMM: unformatted Fortran records, each between two copies of its length, of
// either byte order. All frames have the same size, except that the first one alone holds fixed atoms.
#include <algorithm>
#include <cmath>

#include "engine/language/catalogue.h"
#include "engine/molecule/reader.h"
#include "engine/trajectory/frame_formats.h"

namespace moltact {
namespace {

constexpr std::uint32_t kDcdHeader_bytes = 84;
constexpr double kAkmaTime_ps = 0.04888821;  // CHARMM's unit of time

class Dcd final : public TrajectoryFile {
 public:
  explicit Dcd(RandomAccessFile file) : file_(std::move(file)) {}
  std::string_view format() const override { return "DCD"; }
  void findMore(std::uint64_t) override {}
  std::optional<Problem> open();
  Expected<TrajectoryFrame> read(std::size_t frame) override;

 private:
  // Reads a record at `at` of at most `most` bytes, and moves `at` behind it.
  bool record(std::uint64_t& at, std::vector<char>& out, std::uint64_t most);
  template <class Number>
  Number number(const char* bytes) const {
    return orderedNumber<Number>(bytes, big_endian_);
  }
  Problem damaged() const { return notOfFormat(file_.name(), format()); }
  std::uint64_t frameBytes(std::size_t moving_atoms) const {
    return (has_cell_ ? 48 + 8 : 0) + (has_fourth_ ? 4 : 3) * (4 * std::uint64_t(moving_atoms) + 8);
  }
  std::optional<Problem> readFrame(std::size_t frame, TrajectoryFrame& out);

  RandomAccessFile file_;
  bool big_endian_ = false, has_cell_ = false, has_fourth_ = false;
  std::uint64_t first_ = 0;          // the place of the first frame
  std::vector<std::uint32_t> free_;  // the atoms that move; empty: all
  std::vector<Vec3> fixed_A_;        // the positions of the first frame, where some atoms are fixed
  double first_ps_ = 0.0, step_ps_ = 0.0;
};

bool Dcd::record(std::uint64_t& at, std::vector<char>& out, std::uint64_t most) {
  char length[4];
  if (!file_.read(at, length, 4)) return false;
  const std::uint64_t n = number<std::uint32_t>(length);
  if (n > most || at + n + 8 > file_.size()) return false;
  out.resize(n);
  if (n > 0 && !file_.read(at + 4, out.data(), n)) return false;
  if (!file_.read(at + 4 + n, length, 4) || number<std::uint32_t>(length) != n) return false;
  at += n + 8;
  return true;
}

std::optional<Problem> Dcd::open() {
  char length[4];
  if (!file_.read(0, length, 4)) return damaged();
  big_endian_ = orderedNumber<std::uint32_t>(length, true) == kDcdHeader_bytes;
  std::uint64_t at = 0;
  std::vector<char> bytes;
  if (!record(at, bytes, kDcdHeader_bytes) || bytes.size() != kDcdHeader_bytes ||
      std::string_view(bytes.data(), 4) != "CORD")
    return damaged();
  const auto entry = [&](int k) { return number<std::int32_t>(bytes.data() + 4 + 4 * k); };
  const std::int32_t claimed = entry(0), start = entry(1), stride = entry(2), fixed = entry(8);
  const bool charmm = entry(19) != 0;
  has_cell_ = charmm && entry(10) != 0;
  has_fourth_ = charmm && entry(11) != 0;
  // X-PLOR writes the time step as a double.
  const double step = charmm ? double(number<float>(bytes.data() + 4 + 36)) : number<double>(bytes.data() + 4 + 36);
  if (std::isfinite(step) && step > 0.0 && stride > 0) {
    step_ps_ = kAkmaTime_ps * step * stride;
    first_ps_ = kAkmaTime_ps * step * start;
  }
  if (!record(at, bytes, 1u << 20)) return damaged();  // the title
  if (!record(at, bytes, 4) || bytes.size() != 4) return damaged();
  const std::int32_t atoms = number<std::int32_t>(bytes.data());
  if (atoms < 1 || std::size_t(atoms) > kMaxMoleculeAtoms || fixed < 0 || fixed >= atoms) return damaged();
  atoms_ = std::size_t(atoms);
  if (fixed > 0) {
    const std::size_t moving = atoms_ - std::size_t(fixed);
    if (!record(at, bytes, 4 * moving) || bytes.size() != 4 * moving) return damaged();
    for (std::size_t k = 0; k < moving; ++k) {
      const std::int32_t index = number<std::int32_t>(bytes.data() + 4 * k);
      if (index < 1 || std::size_t(index) > atoms_) return damaged();
      free_.push_back(static_cast<std::uint32_t>(index - 1));
    }
  }
  first_ = at;
  const std::uint64_t rest = file_.size() - std::min(first_, file_.size()), whole = frameBytes(atoms_),
                      later = frameBytes(free_.empty() ? atoms_ : free_.size());
  // A program that is stopped leaves a wrong number in the header: the size of the file counts.
  frames_ = rest < whole ? 0 : static_cast<std::size_t>(1 + (rest - whole) / later);
  complete_ = true;
  if (frames_ == 0) return frameCutShort(file_.name(), 0);
  if ((rest - whole) % later != 0)
    warnings_.push_back(tr("The last frame is cut short and left out."));
  else if (claimed > 0 && std::size_t(claimed) != frames_)
    warnings_.push_back(trf("The header states {0} frames; the file has {1}.", claimed, frames_));
  if (!free_.empty()) {
    TrajectoryFrame first;
    if (auto problem = readFrame(0, first)) return problem;
    fixed_A_ = std::move(first.positions_A);
  }
  return std::nullopt;
}

std::optional<Problem> Dcd::readFrame(std::size_t frame, TrajectoryFrame& out) {
  const bool some_fixed = frame > 0 && !free_.empty();
  const std::size_t count = some_fixed ? free_.size() : atoms_;
  std::uint64_t at = first_;
  if (frame > 0) at += frameBytes(atoms_) + (frame - 1) * frameBytes(free_.empty() ? atoms_ : free_.size());
  std::vector<char> bytes;
  const auto damagedFrame = [&] { return frameProblem(file_.name(), frame, tr("it is damaged")); };
  if (has_cell_) {
    if (!record(at, bytes, 48) || bytes.size() != 48) return damagedFrame();
    const auto entry = [&](int k) { return number<double>(bytes.data() + 8 * k); };
    // A, gamma, B, beta, alpha, C; the angles in degrees, or their cosines.
    Vec3 edges(entry(0), entry(2), entry(5)), angles(entry(4), entry(3), entry(1));
    for (int k = 0; k < 3; ++k)
      if (std::abs(angles[k]) <= 1.0) angles[k] = glm::degrees(std::acos(angles[k]));
    out.cell_A = cellOf(edges, angles);
  }
  out.positions_A = some_fixed ? fixed_A_ : std::vector<Vec3>(atoms_);
  for (int axis = 0; axis < 3; ++axis) {
    if (!record(at, bytes, 4 * count) || bytes.size() != 4 * count) return damagedFrame();
    for (std::size_t k = 0; k < count; ++k)
      out.positions_A[some_fixed ? free_[k] : k][axis] = double(number<float>(bytes.data() + 4 * k));
  }
  if (step_ps_ > 0.0) out.time_ps = first_ps_ + step_ps_ * double(frame);
  return checkPositions(file_.name(), frame, out.positions_A);
}

Expected<TrajectoryFrame> Dcd::read(std::size_t frame) {
  TrajectoryFrame out;
  if (auto problem = readFrame(frame, out)) return *problem;
  return out;
}

}  // namespace

OpenedTrajectory openDcd(RandomAccessFile file) {
  auto out = std::make_unique<Dcd>(std::move(file));
  if (auto problem = out->open()) return *problem;
  return std::unique_ptr<TrajectoryFile>(std::move(out));
}

}  // namespace moltact
