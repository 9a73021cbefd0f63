// Oracles: texts written by hand; the finished maps of Debian's package autogrid-test, with the terms of AutoGrid that ours
// do not have (smoothing and desolvation) from the formulas of Huey et al., J. Comput. Chem. 28, 1145, 2007.
#include "engine/structure/map_file.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "engine/haptics/field/compute_grid.h"
#include "engine/platform/temporary_folder.h"

using namespace moltact;

namespace {

const std::string kMapHeader =
    "GRID_PARAMETER_FILE a.gpf\nGRID_DATA_FILE a.maps.fld\nMACROMOLECULE a.pdbqt\nSPACING 0.375\nNELEMENTS 4 4 4\n"
    "CENTER 2.500 6.500 -7.500\n";

std::string valuesOf(std::size_t count, const char* each = "-0.25\n") {
  std::string out;
  for (std::size_t k = 0; k < count; ++k) out += each;
  return out;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

std::string problemOf(const std::string& text) {
  const auto map = readMap(text, "a.map");
  REQUIRE_FALSE(map);
  CHECK_FALSE(map.problem().remedy.empty());
  return map.problem().text();
}

}  // namespace

TEST_CASE("a map of AutoGrid gives its box and values, whatever the line ends") {
  std::string text = kMapHeader;
  for (int k = 0; k < 125; ++k) text += std::to_string(k) + ".500\r\n";
  const auto map = readMap(text, "a.map");
  REQUIRE(map);
  CHECK(map->molecule == "a.pdbqt");
  CHECK(map->box.nodes == std::array<int, 3>{5, 5, 5});
  CHECK(map->box.spacing_A == 0.375);
  CHECK(glm::distance(map->box.node(2, 2, 2), Vec3(2.5, 6.5, -7.5)) < 1e-12);
  CHECK(map->values[map->box.index(1, 2, 3)] == 1 + 5 * (2 + 5 * 3) + 0.5f);
}

TEST_CASE(
    "a wrong count or spacing, a map of 10 GB, a value that is no number and a file cut short get place and remedy") {
  const std::string right = kMapHeader + valuesOf(125);
  REQUIRE(readMap(right, "a.map"));
  CHECK(problemOf(kMapHeader + valuesOf(124)) ==
        "a.map:130: the map has only 124 of the 125 values of its points; the file is cut short; copy it or write it "
        "again");
  CHECK(problemOf(kMapHeader + valuesOf(126)).starts_with("a.map:132: the map has more values than its 125 points"));
  CHECK(problemOf(replaced(right, "0.375", "0")).starts_with("a.map:4: the spacing of the grid is not from 0.05"));
  CHECK(problemOf(replaced(right, "0.375", "nan")).starts_with("a.map:4: the spacing"));
  CHECK(problemOf(replaced(right, "4 4 4", "1400 1400 1400")) ==
        "a.map:5: the grid would have more than 67 million points; choose a wider spacing or a smaller box");
  CHECK(problemOf(replaced(right, "4 4 4", "4 4")).starts_with("a.map:5: the line NELEMENTS is not of numbers"));
  CHECK(problemOf(replaced(right, "4 4 4", "4 -4 4")).starts_with("a.map:5: a map has at least 3 intervals"));
  CHECK(problemOf(replaced(right, "2.500", "1e300")).starts_with("a.map:6: the centre of the map"));
  CHECK(problemOf(replaced(right, "SPACING", "PLACING")).starts_with("a.map:4:1: expected the line SPACING"));
  for (const char* bad : {"nan", "inf", "1e99", "2,5", "--1"}) {
    CAPTURE(bad);
    CHECK(problemOf(replaced(right, "-0.25", bad)).starts_with("a.map:7: expected an energy in kcal/mol, found"));
  }
  for (std::size_t length = 0; length + 5 < right.size(); length += 7) {
    CAPTURE(length);
    CHECK_FALSE(readMap(right.substr(0, length), "a.map"));
  }
  CHECK(problemOf("").starts_with("a.map: the map ends before its line GRID_PARAMETER_FILE"));
}

TEST_CASE("a written map reads back: the box to 1e-9 A, values to 5e-5, walls as 1e5") {
  const auto box = mapBoxRound(Vec3(-2.1234, 0, 1), Vec3(3, 1.77777, 2.5), 0.3);
  REQUIRE(box);
  for (const int n : box->nodes) CHECK(n % 2 == 1);
  for (int axis = 0; axis < 3; ++axis) {
    CHECK(box->low_A()[axis] <= Vec3(-2.1234, 0, 1)[axis]);
    CHECK(box->high_A()[axis] >= Vec3(3, 1.77777, 2.5)[axis]);
  }
  std::vector<float> values(box->count());
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = k % 11 ? float(k) * 0.01234f - 3.0f : 1e12f;
  const auto map = readMap(mapText(*box, values, "m", "1hpv"), "m.C.map");
  REQUIRE(map);
  CHECK(map->molecule == "1hpv");
  CHECK(map->box.nodes == box->nodes);
  CHECK(glm::distance(map->box.first_A, box->first_A) < 1e-9);
  for (std::size_t k = 0; k < values.size(); ++k)
    CHECK(std::abs(map->values[k] - std::min(values[k], 1e5f)) < 6e-5f + 1e-6f * std::abs(map->values[k]));
  CHECK(mapBoxRound(Vec3(0), Vec3(500), 0.375).problem().text() ==
        "the grid would have more than 67 million points; choose a wider spacing or a smaller box");
}

namespace {

// Numbers of AutoDock's force field AD4.1 (Huey et al. 2007): the distance of lowest energy and the depth of two equal
// atoms, the volume and the solvation parameter.
struct DockType {
  double distance_A, depth_kcal_mol, volume_A3, solvation;
};
const std::map<std::string, DockType> kDockTypes{
    {"C", {4.0, 0.15, 33.5103, -0.00143}}, {"A", {4.0, 0.15, 33.5103, -0.00052}},
    {"N", {3.5, 0.16, 22.4493, -0.00162}}, {"NA", {3.5, 0.16, 22.4493, -0.00162}},
    {"OA", {3.2, 0.2, 17.1573, -0.00251}}, {"SA", {4.0, 0.2, 33.5103, -0.00214}},
    {"HD", {2.0, 0.02, 0.0, 0.00051}},
};

struct DockAtom {
  Vec3 at_A;
  double charge_e;
  DockType type;
};

std::vector<DockAtom> dockAtoms(const std::filesystem::path& file) {
  std::vector<DockAtom> out;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.size() < 78 || (!line.starts_with("ATOM") && !line.starts_with("HETATM"))) continue;
    const auto number = [&](std::size_t from, std::size_t length) { return std::stod(line.substr(from, length)); };
    std::string type = line.substr(77);
    type.erase(type.find_last_not_of(" \r") + 1);
    out.push_back({{number(30, 8), number(38, 8), number(46, 8)}, number(69, 7), kDockTypes.at(type)});
  }
  return out;
}

