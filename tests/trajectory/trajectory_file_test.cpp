// Readers of trajectories. Oracles: the formulas of tests/trajectory/data/make.py, files written here byte by byte, and
// MDTraj (Debian's package python3-mdtraj).
#include "engine/trajectory/trajectory_file.h"

#include <doctest/doctest.h>

#include <bit>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>

#include "engine/core/file_bytes.h"
#include "engine/platform/read_file.h"
#include "engine/platform/temporary_folder.h"

using namespace moltact;

namespace {

const std::filesystem::path kHere = std::filesystem::path(MOLTACT_SOURCE_DIR) / "tests/trajectory";

const std::filesystem::path kSource = MOLTACT_SOURCE_DIR;

std::string upper(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return out;
}

std::string bytesOf(const std::filesystem::path& file) {
  auto bytes = readFile(file, std::size_t{1} << 30, {});
  if (!bytes) FAIL(bytes.problem().text());
  return *std::move(bytes);
}

template <class Number>
std::string ordered(Number value, bool big) {
  std::string out(sizeof value, '\0');
  auto bits = std::bit_cast<std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>>(value);
  for (std::size_t k = 0; k < sizeof value; ++k, bits >>= 8)
    out[big ? sizeof value - 1 - k : k] = static_cast<char>(bits & 0xff);
  return out;
}

/// A DCD of CHARMM with a cell; `fixed` atoms at the end are in the first frame only.
std::string dcd(bool big, int atoms, int frames, int fixed) {
  const auto record = [&](const std::string& inside) {
    const std::string length = ordered(std::uint32_t(inside.size()), big);
    return length + inside + length;
  };
  std::string head = "CORD";
  for (int k = 0; k < 20; ++k) {
    const int entries[20] = {frames, 10, 5, 0, 0, 0, 0, 0, fixed, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 24};
    head += k == 9 ? ordered(2.0f, big) : ordered(std::int32_t(entries[k]), big);
  }
  std::string out = record(head) + record(ordered(std::int32_t(1), big) + std::string(80, ' ')) +
                    record(ordered(std::int32_t(atoms), big));
  if (fixed) {
    std::string free;
    for (int i = 0; i < atoms - fixed; ++i) free += ordered(std::int32_t(i + 1), big);
    out += record(free);
  }
  for (int f = 0; f < frames; ++f) {
    std::string cell;
    for (const double value : {30.0, 0.0, 31.0, 0.0, 0.0, 32.0}) cell += ordered(value, big);
    out += record(cell);
    for (int axis = 0; axis < 3; ++axis) {
      std::string row;
      for (int i = 0; i < (f ? atoms - fixed : atoms); ++i) row += ordered(float(100 * f + 10 * axis + i), big);
      out += record(row);
    }
  }
  return out;
}

std::unique_ptr<TrajectoryFile> opened(std::string bytes, const char* name) {
  auto out = openTrajectoryBytes(std::move(bytes), name);
  if (!out) FAIL(out.problem().text());
  (*out)->findMore(std::uint64_t{1} << 60);
  return *std::move(out);
}

TrajectoryFrame frameOf(TrajectoryFile& file, std::size_t frame) {
  auto out = file.read(frame);
  if (!out) FAIL(out.problem().text());
  return *std::move(out);
}

std::string sentence(const Expected<std::unique_ptr<TrajectoryFile>>& from) {
  return from ? std::string("it was opened") : from.problem().text();
}

}  // namespace

