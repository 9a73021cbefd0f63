// XTC, the compressed trajectories of GROMACS: coordinates in nanometres are rounded to a multiple of 1/precision, and
// the differences of neighbours are packed into as few bits as they need. All numbers are big-endian.
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/language/catalogue.h"
#include "engine/molecule/reader.h"
#include "engine/trajectory/frame_formats.h"

namespace moltact {
namespace {

constexpr std::int32_t kMagic = 1995, kMagicLarge = 2023;  // the second has lengths of 64 bits
constexpr std::uint32_t kFewAtoms = 9;                     // up to here the coordinates are plain floats
constexpr std::size_t kXtcHeader_bytes = 56;               // up to the second number of atoms

// The edges of cubes for differences. Entry n is about the cube root of 2^n: a difference takes n bits.
constexpr int kFirstSize = 9;
constexpr std::array<std::uint32_t, 73> kSizes{
    0,       0,       0,       0,       0,        0,        0,       0,       0,       8,       10,
    12,      16,      20,      25,      32,       40,       50,      64,      80,      101,     128,
    161,     203,     256,     322,     406,      512,      645,     812,     1024,    1290,    1625,
    2048,    2580,    3250,    4096,    5060,     6501,     8192,    10321,   13003,   16384,   20642,
    26007,   32768,   41285,   52015,   65536,    82570,    104031,  131072,  165140,  208063,  262144,
    330280,  416127,  524287,  660561,  832255,   1048576,  1321122, 1664510, 2097152, 2642245, 3329021,
    4194304, 5284491, 6658042, 8388607, 10568983, 13316085, 16777216};

/// The number of bits of a number.
int bitsOf(std::uint64_t value) { return static_cast<int>(std::bit_width(value)); }

using Triple = std::array<std::uint32_t, 3>;

/// The number of bits for three numbers below these sizes (each at most 2^24), packed as one.
int bitsOf(const Triple& sizes) {
  const std::uint64_t two = std::uint64_t(sizes[0]) * sizes[1];
  const std::uint64_t low = (two & 0xffffffffu) * sizes[2], high = (two >> 32) * sizes[2] + (low >> 32);
  return high ? 32 + bitsOf(high) : bitsOf(low & 0xffffffffu);
}

/// Bits of a frame, the most significant of each byte first. Beyond the end, zeros are read and `overrun` is set.
class Bits {
 public:
  explicit Bits(std::span<const char> bytes) : bytes_(bytes) {}
  bool overrun = false;

  /// Up to 32 bits.
  std::uint32_t take(int count) {
    while (have_ < count) {
      std::uint64_t byte = 0;
      if (at_ < bytes_.size())
        byte = static_cast<unsigned char>(bytes_[at_++]);
      else
        overrun = true;
      held_ = held_ << 8 | byte;
      have_ += 8;
    }
    have_ -= count;
    return static_cast<std::uint32_t>(held_ >> have_ & ((std::uint64_t(1) << count) - 1));
  }

  /// Three numbers below these sizes that were packed as one of `width` bits, its bytes in reverse order.
  Triple takeThree(int width, const Triple& sizes) {
    Triple out{};
    if (width <= 64) {
      std::uint64_t value = 0;
      int shift = 0;
      for (; width >= 8; width -= 8, shift += 8) value |= std::uint64_t(take(8)) << shift;
      if (width > 0) value |= std::uint64_t(take(width)) << shift;
      out[2] = static_cast<std::uint32_t>(value % sizes[2]);
      value /= sizes[2];
      out[1] = static_cast<std::uint32_t>(value % sizes[1]);
      out[0] = static_cast<std::uint32_t>(value / sizes[1]);
      return out;
    }
    std::array<std::uint32_t, 12> digits{};
    int count = 0;
    for (; width >= 8; width -= 8) digits[std::size_t(count++)] = take(8);
    if (width > 0) digits[std::size_t(count++)] = take(width);
    for (std::size_t axis = 2; axis > 0; --axis) {
      std::uint64_t rest = 0;
      for (int k = count; k-- > 0;) {
        rest = rest << 8 | digits[std::size_t(k)];
        digits[std::size_t(k)] = static_cast<std::uint32_t>(rest / sizes[axis]);
        rest %= sizes[axis];
      }
      out[axis] = static_cast<std::uint32_t>(rest);
    }
    out[0] = digits[0] | digits[1] << 8 | digits[2] << 16 | digits[3] << 24;
    return out;
  }

