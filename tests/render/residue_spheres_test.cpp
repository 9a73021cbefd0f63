// A molecule of very many atoms is drawn by residues. The places of their spheres are known in closed form; the
// expected picture is that of a molecule with these spheres as atoms.
#include "engine/render/residue_spheres.h"

#include <cmath>
#include <random>

#include "engine/molecule/catalogue.h"
#include "engine/render/molecule_model.h"
#include "tests/render/stage.h"

using namespace moltact;
using namespace moltact::test;

namespace {

AtomList list(std::vector<std::uint32_t> atoms) {
  return std::make_shared<const std::vector<std::uint32_t>>(std::move(atoms));
}

std::shared_ptr<const Molecule> haemoglobin() {
  static const auto read = std::make_shared<const Molecule>(*openMolecule("2hhb", {}));
  return read;
}

// Residues that are not amino acids are coloured by element; a sphere has the mean colour.
AtomList others(const Molecule& m) {
  std::vector<std::uint32_t> out;
  for (std::uint32_t a = 0; a < m.atoms.size(); ++a)
    if (!colouredChain(m, m.atoms[a])) out.push_back(a);
  return list(std::move(out));
}

// The residue spheres as atoms of their own, each in its residue.
std::shared_ptr<const Molecule> coarse(const Molecule& fine) {
  const ResidueSpheres spheres = residueSpheres(fine);
  Molecule out = fine;
  std::vector<PlacedAtom> atoms;
  for (std::size_t k = 0; k < spheres.spheres.size(); ++k) {
    PlacedAtom a = fine.at(spheres.first_atom[k]);
    a.position.A = spheres.spheres[k].centre_A;
    a.radius_A = spheres.spheres[k].radius_A;
    atoms.push_back(a);
  }
  out.setAtoms(atoms);
  return std::make_shared<const Molecule>(std::move(out));
}

ViewScene byResidue() {
  ViewScene scene;
  scene.molecule = haemoglobin();
  scene.camera.fit(*scene.molecule, 1.5);
  scene.shown = {ViewPart::Atoms};
  scene.colour_by = ColourBy::Chain;
  scene.max_single_atoms = 1000;
  return scene;
}

}  // namespace

TEST_CASE(
    "a residue's sphere lies in the middle of its atoms with their second moment: of one atom it is the atom, of two "
    "of "
    "1.7 A that lie 2 A apart it has the radius sqrt(1.7^2 + 5/3)") {
  Molecule m;
  m.chains = {Chain{}};
  m.residues = std::vector<Residue>(2);
  std::vector<PlacedAtom> atoms;
  for (const auto& [x, residue] : {std::pair{0.0, 0u}, {2.0, 0u}, {9.0, 1u}}) {
    PlacedAtom a = atom(Vec3(x, 1, 2), 1.7, 6);
    a.residue = residue;
    atoms.push_back(a);
  }
  m.setAtoms(atoms);
  const ResidueSpheres spheres = residueSpheres(m);
  REQUIRE(spheres.spheres.size() == 2);
  CHECK(spheres.first_atom == std::vector<std::uint32_t>{0, 2, 3});
  CHECK(spheres.spheres[0].centre_A == Vec3(1, 1, 2));
  CHECK(spheres.spheres[0].radius_A == doctest::Approx(std::sqrt(1.7 * 1.7 + 5.0 / 3.0)));
  CHECK(spheres.spheres[1].centre_A == Vec3(9, 1, 2));
  CHECK(spheres.spheres[1].radius_A == doctest::Approx(1.7));
  CHECK(spheres.beyond_A == doctest::Approx(1.0 + 1.7 - std::sqrt(1.7 * 1.7 + 5.0 / 3.0)));
}

TEST_CASE(
    "every atom of haemoglobin has one sphere, that of its residue; atoms of no residue go by eights at most, one "
    "residue "
    "of 100 atoms by 32, and none lies farther than 12 A from the first") {
  const Molecule& m = *haemoglobin();
  const ResidueSpheres spheres = residueSpheres(m);
  REQUIRE(spheres.first_atom.size() == spheres.spheres.size() + 1);
  CHECK(spheres.first_atom.front() == 0);
  CHECK(spheres.first_atom.back() == m.atoms.size());
  std::size_t in_parts = 0;  // haems have 43 atoms
  for (std::size_t k = 0; k < spheres.spheres.size(); ++k) {
    const std::uint32_t first = spheres.first_atom[k];
    CHECK(spheres.first_atom[k + 1] - first <= 32);
    for (std::uint32_t a = first; a < spheres.first_atom[k + 1]; ++a) {
      CHECK(m.atoms[a].residue == m.atoms[first].residue);
      CHECK(glm::distance(m.spheres[a].centre_A, m.spheres[first].centre_A) <= 12.0);
      CHECK(glm::distance(m.spheres[a].centre_A, spheres.spheres[k].centre_A) + m.spheres[a].radius_A <=
            spheres.spheres[k].radius_A + spheres.beyond_A + 1e-9);
    }
    in_parts += k > 0 && m.atoms[first].residue == m.atoms[spheres.first_atom[k - 1]].residue;
  }
  CHECK(spheres.spheres.size() == m.residues.size() + in_parts);
  for (const std::uint32_t residue : {kNoResidue, 0u}) {
    Molecule row;
    row.residues = std::vector<Residue>(1);
    std::vector<PlacedAtom> atoms;
    for (int k = 0; k < 100; ++k) {
      PlacedAtom a = atom(Vec3(0.1 * k, 0, 0), 1.5, 6);
      a.residue = residue;
      atoms.push_back(a);
    }
    row.setAtoms(atoms);
    const std::size_t most = residue == kNoResidue ? 8 : 32;
    CHECK(residueSpheres(row).spheres.size() == (100 + most - 1) / most);
    for (int k = 0; k < 100; ++k) atoms[std::size_t(k)].position.A.x = 20.0 * k;
    row.setAtoms(atoms);
    CHECK(residueSpheres(row).spheres.size() == 100);
  }
}

