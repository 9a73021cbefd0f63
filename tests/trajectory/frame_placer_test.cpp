// Whole molecules, superposition, smoothing, and the atoms of a file that a molecule leaves out.
#include <doctest/doctest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <sstream>

#include "engine/core/random.h"
#include "engine/molecule/reader.h"
#include "engine/structure/superposition.h"
#include "engine/trajectory/frame_store.h"

using namespace moltact;

namespace {

std::string pdbLine(int number, const char* name, const char* residue, int of, const Vec3& at, const char* element,
                    char alternate = ' ', double occupancy = 1.0) {
  char line[100];
  std::snprintf(line, sizeof line, "ATOM  %5d %-4s%c%3s A%4d    %8.3f%8.3f%8.3f%6.2f  0.00          %2s\n", number,
                name, alternate, residue, of, at.x, at.y, at.z, occupancy, element);
  return line;
}

/// Four alanines in a crooked chain, two waters among them, one alternate.
std::string structure() {
  std::string out;
  int n = 0;
  for (int r = 0; r < 4; ++r) {
    const Vec3 at(3.8 * r, r % 2 ? 1.0 : 0.0, 0.4 * r * r);
    out += pdbLine(++n, " N", "ALA", r + 1, at, "N");
    out += pdbLine(++n, " CA", "ALA", r + 1, at + Vec3(1.45, 0, 0), "C");
    out += pdbLine(++n, " C", "ALA", r + 1, at + Vec3(2.0, 1.4, 0), "C");
    out += pdbLine(++n, " O", "ALA", r + 1, at + Vec3(1.5, 2.5, 0), "O");
    if (r == 1) {
      out += pdbLine(++n, " CB", "ALA", r + 1, at + Vec3(1.9, -0.7, 1.2), "C", 'A', 0.3);
      out += pdbLine(++n, " CB", "ALA", r + 1, at + Vec3(1.9, -0.7, 1.3), "C", 'B', 0.7);
    } else {
      out += pdbLine(++n, " CB", "ALA", r + 1, at + Vec3(1.9, -0.7, 1.2), "C");
    }
    if (r == 2) out += pdbLine(++n, " O", "HOH", 90, {0, 9, 9}, "O");
  }
  out += pdbLine(++n, " O", "HOH", 91, {5, 9, 9}, "O");
  return out + "END\n";
}

std::shared_ptr<const Molecule> moleculeOf(const std::string& text) {
  auto out = readMoleculeBytes(text, "a.pdb");
  if (!out) FAIL(out.problem().text());
  return std::make_shared<const Molecule>(*std::move(out));
}

FramePlacer placerOf(const std::shared_ptr<const Molecule>& molecule, std::size_t atoms, const FrameFit& fit) {
  auto out = FramePlacer::make(molecule, atoms, "a.xtc", fit);
  if (!out) FAIL(out.problem().text());
  return *std::move(out);
}

const FrameFit kLeft{false, {}};  // where it is

double farthest_A(const std::vector<Vec3>& places, const Molecule& molecule) {
  double out = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i)
    out = std::max(out, glm::distance(places[i], molecule.spheres[i].centre_A));
  return out;
}

}  // namespace

TEST_CASE(
    "a molecule knows the number of each atom in its file: the alternate of lower occupancy and two waters are "
    "counted and left out") {
  const auto molecule = moleculeOf(structure());
  CHECK(molecule->atoms.size() == 20);
  CHECK(molecule->atoms_in_file == 23);
  REQUIRE(molecule->numbers_in_file.size() == 20);
  CHECK(molecule->numbers_in_file[8] == 8);   // O of the second residue
  CHECK(molecule->numbers_in_file[9] == 10);  // its second CB
  CHECK(molecule->numbers_in_file[14] == 15);
  CHECK(molecule->numbers_in_file[15] == 17);  // after the first water
  const auto all = readMoleculeBytes(structure(), "a.pdb", {.waters = true});
  CHECK(all->numbers_in_file[15] == 16);
  // Water between a protein's atom and an ion, and no alternates.
  const auto ion = moleculeOf(pdbLine(1, " CA", "ALA", 1, {0, 0, 0}, "C") + pdbLine(2, " O", "HOH", 2, {9, 0, 0}, "O") +
                              pdbLine(3, " O", "HOH", 3, {9, 9, 0}, "O") + pdbLine(4, "NA", " NA", 4, {5, 0, 0}, "NA") +
                              pdbLine(5, "NA", " NA", 5, {5, 5, 0}, "NA") + "END\n");
  REQUIRE(ion->atoms.size() == 3);
  REQUIRE(ion->numbers_in_file.size() == 3);
  CHECK(ion->numbers_in_file[0] == 0);
  CHECK(ion->numbers_in_file[1] == 3);
  CHECK(ion->numbers_in_file[2] == 4);
  // Nothing left out: no list.
  const auto plain = moleculeOf(pdbLine(1, " CA", "ALA", 1, {0, 0, 0}, "C") + "END\n");
  CHECK(plain->numbers_in_file.empty());
  CHECK(plain->atoms_in_file == 1);
}

