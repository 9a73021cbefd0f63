// A played trajectory of 14 000 and of 100 000 atoms, as the window plays it at 30 frames a second, from a file that is
// written into a temporary folder and streamed from the disk: what a frame costs the reading thread and the window's
// thread, and a tick in contact with the exact tracker on a thread of its own, as in the servo loop. Last, the time that
// the search for the frames of an XTC file takes, whose frames differ in size. Run: build/release/trajectory_benchmark
#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <semaphore>
#include <string>
#include <thread>
#include <vector>

#include "engine/bench/hip_paths.h"
#include "engine/bench/scenes.h"
#include "engine/haptics/methods.h"
#include "engine/haptics/sphere_motion.h"
#include "engine/platform/temporary_folder.h"
#include "engine/render/molecule_model.h"
#include "engine/trajectory/frame_store.h"

namespace {

using namespace moltact;
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kPiece_ticks = 33;  // as PlayedTrajectory

double milliseconds(Clock::time_point from) {
  return std::chrono::duration<double, std::milli>(Clock::now() - from).count();
}
double quantileOf(std::vector<double> of, double share) {
  std::sort(of.begin(), of.end());
  return of[std::size_t(share * double(of.size() - 1))];
}

int fail(const Problem& problem) {
  std::fprintf(stderr, "%s\n", problem.text().c_str());
  return 1;
}

std::shared_ptr<const Molecule> moleculeOf(const std::vector<Sphere>& spheres) {
  std::vector<PlacedAtom> placed;
  for (const Sphere& b : spheres) {
    PlacedAtom a;
    a.position.A = b.centre_A;
    a.radius_A = b.radius_A;
    a.atomic_number = std::uint8_t(6 + placed.size() % 3);
    placed.push_back(a);
  }
  Molecule molecule;
  molecule.setAtoms(placed);
  return std::make_shared<const Molecule>(std::move(molecule));
}

// Atoms that swing by 0.5 A in directions and at paces of their own.
class Swinging {
 public:
  explicit Swinging(std::vector<Sphere> rest) : rest_(std::move(rest)) {
    scenes::Random random(7);
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      way_.push_back(0.5 * random.direction());
      phase_.push_back(random.uniform(0.0, 6.28));
      pace_.push_back(random.uniform(0.05, 0.3));
    }
  }
  std::vector<Vec3> at(int frame) const {
    std::vector<Vec3> out(rest_.size());
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = rest_[i].centre_A + way_[i] * std::sin(phase_[i] + pace_[i] * frame);
    return out;
  }

 private:
  std::vector<Sphere> rest_;
  std::vector<Vec3> way_;
  std::vector<double> phase_, pace_;
};

void append(std::string& to, std::uint32_t value, bool big) {
  for (int k = 0; k < 4; ++k) to += static_cast<char>(value >> (big ? 24 - 8 * k : 8 * k) & 0xff);
}

std::string dcdHeader(std::size_t atoms) {
  std::string out;
  const auto entry = [&](std::uint32_t value) { append(out, value, false); };
  entry(84), out += "CORD";
  for (int k = 0; k < 20; ++k) entry(k == 2 ? 1 : k == 19 ? 24 : 0);
  entry(84), entry(84), entry(1), out += std::string(80, ' '), entry(84);
  entry(4), entry(std::uint32_t(atoms)), entry(4);
  return out;
}

std::string dcdFrame(const std::vector<Vec3>& places_A) {
  std::string out;
  const auto length = std::uint32_t(4 * places_A.size());
  for (int axis = 0; axis < 3; ++axis) {
    append(out, length, false);
    for (const Vec3& p : places_A) append(out, std::bit_cast<std::uint32_t>(float(p[axis])), false);
    append(out, length, false);
  }
  return out;
}