TEST_CASE(
    "above the number of atoms that a scene names, its picture is that of a molecule whose atoms are the residues' "
    "spheres; "
    "at that number each atom is drawn") {
  ViewScene scene = byResidue();
  scene.theme.fade = 0.0f;  // which depends on the extent of the atoms
  scene.look.hidden = others(*scene.molecule);
  const Picture coarser = drawn(scene, 300, 200);
  CHECK(renderer().count().atoms == residueSpheres(*scene.molecule).spheres.size());
  CHECK(renderer().count().atoms < 700);
  ViewScene oracle = scene;
  oracle.molecule = coarse(*scene.molecule);
  oracle.max_single_atoms = kMaxSingleAtoms;
  oracle.look.hidden = others(*oracle.molecule);
  CHECK(compare(coarser, drawn(oracle, 300, 200), 3).pixels < 20);
  scene.max_single_atoms = scene.molecule->atoms.size();
  CHECK(compare(coarser, drawn(scene, 300, 200), 3).pixels > 3000);
  CHECK(renderer().count().atoms == scene.molecule->atoms.size());
}

TEST_CASE("a molecule drawn by its residues looks the same in every style, also when the probe's radius changes") {
  ViewScene scene = byResidue();
  const Picture spheres = drawn(scene, 300, 200);
  for (const DrawStyleInfo& style : drawStyles()) {
    CAPTURE(std::string(style.name));
    scene.look.styles = {{style.style, nullptr, 1.0f}};
    CHECK(compare(spheres, drawn(scene, 300, 200), 0).pixels == 0);
    scene.probe_A += 0.1;
    CHECK(compare(spheres, drawn(scene, 300, 200), 0).pixels == 0);
  }
}

TEST_CASE(
    "drawn by residues, a residue is gone once all its atoms are hidden and not before, and shows a mark on any of "
    "them") {
  ViewScene scene = byResidue();
  const Picture all = drawn(scene, 300, 200);
  // The residue nearest to the eye.
  const ResidueSpheres spheres = residueSpheres(*scene.molecule);
  std::size_t nearest = 0;
  for (std::size_t k = 0; k < spheres.spheres.size(); ++k)
    if (scene.camera.toView({spheres.spheres[k].centre_A}).z >
        scene.camera.toView({spheres.spheres[nearest].centre_A}).z)
      nearest = k;
  std::vector<std::uint32_t> atoms;
  for (std::uint32_t a = spheres.first_atom[nearest]; a < spheres.first_atom[nearest + 1]; ++a) atoms.push_back(a);
  REQUIRE(atoms.size() > 2);
  scene.look.hidden = list(std::vector(atoms.begin(), atoms.end() - 1));
  CHECK(compare(all, drawn(scene, 300, 200), 0).pixels == 0);
  scene.look.hidden = list(atoms);
  CHECK(compare(all, drawn(scene, 300, 200), 12).pixels > 20);
  scene.look.hidden = nullptr;
  scene.shown = {ViewPart::Atoms, ViewPart::Target};
  scene.highlighted = {atoms[1]};
  const Picture marked = drawn(scene, 300, 200);
  CHECK(compare(all, marked, 30).pixels > 20);
}

TEST_CASE("the atoms nearest to a place are the same whether a molecule is drawn by its atoms or by its residues") {
  const unsigned seed = 20;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const MoleculeModel fine(haemoglobin()), coarser(haemoglobin(), 0);
  CHECK_FALSE(fine.byResidue());
  REQUIRE(coarser.byResidue());
  std::size_t found = 0;
  for (int k = 0; k < 300; ++k) {
    Vec3 place;
    for (int i = 0; i < 3; ++i)
      place[i] = fine.middle_A[i] + std::uniform_real_distribution(-fine.reach_A, fine.reach_A)(random);
    const auto expected = nearestAtoms(fine, {place}, 1.4, 3.0, 12);
    CHECK(nearestAtoms(coarser, {place}, 1.4, 3.0, 12) == expected);
    found += expected.size();
  }
  CHECK(found > 500);
  for (std::uint32_t a = 0; a < fine.atoms(); ++a) {
    const std::uint32_t sphere = coarser.sphereOf(a);
    CHECK((coarser.first_atom[sphere] <= a && a < coarser.first_atom[sphere + 1]));
  }
}

TEST_CASE("near a probe the atoms themselves are drawn beside the residues' spheres") {
  ViewScene scene = byResidue();
  scene.look.spheres_near_A = 0.0;
  scene.hip = PointA{haemoglobin()->spheres[500].centre_A + scene.camera.back() * 4.0};
  scene.camera.fit(*scene.hip, 14.0, 1.5);
  const Picture without = drawn(scene, 300, 200);
  scene.look.spheres_near_A = 6.0;
  CHECK(compare(without, drawn(scene, 300, 200), 12).pixels > 100);
  CHECK_FALSE(renderer().count().atoms_redrawn);
}

TEST_CASE("drawing by residues is announced from the first atom above the limit") {
  CHECK(residueSpheresNotice(kMaxSingleAtoms).empty());
  const std::string reported = residueSpheresNotice(16'289'280);
  CHECK(reported.find("16289280") != std::string::npos);
  CHECK(reported.find("one sphere per residue") != std::string::npos);
}