TEST_CASE(
    "an XTC file that MDTraj wrote from a formula gives the formula's positions to half of its precision of 0.01 A, "
    "its times and its cell") {
  const auto file = opened(bytesOf(kHere / "data/waters.xtc"), "waters.xtc");
  REQUIRE(file->frames() == 3);
  REQUIRE(file->atoms() == 300);
  CHECK(file->complete());
  CHECK(file->warnings().empty());
  for (int f = 0; f < 3; ++f) {
    const TrajectoryFrame frame = frameOf(*file, std::size_t(f));
    CHECK(*frame.time_ps == 5.0 * f);
    CHECK(glm::length((*frame.cell_A)[1] - Vec3(0, 25, 0)) < 1e-5);
    double farthest_A = 0.0;
    for (int i = 0; i < 300; ++i) {
      const int m = i / 3, k = i % 3;
      const Vec3 right = 10.0 * Vec3(0.31 * (m % 5) + 0.08 * k + 0.01 * f, 0.31 * (m / 5 % 5) - 0.05 * k - 0.37,
                                     0.31 * (m / 25) + 0.02 * k + 0.1 * f);
      const Vec3 off = glm::abs(frame.positions_A[std::size_t(i)] - right);
      farthest_A = std::max({farthest_A, off.x, off.y, off.z});
    }
    CHECK(farthest_A < 0.0051);
  }
}

TEST_CASE(
    "frames of XTC, TRR, DCD and NetCDF that MDTraj wrote are those that MDTraj reads, to the last bit; so are "
    "coordinates that need more than 24 bits and files of seven atoms") {
  if (std::system("/usr/bin/python3 -c 'import mdtraj' >/dev/null 2>&1") != 0) {
    MESSAGE("did not run: MDTraj (Debian's package python3-mdtraj) is not installed");
    return;
  }
  const auto folder = TemporaryFolder::in(std::filesystem::temp_directory_path(), "moltact-mdtraj-");
  REQUIRE(folder);
  const std::string at = folder->path().string();
  REQUIRE(std::system(("/usr/bin/python3 '" + (kHere / "mdtraj_frames.py").string() + "' '" + at + "' >/dev/null 2>&1")
                          .c_str()) == 0);
  for (const std::string name : {"walk.xtc", "far.xtc", "few.xtc", "walk.trr", "walk.dcd", "walk.nc"}) {
    CAPTURE(name);
    const bool nanometres = name.find(".xtc") != std::string::npos || name.find(".trr") != std::string::npos;
    auto file = openTrajectory(folder->path() / name);
    if (!file && file.problem().message == "the NetCDF library is missing") {
      MESSAGE("did not run for NetCDF: its library (Debian's package libnetcdf19 or libnetcdf22) is not installed");
      continue;
    }
    if (!file) FAIL(file.problem().text());
    (*file)->findMore(std::uint64_t{1} << 60);
    REQUIRE((*file)->frames() == 5);
    const std::string right = bytesOf(folder->path() / (name + ".f32"));
    const std::size_t atoms = (*file)->atoms();
    REQUIRE(atoms == (name == "few.xtc" ? 7 : 500));
    REQUIRE(right.size() == 5 * atoms * 12);
    std::size_t different = 0;
    for (std::size_t f = 0; f < 5; ++f) {
      const TrajectoryFrame frame = frameOf(**file, f);
      for (std::size_t i = 0; i < 3 * atoms; ++i) {
        const float value = numberAt<float>(right.data() + 4 * (3 * atoms * f + i));
        different += frame.positions_A[i / 3][int(i % 3)] != (nanometres ? 10.0 : 1.0) * double(value);
      }
      REQUIRE(frame.cell_A);
      if (nanometres) {
        CHECK(*frame.time_ps == 2.5 * double(f));
        CHECK((*frame.cell_A)[1] == Vec3(15, 60, 0));
      } else {
        // The volume of a cell of these edges and angles.
        const double a = 0.0, b = std::cos(80 * M_PI / 180), c = std::cos(70 * M_PI / 180);
        CHECK(glm::determinant(*frame.cell_A) ==
              doctest::Approx(60.0 * 50.0 * 40.0 * std::sqrt(1 - a * a - b * b - c * c + 2 * a * b * c)).epsilon(1e-6));
      }
    }
    CHECK(different == 0);
  }
}