 private:
  std::span<const char> bytes_;
  std::size_t at_ = 0;
  std::uint64_t held_ = 0;
  int have_ = 0;
};

/// What precedes the packed bits.
struct Packing {
  float precision = 0.0f;
  std::array<std::int32_t, 3> low{}, high{};
  std::int32_t size = 0;  // index into kSizes
};

/// Unpacks `out.size()` atoms, in nanometres. Returns false if the bits are none of the format.
bool unpack(const Packing& from, std::span<const char> bytes, std::span<glm::vec3> out) {
  if (!(from.precision > 0.0f) || from.size < kFirstSize || from.size >= int(kSizes.size())) return false;
  Triple sizes{};
  bool large = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int64_t range = std::int64_t(from.high[k]) - from.low[k] + 1;
    if (range < 1 || range > 0xffffffffll) return false;
    sizes[k] = static_cast<std::uint32_t>(range);
    large = large || range > 0xffffff;
  }
  const int width = large ? 0 : bitsOf(sizes);
  const float unit = 1.0f / from.precision;
  int size = from.size;
  std::int64_t small = kSizes[std::size_t(size)] / 2, smaller = kSizes[std::size_t(std::max(kFirstSize, size - 1))] / 2;
  Bits bits(bytes);
  using Place = std::array<std::int64_t, 3>;
  std::size_t written = 0;
  const auto write = [&](const Place& place) {
    for (int k = 0; k < 3; ++k) out[written][k] = static_cast<float>(place[std::size_t(k)]) * unit;
    ++written;
  };
  int run = 0;
  while (written < out.size()) {
    Triple packed{};
    if (large)
      for (std::size_t k = 0; k < 3; ++k) packed[k] = bits.take(bitsOf(sizes[k]));
    else
      packed = bits.takeThree(width, sizes);
    Place place{};
    for (std::size_t k = 0; k < 3; ++k) place[k] = std::int64_t(packed[k]) + from.low[k];
    int change = 0;
    // Without the flag, the run is as long as the last one.
    if (bits.take(1)) {
      const int both = static_cast<int>(bits.take(5));
      change = both % 3 - 1;
      run = both / 3;
    }
    if (bits.overrun || written + std::size_t(run) + 1 > out.size()) return false;
    const std::uint32_t cube = kSizes[std::size_t(size)];
    const Triple cubes{cube, cube, cube};
    Place before = place;
    for (int k = 0; k < run; ++k) {
      const Triple difference = bits.takeThree(size, cubes);
      Place next{};
      for (std::size_t axis = 0; axis < 3; ++axis) next[axis] = std::int64_t(difference[axis]) + before[axis] - small;
      write(next);
      // The first two are interchanged: this packs the oxygen of water between its hydrogens.
      if (k == 0) write(place);
      before = next;
    }
    if (run == 0) write(place);
    size += change;
    if (size < kFirstSize || size >= int(kSizes.size())) return false;
    if (change < 0) {
      small = smaller;
      smaller = size > kFirstSize ? kSizes[std::size_t(size - 1)] / 2 : 0;
    } else if (change > 0) {
      smaller = small;
      small = kSizes[std::size_t(size)] / 2;
    }
    if (bits.overrun) return false;
  }
  return true;
}

class Xtc final : public FoundFrames {
 public:
  using FoundFrames::FoundFrames;
  std::string_view format() const override { return "XTC"; }
  std::optional<Problem> open() { return findFirst(); }
  Expected<TrajectoryFrame> read(std::size_t frame) override;

 protected:
  Expected<std::optional<Ending>> endOf(std::uint64_t at) override;