TEST_CASE(
    "a frame with the atoms of the file, rotated, shifted and cut by an oblique cell anywhere, is put back on the "
    "structure to 1e-9 A in 200 random frames") {
  const auto molecule = moleculeOf(structure());
  auto models = openTrajectoryBytes(structure(), "a.pdb");
  REQUIRE(models);
  const auto still = (*models)->read(0);
  REQUIRE(still);
  const FramePlacer placer = placerOf(molecule, 23, {});
  CHECK(farthest_A(placer.place(*still), *molecule) < 1e-9);
  std::uint64_t seed = 5;
  const auto uniform = [&](double low, double high) { return low + (high - low) * nextFraction(seed); };
  glm::dmat3 cell(0.0);
  cell[0] = {26, 0, 0}, cell[1] = {5, 27, 0}, cell[2] = {-4, 6, 25};
  for (int k = 0; k < 200; ++k) {
    TrajectoryFrame frame = *still;
    const Vec3 axis = glm::normalize(Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)));
    const glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), uniform(-3.1, 3.1), axis));
    const Vec3 shift(uniform(-40, 40), uniform(-40, 40), uniform(-40, 40));
    frame.cell_A = turn * cell;  // the superposition turns the cell back
    for (Vec3& place : frame.positions_A) {
      place = turn * place + shift;
      // Into the cell, atom by atom.
      const Vec3 share = glm::inverse(*frame.cell_A) * place;
      place -= *frame.cell_A * glm::floor(share);
    }
    REQUIRE(farthest_A(placer.place(frame), *molecule) < 1e-9);
  }
}

TEST_CASE(
    "without superposition a frame stays where it is; superposed on two residues, these are nearest and the others "
    "show what moved") {
  const auto molecule = moleculeOf(structure());
  TrajectoryFrame frame;
  for (const Sphere& sphere : molecule->spheres) frame.positions_A.push_back(sphere.centre_A + Vec3(3, 4, 0));
  CHECK(farthest_A(placerOf(molecule, 20, kLeft).place(frame), *molecule) == doctest::Approx(5.0));
  for (std::size_t i = 15; i < 20; ++i) frame.positions_A[i] += Vec3(0, 0, 2);
  FrameFit fit;
  for (std::uint32_t i = 0; i < 15; ++i) fit.on.push_back(i);
  const std::vector<Vec3> places = placerOf(molecule, 20, fit).place(frame);
  for (std::size_t i = 0; i < 20; ++i)
    CHECK(glm::distance(places[i], molecule->spheres[i].centre_A + Vec3(0, 0, i < 15 ? 0 : 2)) < 1e-9);
}

TEST_CASE("frames with another number of atoms are refused with both numbers") {
  const auto molecule = moleculeOf(structure());
  const auto placer = FramePlacer::make(molecule, 21, "a.xtc", {});
  REQUIRE(!placer);
  CHECK(placer.problem().text() ==
        "a.xtc: its frames have 21 atoms; the molecule has 20, and its file 23; take the structure from which the "
        "trajectory was computed, with the same atoms");
}

TEST_CASE(
    "smoothing is the mean of as many frames before as after; the survey finds the fluctuation of an oscillation of 1 "
    "A, its root of a half, and the RMSD") {
  const std::string one = structure();
  const auto molecule = moleculeOf(one);
  // One residue swings along z with eight frames a period; the others rest.
  std::ostringstream text;
  for (int f = 0; f < 16; ++f) {
    text << "MODEL\n";
    std::istringstream lines(one);
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with("ATOM")) {
        if (line.substr(22, 4) == "   4") {
          char z[20];
          std::snprintf(z, sizeof z, "%8.3f", std::stod(line.substr(46, 8)) + std::sin(f * M_PI / 4));
          line.replace(46, 8, z);
        }
        text << line << '\n';
      }
    text << "ENDMDL\n";
  }
  const auto store = [&] {
    auto file = openTrajectoryBytes(text.str(), "m.pdb");
    REQUIRE(file);
    (*file)->findMore(1 << 30);
    FramePlacer placer = placerOf(molecule, 23, kLeft);
    return std::make_unique<FrameStore>(*std::move(file), std::move(placer));
  }();
  REQUIRE(store->file().frames() == 16);
  const auto z = [&](std::size_t frame, std::size_t smoothing) {
    auto at = store->at(frame, smoothing);
    REQUIRE(at);
    return (**at)[18].z - molecule->spheres[18].centre_A.z;
  };
  CHECK(z(2, 0) == doctest::Approx(1.0).epsilon(1e-3));
  CHECK(z(2, 1) == doctest::Approx((1.0 + std::sqrt(2.0)) / 3.0).epsilon(1e-3));
  CHECK(z(1, 4) == doctest::Approx((0.0 + std::sqrt(0.5) + 1.0) / 3.0).epsilon(1e-3));
  CHECK(z(0, 4) == doctest::Approx(0.0));
  auto survey = surveyTrajectory(*store, 0, 16, 100);
  REQUIRE(survey);
  CHECK(survey->every == 1);
  CHECK(double(survey->fluctuation_A[18]) == doctest::Approx(std::sqrt(0.5)).epsilon(1e-3));
  CHECK(double(survey->fluctuation_A[3]) < 1e-6);
  // One of four CA by 1 A.
  CHECK(double(survey->rmsd_A[2]) == doctest::Approx(0.5).epsilon(1e-3));
  CHECK(surveyTrajectory(*store, 0, 16, 4)->rmsd_A.size() == 4);
}