TEST_CASE(
    "a DCD file of either byte order, with atoms that do not move, gives each frame whole; the file's size counts "
    "and not the number in its header") {
  for (const bool big : {false, true})
    for (const int fixed : {0, 2}) {
      CAPTURE(big);
      CAPTURE(fixed);
      std::string bytes = dcd(big, 5, 4, fixed);
      auto file = opened(bytes, "a.dcd");
      CHECK(file->frames() == 4);
      CHECK(file->warnings().empty());
      const TrajectoryFrame frame = frameOf(*file, 3);
      for (int i = 0; i < 5; ++i) {
        const double moved = i < 5 - fixed ? 300.0 : 0.0;
        CHECK(frame.positions_A[std::size_t(i)] == Vec3(moved + i, moved + 10 + i, moved + 20 + i));
      }
      // Angles written as cosines of 90 degrees.
      CHECK((*frame.cell_A)[2] == Vec3(0, 0, 32));
      CHECK(*frame.time_ps == doctest::Approx(0.04888821 * 2.0 * (10 + 3 * 5)));
      bytes.resize(bytes.size() - 3);
      file = opened(bytes, "a.dcd");
      CHECK(file->frames() == 3);
      CHECK(file->warnings().size() == 1);
    }
}

TEST_CASE(
    "frames of a GRO file, models of a PDB file with MODEL or END, and models of an mmCIF file are positions in "
    "angstrom, of any frame in any order") {
  std::ostringstream gro, pdb, ends, cif;
  cif << "data_x\n#\nloop_\n_atom_site.group_PDB\n_atom_site.label_atom_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
         "_atom_site.Cartn_z\n_atom_site.pdbx_PDB_model_num\n";
  pdb << "CRYST1   20.000   21.000   22.000  90.00  90.00  90.00 P 1           1\n";
  char line[120];
  for (int f = 0; f < 3; ++f) {
    gro << "Water t= " << 2 * f << ".00000 step= 7\n    2\n";
    pdb << "MODEL     " << f + 1 << "\n";
    for (int i = 0; i < 2; ++i) {
      const double x = 1.5 * i, y = -2.25, z = 0.125 + f;
      std::snprintf(line, sizeof line, "    1SOL     OW%5d%8.4f%8.4f%8.4f\n", i + 1, x / 10, y / 10, z / 10);
      gro << line;
      std::snprintf(line, sizeof line, "HETATM%5d  O   HOH A   1    %8.3f%8.3f%8.3f  1.00  0.00           O\n", i + 1,
                    x, y, z);
      pdb << line;
      ends << line;
      cif << "HETATM \"O'" << i << "\" " << x << ' ' << y << ' ' << z << ' ' << f + 1 << '\n';
    }
    gro << "   2.0   2.1   2.2   0.0   0.0   0.5   0.0   0.0   0.0\n";
    pdb << "ENDMDL\n";
    ends << "END\n";
  }
  cif << "#\n_other.thing 1\n";
  for (const auto& [text, name] : {std::pair<std::string, const char*>{gro.str(), "a.gro"},
                                   {pdb.str(), "a.pdb"},
                                   {ends.str(), "b.pdb"},
                                   {cif.str(), "a.cif"}}) {
    CAPTURE(name);
    const auto file = opened(text, name);
    REQUIRE(file->frames() == 3);
    CHECK(file->warnings().empty());
    for (const std::size_t f : {2u, 0u, 1u}) {
      const TrajectoryFrame frame = frameOf(*file, f);
      REQUIRE(frame.positions_A.size() == 2);
      CHECK(glm::length(frame.positions_A[1] - Vec3(1.5, -2.25, 0.125 + double(f))) < 1e-12);
    }
  }
  const TrajectoryFrame of_gro = frameOf(*opened(gro.str(), "a.gro"), 2);
  CHECK(*of_gro.time_ps == 4.0);
  CHECK(glm::length((*of_gro.cell_A)[1] - Vec3(5, 21, 0)) < 1e-12);
  CHECK((*frameOf(*opened(pdb.str(), "a.pdb"), 0).cell_A)[2] == Vec3(0, 0, 22));
}