 private:
  static std::int32_t integer(const char* bytes) { return orderedNumber<std::int32_t>(bytes, true); }
  static float real(const char* bytes) { return orderedNumber<float>(bytes, true); }
};

// Between the numbers of atoms and the packed bits: precision, bounds, size and the number of bytes.
constexpr std::size_t kPacking_bytes = 4 + 12 + 12 + 4;

Expected<std::optional<FoundFrames::Ending>> Xtc::endOf(std::uint64_t at) {
  char head[kXtcHeader_bytes + kPacking_bytes + 8];
  if (at == file_.size()) return std::optional<Ending>();
  if (!file_.read(at, head, kXtcHeader_bytes)) return frameCutShort(file_.name(), frames_);
  const std::int32_t magic = integer(head), atoms = integer(head + 4);
  if ((magic != kMagic && magic != kMagicLarge) || atoms < 1 || std::size_t(atoms) > kMaxMoleculeAtoms ||
      integer(head + 52) != atoms)
    return frames_ ? frameProblem(file_.name(), frames_, tr("it is damaged")) : notOfFormat(file_.name(), format());
  if (atoms_ == 0) atoms_ = std::size_t(atoms);
  if (std::size_t(atoms) != atoms_)
    return frameProblem(file_.name(), frames_, trf("it has {0} atoms and not {1}", atoms, atoms_));
  Ending out;
  out.end = at + kXtcHeader_bytes;
  if (std::uint32_t(atoms) <= kFewAtoms) {
    out.end += 12 * std::uint64_t(atoms);
  } else {
    const std::size_t length = magic == kMagicLarge ? 8 : 4;
    if (!file_.read(at + kXtcHeader_bytes, head, kPacking_bytes + length)) return frameCutShort(file_.name(), frames_);
    const std::int64_t bytes = length == 8 ? orderedNumber<std::int64_t>(head + kPacking_bytes, true)
                                           : std::int64_t(integer(head + kPacking_bytes));
    // An atom takes more than eight bits in the longest runs, which bounds the memory for a damaged number of atoms.
    if (bytes < atoms || bytes > (std::int64_t(1) << 40))
      return frameProblem(file_.name(), frames_, tr("it is damaged"));
    out.end += kPacking_bytes + length + std::uint64_t((bytes + 3) / 4 * 4);
  }
  if (out.end > file_.size()) return frameCutShort(file_.name(), frames_);
  return std::optional<Ending>(out);
}

Expected<TrajectoryFrame> Xtc::read(std::size_t frame) {
  const std::uint64_t at = begins_[frame];
  const auto damaged = [&] { return frameProblem(file_.name(), frame, tr("it is damaged")); };
  char head[kXtcHeader_bytes];
  if (!file_.read(at, head, sizeof head)) return damaged();
  TrajectoryFrame out;
  out.time_ps = double(real(head + 12));
  if (!std::isfinite(*out.time_ps)) out.time_ps.reset();
  glm::dmat3 cell(0.0);
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      cell[column][row] = double(real(head + 16 + 4 * (3 * column + row))) * kAngstrom_per_nanometre;
  out.cell_A = cellOf(cell);
  std::vector<glm::vec3> places_nm(atoms_);
  if (atoms_ <= kFewAtoms) {
    char plain[12 * kFewAtoms];
    if (!file_.read(at + kXtcHeader_bytes, plain, 12 * atoms_)) return damaged();
    for (std::size_t i = 0; i < atoms_; ++i)
      for (int k = 0; k < 3; ++k) places_nm[i][k] = real(plain + 12 * i + 4 * std::size_t(k));
  } else {
    const std::size_t length = integer(head) == kMagicLarge ? 8 : 4;
    const std::uint64_t end = frame + 1 < begins_.size() ? begins_[frame + 1] : searched_;
    std::vector<char> bytes(static_cast<std::size_t>(end - at - kXtcHeader_bytes));
    if (bytes.size() < kPacking_bytes + length || !file_.read(at + kXtcHeader_bytes, bytes.data(), bytes.size()))
      return damaged();
    Packing packing;
    packing.precision = real(bytes.data());
    for (std::size_t k = 0; k < 3; ++k) {
      packing.low[k] = integer(bytes.data() + 4 + 4 * k);
      packing.high[k] = integer(bytes.data() + 16 + 4 * k);
    }
    packing.size = integer(bytes.data() + 28);
    if (!unpack(packing, std::span<const char>(bytes).subspan(kPacking_bytes + length), places_nm)) return damaged();
  }
  out.positions_A.reserve(atoms_);
  for (const glm::vec3& place : places_nm) out.positions_A.push_back(Vec3(place) * kAngstrom_per_nanometre);
  if (auto problem = checkPositions(file_.name(), frame, out.positions_A)) return *problem;
  return out;
}

}  // namespace

OpenedTrajectory openXtc(RandomAccessFile file) {
  auto out = std::make_unique<Xtc>(std::move(file));
  if (auto problem = out->open()) return *problem;
  return std::unique_ptr<TrajectoryFile>(std::move(out));
}

}  // namespace moltact