// What AutoGrid adds to the plain Lennard-Jones energy of a probe: the lowest energy within 0.25 A of each distance, and
// desolvation, both of atoms within 8 A.
double dockExtras(const std::vector<DockAtom>& atoms, const DockType& probe, const Vec3& at) {
  double out = 0;
  for (const DockAtom& atom : atoms) {
    const double r = glm::distance(atom.at_A, at);
    if (r > 8.0) continue;
    const double best = 0.5 * (atom.type.distance_A + probe.distance_A);
    const double depth = std::sqrt(atom.type.depth_kcal_mol * probe.depth_kcal_mol);
    const auto energy = [&](double x) {
      const double s = std::pow(best / x, 6);
      return depth * (s * s - 2 * s);
    };
    const double smooth = r < best ? std::min(r + 0.25, best) : std::max(r - 0.25, best);
    out += 0.1662 * (energy(smooth) - energy(r));
    out += 0.1322 *
           ((atom.type.solvation + 0.01097 * std::abs(atom.charge_e)) * probe.volume_A3 +
            probe.solvation * atom.type.volume_A3) *
           std::exp(-r * r / (2 * 3.6 * 3.6));
  }
  return out;
}

// Compares the maps STEM.e.map, STEM.A.map, STEM.C.map and STEM.N.map with ours.
void compareMaps(const std::vector<DockAtom>& dock, const std::filesystem::path& folder, const std::string& stem) {
  std::vector<PairAtom> atoms;
  std::vector<Sphere> places;
  for (const DockAtom& a : dock) {
    atoms.push_back({a.at_A, float(0.5 * a.type.distance_A), float(a.type.depth_kcal_mol), float(a.charge_e)});
    places.push_back({a.at_A, 1.0});
  }
  const SphereGrid scene(std::move(places));
  const auto carbon = readMapFile(folder / (stem + ".C.map"));
  REQUIRE(carbon);
  for (const std::string name : {"e", "A", "C", "N"}) {
    const auto right = readMapFile(folder / (stem + "." + name + ".map"));
    REQUIRE(right);
    // AutoGrid cuts Lennard-Jones energies at 8 A and charges nowhere.
    PairModel model;
    model.cutoff_A = name == "e" ? 100.0 : 8.0;
    model.switch_from_A = model.cutoff_A - 0.001;
    std::vector<float> sizes;
    if (name != "e") sizes.push_back(float(0.5 * kDockTypes.at(name).distance_A));
    const auto maps = computeGridMaps(scene, atoms, right->box, sizes, model, 1);
    REQUIRE(maps);
    double sum = 0, worst = 0;
    int judged = 0;
    for (int k = 0; k < right->box.nodes[2]; ++k)
      for (int j = 0; j < right->box.nodes[1]; ++j)
        for (int i = 0; i < right->box.nodes[0]; ++i) {
          const std::size_t node = right->box.index(i, j, k);
          // A wall. AutoGrid takes energies from a table of steps of 0.01 A, which is too coarse there.
          if (carbon->values[node] > 0.0f) continue;
          double ours = 0.1406 * maps->electrostatic[node];
          if (name != "e") {
            const DockType& probe = kDockTypes.at(name);
            ours = 0.1662 * std::sqrt(probe.depth_kcal_mol) * maps->van_der_waals[0][node] +
                   dockExtras(dock, probe, right->box.node(i, j, k));
          }
          const double off = ours - right->values[node];
          sum += off * off;
          worst = std::max(worst, std::abs(off));
          ++judged;
        }
    CAPTURE(name);
    CAPTURE(worst);
    CHECK(judged >= 125);
    CHECK(std::sqrt(sum / judged) < 0.01);
    MESSAGE(name, ": rms ", std::sqrt(sum / judged), ", worst ", worst, " kcal/mol at ", judged, " points");
  }
}