TEST_CASE(
    "a file that ends within a frame gives the frames before, and says which frame is cut short; with no whole frame "
    "it is refused with its name and a remedy") {
  const std::string whole = bytesOf(kHere / "data/waters.xtc");
  auto file = opened(whole.substr(0, whole.size() - 10), "cut.xtc");
  CHECK(file->frames() == 2);
  REQUIRE(file->warnings().size() == 1);
  CHECK(file->warnings()[0] == "cut.xtc: frame 3: the file ends within it; copy or download it again");
  for (const std::size_t n : {0u, 3u, 60u, 200u}) {
    CAPTURE(n);
    CHECK(sentence(openTrajectoryBytes(whole.substr(0, n), "cut.xtc")).starts_with("cut.xtc: "));
  }
  CHECK(sentence(openTrajectoryBytes("nothing of this kind", "a.dcd")) ==
        "a.dcd: this is no DCD file, or it is damaged; copy or download it again");
  CHECK(sentence(openTrajectoryBytes("nothing of this kind", "a.what"))
            .starts_with("a.what: this is no trajectory that can be read; "));
  for (const TrajectoryFormat& format : trajectoryFormats()) {
    CAPTURE(format.ending);
    CHECK(sentence(openTrajectoryBytes("nothing of this kind", "a.what")).find(format.name) != std::string::npos);
    CHECK(hasTrajectoryName("A" + upper(format.ending)) == !format.describes_atoms);
    CHECK(sentence(openTrajectoryBytes("nothing of this kind", "a" + std::string(format.ending)))
              .starts_with("a" + std::string(format.ending) + ": "));
  }
  CHECK(sentence(openTrajectory(kHere / "missing.xtc")).find("missing.xtc") != std::string::npos);
  std::string other = whole;
  // The second frame states another number of atoms.
  const std::size_t second = whole.find(std::string("\0\0\x07\xcb", 4), 8);
  REQUIRE(second != std::string::npos);
  other.replace(second + 4, 4, ordered(std::int32_t(299), true));
  other.replace(second + 52, 4, ordered(std::int32_t(299), true));
  file = opened(other, "a.xtc");
  CHECK(file->frames() == 1);
  CHECK(file->warnings()[0].find("frame 2: it has 299 atoms and not 300") != std::string::npos);
}

TEST_CASE("an XTC file with any one byte changed is read or refused, and no position is NaN or out of range") {
  const std::string whole = bytesOf(kHere / "data/waters.xtc");
  std::size_t read = 0, refused = 0;
  for (std::size_t k = 0; k < whole.size(); k += 3) {
    std::string bytes = whole;
    bytes[k] = static_cast<char>(~bytes[k]);
    auto file = openTrajectoryBytes(bytes, "a.xtc");
    if (!file) {
      ++refused;
      continue;
    }
    (*file)->findMore(std::uint64_t{1} << 60);
    for (std::size_t f = 0; f < (*file)->frames(); ++f) {
      const auto frame = (*file)->read(f);
      ++(frame ? read : refused);
      if (!frame) continue;
      for (const Vec3& place : frame->positions_A)
        for (int axis = 0; axis < 3; ++axis) REQUIRE(std::abs(place[axis]) <= 1e9);
    }
  }
  CHECK(read > 100);
  CHECK(refused > 20);
}

TEST_CASE(
    "docs/trajectories.md lists every format by its name and ending, and the reference of lessons names each format") {
  const std::string page = bytesOf(kSource / "docs/trajectories.md"),
                    reference = bytesOf(kSource / "docs/lesson-reference.md");
  const auto line = [](const std::string& text, std::string_view start) {
    const std::size_t from = text.find(start);
    return from == std::string::npos ? std::string() : text.substr(from, text.find('\n', from) - from);
  };
  const std::string key = line(reference, "| `trajectory` |");
  for (const TrajectoryFormat& format : trajectoryFormats()) {
    CAPTURE(format.ending);
    CHECK(page.find("`" + std::string(format.ending) + "`") != std::string::npos);
    CHECK(page.find(format.name) != std::string::npos);
    CHECK(key.find(format.name) != std::string::npos);
  }
}
