// A trajectory of 20 GB: a sparse file, of which the disk holds only the frames that are read here.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "engine/platform/temporary_folder.h"
#include "engine/trajectory/frame_store.h"
#include "tests/resident_memory.h"

using namespace moltact;
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kSize_bytes = std::uint64_t{20'000'000'000};
constexpr std::uint32_t kAtoms = 100'000;
constexpr std::uint64_t kRecord_bytes = 4 * std::uint64_t{kAtoms} + 8, kFrame_bytes = 3 * kRecord_bytes;

// Little-endian.
std::string word(std::uint32_t value) {
  std::string out(4, '\0');
  for (char& byte : out) byte = static_cast<char>(value & 0xff), value >>= 8;
  return out;
}
std::string recordOf(const std::string& inside) {
  return word(std::uint32_t(inside.size())) + inside + word(std::uint32_t(inside.size()));
}

std::string header() {
  std::string head = "CORD";
  for (int k = 0; k < 20; ++k) head += word(k == 2 ? 1 : k == 19 ? 24 : 0);
  return recordOf(head) + recordOf(word(1) + std::string(80, ' ')) + recordOf(word(kAtoms));
}

// The markers of a frame's records, and its number as the place of the first atom; all else is a hole: zeros.
void writeFrame(std::fstream& file, std::uint64_t at, std::size_t frame) {
  for (int axis = 0; axis < 3; ++axis) {
    const float place = float(frame) + 0.25f * float(axis);
    std::uint32_t bits = 0;
    static_assert(sizeof bits == sizeof place);
    std::memcpy(&bits, &place, sizeof bits);
    file.seekp(std::streamoff(at + std::uint64_t(axis) * kRecord_bytes));
    file << word(4 * kAtoms) << word(bits);
    file.seekp(std::streamoff(at + std::uint64_t(axis + 1) * kRecord_bytes - 4));
    file << word(4 * kAtoms);
  }
}

}  // namespace

TEST_CASE(
    "a DCD file of 20 GB opens, and its first, middle and last frame and 200 between them are read, with at most 256 "
    "MB "
    "more in memory; a byte less cuts off its last frame") {
  const auto folder = TemporaryFolder::in(fs::temp_directory_path(), "moltact-large-");
  REQUIRE(folder);
  const fs::path path = folder->path() / "large.dcd";
  const std::string head = header();
  const std::size_t frames = std::size_t((kSize_bytes - head.size()) / kFrame_bytes);
  const std::uint64_t size = head.size() + frames * kFrame_bytes;
  std::ofstream(path, std::ios::binary) << head;
  const fs::space_info before_space = fs::space(folder->path());
  std::error_code error;
  fs::resize_file(path, size, error);
  // A file system without sparse files would fill the disk.
  const fs::space_info after_space = fs::space(folder->path());
  if (error || before_space.free > after_space.free + (std::uint64_t{1} << 30)) {
    MESSAGE("did not run: no sparse file of 20 GB can be made in ", folder->path().string(), " ", error.message());
    return;
  }
  std::vector<std::size_t> numbers{0, frames / 2, frames - 1};
  for (std::size_t k = 1; k <= 200; ++k) numbers.push_back(k * (frames - 1) / 201);
  {
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    for (const std::size_t k : numbers) writeFrame(file, head.size() + k * kFrame_bytes, k);
    REQUIRE(file.good());
  }
  std::vector<PlacedAtom> atoms(kAtoms);
  for (std::size_t i = 0; i < kAtoms; ++i) {
    atoms[i].position.A = Vec3(3.0 * double(i % 50), 3.0 * double(i / 50 % 50), 3.0 * double(i / 2500));
    atoms[i].radius_A = 1.7;
    atoms[i].atomic_number = 6;
  }
  auto molecule = std::make_shared<Molecule>();
  molecule->setAtoms(atoms);

  const auto before = test::residentMemory();
  const bool measured = before && test::forgetPeak();
  auto store = FrameStore::open(path, molecule, FrameFit{.superposed = false, .on = {}});
  if (!store) FAIL(store.problem().text());
  CHECK((*store)->file().frames() == frames);
  CHECK((*store)->file().complete());
  for (const std::size_t k : numbers) {
    CAPTURE(k);
    const auto places = (*store)->at(k);
    if (!places) FAIL(places.problem().text());
    CHECK((**places)[0] == Vec3(double(k), double(k) + 0.25, double(k) + 0.5));
    CHECK((**places)[kAtoms - 1] == Vec3(0.0));
  }
  // Zeros of a hole are no frame.
  CHECK_FALSE((*store)->at(1));
  if (measured) {
    const double more_MB = test::residentMemory()->peak_MB - before->now_MB;
    MESSAGE("a file of ", double(size) / 1e9, " GB, ", frames, " frames, ", numbers.size(), " read: at most ", more_MB,
            " MB more");
    CHECK(more_MB < 256.0);
    CHECK(more_MB > 10.0);  // the kept frames are counted
  } else {
    MESSAGE("the memory was not measured: the system does not say how much is resident");
  }
  fs::resize_file(path, size - 1);
  const auto cut = openTrajectory(path);
  REQUIRE(cut);
  CHECK((*cut)->frames() == frames - 1);
}