const std::filesystem::path kDockFolder = "/usr/share/autogrid/Tests";

}  // namespace

TEST_CASE("a map of 2 x + e with e = +-0.5 at right angles to x: factor 2, rms 0.5, correlation 8 / sqrt(65)") {
  // x = -2, -2, 2, 2 and e = +, -, +, - are at right angles; a fifth node does not count.
  const std::vector<float> x{-2, -2, 2, 2, 9}, map{-3.5f, -4.5f, 4.5f, 3.5f, 1e5f};
  const MapAgreement found = mapAgreement(map, x, [](std::size_t node) { return node < 4; });
  CHECK(found.points == 4);
  CHECK(found.factor == doctest::Approx(2.0));
  CHECK(found.rms == doctest::Approx(0.5));
  CHECK(found.largest == doctest::Approx(0.5));
  // var(map) = 16 + 0.25, cov = 8, var(x) = 4.
  CHECK(found.correlation == doctest::Approx(8.0 / std::sqrt(4.0 * 16.25)));
  CHECK(mapAgreement(map, x, [](std::size_t) { return false; }).points == 0);
}

TEST_CASE(
    "the finished maps of autogrid-test and ours agree to 0.01 kcal/mol rms outside the walls: electrostatic, and "
    "Lennard-Jones of the types without hydrogen bonds") {
  if (!std::filesystem::exists(kDockFolder / "py_hsg1_sm.e.map")) {
    MESSAGE("did not run: Debian's package autogrid-test is not installed");
    return;
  }
  const std::vector<DockAtom> dock = dockAtoms(kDockFolder / "hsg1_sm.pdbqt");
  REQUIRE(dock.size() == 150);
  compareMaps(dock, kDockFolder, "py_hsg1_sm");
}

TEST_CASE("autogrid4's maps of a whole HIV protease (1HPV, 1849 atoms) and ours agree likewise") {
  const std::filesystem::path program = "/usr/bin/autogrid4";
  if (!std::filesystem::exists(program) || !std::filesystem::exists(kDockFolder / "x1hpv.pdbqt")) {
    MESSAGE("did not run: Debian's packages autogrid and autogrid-test are not installed");
    return;
  }
  const auto folder = TemporaryFolder::in(std::filesystem::temp_directory_path(), "moltact-autogrid-");
  REQUIRE(folder);
  std::filesystem::copy_file(kDockFolder / "x1hpv.pdbqt", folder->path() / "x1hpv.pdbqt");
  std::ofstream(folder->path() / "x.gpf")
      << "npts 20 20 20\ngridfld x.maps.fld\nspacing 0.5\nreceptor_types A C HD N OA SA\n"
         "ligand_types A C N\nreceptor x1hpv.pdbqt\ngridcenter -0.114 -1.692 0.058\n"
         "smooth 0.5\nmap x.A.map\nmap x.C.map\nmap x.N.map\nelecmap x.e.map\n"
         "dsolvmap x.d.map\ndielectric -0.1465\n";
  const std::string command =
      "cd '" + folder->path().string() + "' && " + program.string() + " -p x.gpf -l x.glg >/dev/null 2>&1";
  REQUIRE(std::system(command.c_str()) == 0);
  const std::vector<DockAtom> dock = dockAtoms(folder->path() / "x1hpv.pdbqt");
  REQUIRE(dock.size() == 1849);
  compareMaps(dock, folder->path(), "x");
}