// Each atom in full width and without runs: valid, larger than what GROMACS writes.
std::string xtcFrame(const std::vector<Vec3>& places_A, int frame) {
  constexpr float kPrecision = 1000.0f;
  std::vector<std::array<std::int32_t, 3>> whole;
  std::array<std::int32_t, 3> low, high;
  low.fill(std::numeric_limits<std::int32_t>::max()), high.fill(std::numeric_limits<std::int32_t>::min());
  for (const Vec3& p : places_A) {
    std::array<std::int32_t, 3> v{};
    for (int k = 0; k < 3; ++k) {
      v[std::size_t(k)] = std::int32_t(std::lround(0.1 * p[k] * double(kPrecision)));
      low[std::size_t(k)] = std::min(low[std::size_t(k)], v[std::size_t(k)]);
      high[std::size_t(k)] = std::max(high[std::size_t(k)], v[std::size_t(k)]);
    }
    whole.push_back(v);
  }
  std::array<std::uint64_t, 3> sizes{};
  for (std::size_t k = 0; k < 3; ++k) sizes[k] = std::uint64_t(high[k] - low[k]) + 1;
  const int width = std::bit_width(sizes[0] * sizes[1] * sizes[2]);
  std::string bits;
  int free_bits = 0;
  const auto put = [&](std::uint64_t value, int count) {
    for (int k = count - 1; k >= 0; --k) {
      if (free_bits == 0) bits += '\0', free_bits = 8;
      --free_bits;
      if (value >> k & 1u) bits.back() = static_cast<char>(bits.back() | 1 << free_bits);
    }
  };
  for (const auto& v : whole) {
    std::uint64_t packed = 0;
    for (std::size_t k = 0; k < 3; ++k) packed = packed * sizes[k] + std::uint64_t(v[k] - low[k]);
    int left = width;
    for (; left >= 8; left -= 8, packed >>= 8) put(packed & 0xff, 8);
    if (left > 0) put(packed, left);
    put(0, 1);
  }
  std::string out;
  const auto entry = [&](std::uint32_t value) { append(out, value, true); };
  const auto real = [&](float value) { entry(std::bit_cast<std::uint32_t>(value)); };
  entry(1995), entry(std::uint32_t(places_A.size())), entry(std::uint32_t(frame)), real(float(frame));
  for (int k = 0; k < 9; ++k) real(0.0f);
  entry(std::uint32_t(places_A.size())), real(kPrecision);
  for (const auto& bound : {low, high})
    for (const std::int32_t v : bound) entry(std::uint32_t(v));
  entry(30), entry(std::uint32_t(bits.size()));
  bits.resize((bits.size() + 3) / 4 * 4);
  return out + bits;
}

// Runs the ticks of each piece on a thread of its own, whose core keeps the tracker's data between pieces.
class TickThread {
 public:
  TickThread(std::shared_ptr<const SphereGrid> grid, std::vector<Vec3> hips)
      : hips_(std::move(hips)), tracker_(referenceMethod().make(std::move(grid), kWaterProbe_A)) {
    tracker_->step({Vec3(1e4)});
    thread_ = std::thread([this] { run(); });
  }
  ~TickThread() {
    motion_ = nullptr;
    begin_.release();
    thread_.join();
  }
  /// The mean time of a tick on this motion.
  double ticks_ns(const SphereMotion& motion) {
    motion_ = &motion;
    begin_.release();
    done_.acquire();
    return tick_ns_;
  }
  double touching() const { return double(touching_) / double(ticks_); }

 private:
  void run() {
    for (begin_.acquire(); motion_; begin_.acquire()) {
      const Clock::time_point began = Clock::now();
      tracker_->setMotion(motion_);
      for (int tick = 1; tick <= kPiece_ticks; ++tick) {
        tracker_->advanceTo(double(tick) / kPiece_ticks);
        touching_ += tracker_->step({hips_[ticks_++]}).touching();
      }
      tick_ns_ = 1e6 * milliseconds(began) / kPiece_ticks;
      done_.release();
    }
  }

  std::vector<Vec3> hips_;
  std::unique_ptr<Tracker> tracker_;
  const SphereMotion* motion_ = nullptr;
  std::size_t touching_ = 0, ticks_ = 0;
  double tick_ns_ = 0;
  std::binary_semaphore begin_{0}, done_{0};
  std::thread thread_;
};

int play(const fs::path& path, const std::vector<Sphere>& spheres, std::size_t frames) {
  const auto molecule = moleculeOf(spheres);
  const Clock::time_point opening = Clock::now();
  auto store = FrameStore::open(path, molecule, {});
  if (!store) return fail(store.problem());
  (*store)->file().findMore(~std::uint64_t{0} >> 1);
  const double opened_ms = milliseconds(opening);
  const auto grid = std::make_shared<const SphereGrid>(molecule->spheres);
  MoleculeModel picture(molecule, 1'000'000);
  std::vector<double> read_ms, window_ms, tick_ns;
  std::unique_ptr<const SphereMotion> motion, before;
  TickThread servo(grid, bench::slidingPath(grid, kWaterProbe_A, 0.6, int(frames) * kPiece_ticks, 2));
  AtomPositions from;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    Clock::time_point began = Clock::now();
    auto read = (*store)->at(frame);
    if (!read) return fail(read.problem());
    read_ms.push_back(milliseconds(began));
    if (!from) from = *read;
    // What the window does for a piece of the motion.
    began = Clock::now();
    const std::vector<Vec3> places = between(*from, **read, 1.0);
    std::vector<Sphere> to = molecule->spheres.copy();
    for (std::size_t i = 0; i < to.size(); ++i) to[i].centre_A = places[i];
    auto next = motion ? SphereMotion::after(*motion, to, kPiece_ticks)
                       : SphereMotion::make(molecule->spheres, to, kPiece_ticks);
    if (!next) return fail(next.problem());
    const SharedArray<Sphere> seen = (*next)->at(0.5);
    const auto seen_grid = SphereGrid::within((*next)->sweptSpheres(), seen);
    picture.moveTo(std::make_shared<const Molecule>(molecule->movedTo(seen)));
    window_ms.push_back(milliseconds(began));
    before = std::move(motion);
    motion = *std::move(next);
    from = *read;
    tick_ns.push_back(servo.ticks_ns(*motion));
  }
  std::printf(
      "%7zu atoms %s %6.1f MB: opened in %5.1f ms; a frame is read in %5.2f ms (p99 %5.2f); window's thread "
      "%5.2f ms a frame (p99 %5.2f); tick %4.0f ns (p99 of frames %4.0f), %2.0f %% in contact\n",
      spheres.size(), path.extension().string().c_str() + 1, double(fs::file_size(path)) / 1e6, opened_ms,
      quantileOf(read_ms, 0.5), quantileOf(read_ms, 0.99), quantileOf(window_ms, 0.5), quantileOf(window_ms, 0.99),
      quantileOf(tick_ns, 0.5), quantileOf(tick_ns, 0.99), 100.0 * servo.touching());
  return 0;
}

// A file of at least `bytes`: the same frame again and again, since the search reads the lengths of frames only.
int search(const fs::path& path, const std::vector<Sphere>& spheres, std::uint64_t bytes) {
  const std::string frame = xtcFrame(Swinging(spheres).at(1), 1);
  std::size_t frames = 0;
  {
    std::ofstream file(path, std::ios::binary);
    for (std::uint64_t written = 0; written < bytes; written += frame.size(), ++frames) file << frame;
  }
  const Clock::time_point began = Clock::now();
  auto file = openTrajectory(path);
  if (!file) return fail(file.problem());
  const double opened_ms = milliseconds(began);
  (*file)->findMore(~std::uint64_t{0} >> 1);
  const double found_ms = milliseconds(began);
  if ((*file)->frames() != frames) return 1;
  std::printf("%7zu atoms xtc %6.1f MB, %zu frames: opened in %.2f ms, all frames found in %.1f ms: %.0f ms per GB\n",
              spheres.size(), double(fs::file_size(path)) / 1e6, frames, opened_ms, found_ms,
              found_ms / (double(fs::file_size(path)) / 1e9));
  return 0;
}

}  // namespace

int main() {
  const auto folder = TemporaryFolder::in(fs::temp_directory_path(), "moltact-trajectory-");
  if (!folder) return fail(folder.problem());
  int failed = 0;
  for (const std::size_t atoms : {std::size_t(14'000), std::size_t(100'000)}) {
    const std::vector<Sphere> spheres = bench::proteinLike(atoms, 1);
    const Swinging swinging(spheres);
    const std::size_t frames = atoms < 50'000 ? 300 : 100;
    for (const char* name : {"played.dcd", "played.xtc"}) {
      const fs::path path = folder->path() / name;
      const bool dcd = path.extension() == ".dcd";
      {
        std::ofstream file(path, std::ios::binary);
        if (dcd) file << dcdHeader(atoms);
        for (std::size_t k = 0; k < frames; ++k) {
          const std::vector<Vec3> places = swinging.at(int(k));
          file << (dcd ? dcdFrame(places) : xtcFrame(places, int(k)));
        }
      }
      failed |= play(path, spheres, frames);
      fs::remove(path);
    }
  }
  for (const std::size_t atoms : {std::size_t(1'000), std::size_t(14'000)})
    failed |= search(folder->path() / "long.xtc", bench::proteinLike(atoms, 1), 500'000'000);
  return failed;
}
