// Bonds, hydrogen bonds and the backbone, against formulas and a plain count of near atoms.
#include "engine/structure/bonds.h"

#include <map>
#include <set>

#include "engine/structure/backbone.h"
#include "engine/structure/hydrogen_bonds.h"
#include "engine/structure/secondary_structure.h"
#include "tests/structure/library.h"

using namespace moltact;
using namespace moltact::test;

namespace {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

Pairs pairsOf(const std::vector<Bond>& bonds) {
  Pairs out;
  for (const Bond& b : bonds) {
    CHECK(b.first < b.second);
    CHECK(out.emplace(b.first, b.second).second);
  }
  return out;
}

std::string nameOf(const Molecule& m, std::uint32_t atom) {
  const Residue& r = m.residues[m.atoms[atom].residue];
  return r.name.string() + std::to_string(r.number) + m.chains[r.chain].name.string() + "." +
         std::string(m.atoms[atom].nameText());
}

std::string line(const char* name, const char* residue, int number, double x, double y, const char* element) {
  char out[96];
  std::snprintf(out, sizeof out, "ATOM  %5d  %-3s %3s A%4d    %8.3f%8.3f%8.3f  1.00  0.00          %2s\n", 1, name,
                residue, number, x, y, 0.0, element);
  return out;
}

}  // namespace

TEST_CASE("in ubiquitin and lysozyme, refined well, the bonds are all pairs of heavy atoms nearer than 2.13 A") {
  for (const char* file : {"1ubq.pdb", "1hel.pdb", "1hpv.pdb"}) {
    CAPTURE(file);
    const Molecule m = libraryMolecule(file);
    Pairs near;
    for (std::uint32_t i = 0; i < m.atoms.size(); ++i)
      for (std::uint32_t j = i + 1; j < m.atoms.size(); ++j)
        if (glm::distance(m.spheres[i].centre_A, m.spheres[j].centre_A) < 2.13) near.emplace(i, j);
    CHECK(pairsOf(findBonds(m)) == near);
  }
}

TEST_CASE("lysozyme has its four disulphides and 128 peptide bonds") {
  const Molecule m = libraryMolecule("1hel.pdb");
  std::set<std::string> disulphides;
  int peptides = 0;
  for (const Bond& b : findBonds(m)) {
    const Atom &x = m.atoms[b.first], &y = m.atoms[b.second];
    if (x.residue == y.residue) continue;
    if (x.nameText() == "SG")
      disulphides.insert(std::to_string(m.residues[x.residue].number) + "-" +
                         std::to_string(m.residues[y.residue].number));
    peptides += x.nameText() == "C" && y.nameText() == "N";
  }
  CHECK(disulphides == std::set<std::string>{"6-127", "30-115", "64-80", "76-94"});
  CHECK(peptides == 128);
}

TEST_CASE("benzene has twelve bonds, water two, argon's pair none") {
  const Molecule benzene = libraryMolecule("benzene.pdb");
  CHECK(pairsOf(findBonds(benzene)) ==
        Pairs{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {0, 5}, {0, 6}, {1, 7}, {2, 8}, {3, 9}, {4, 10}, {5, 11}});
  CHECK(pairsOf(findBonds(libraryMolecule("water.pdb"))) == Pairs{{0, 1}, {0, 2}});
  CHECK(findBonds(libraryMolecule("argon-pair.pdb")).empty());
}

TEST_CASE("two residues that clash at 1.5 A are not bonded, nor do their hydrogens bind twice") {
  const Molecule m = moleculeOf(line("CB", "ALA", 1, 0, 0, "C") + line("HB1", "ALA", 1, 0, 1.1, "H") +
                                line("CB", "ALA", 7, 1.5, 0, "C") + line("HB1", "ALA", 7, 1.3, 1.0, "H"));
  CHECK(pairsOf(findBonds(m)) == Pairs{{0, 1}, {2, 3}});
}

TEST_CASE("the iron of a haem is bound by its four nitrogens and by His 87, as coordination") {
  const Molecule m = libraryMolecule("2hhb.pdb");
  std::set<std::string> alpha;
  for (const Bond& b : findBonds(m)) {
    const bool iron = m.atoms[b.first].atomic_number == 26 || m.atoms[b.second].atomic_number == 26;
    CHECK((b.order == BondOrder::Coordination) == iron);
    if (!iron) continue;
    const std::uint32_t other = m.atoms[b.first].atomic_number == 26 ? b.second : b.first;
    const std::uint32_t fe = other == b.first ? b.second : b.first;
    if (m.chains[m.residues[m.atoms[fe].residue].chain].name == "A") alpha.insert(nameOf(m, other));
  }
  CHECK(alpha == std::set<std::string>{"HEM1A.N A", "HEM1A.N B", "HEM1A.N C", "HEM1A.N D", "HIS87A.NE2"});
}

TEST_CASE(
    "formulas have as many double bonds as the molecules: alanine 1, phenylalanine 4, adenine 4, guanine 4, thymine "
    "4") {
  const auto doubles = [](const char* residue) {
    int out = 0;
    for (const NamedBond& b : formulaBonds(residue)) out += b.order == BondOrder::Double;
    return out;
  };
  CHECK(doubles("ALA") == 1);
  CHECK(doubles("PHE") == 4);
  CHECK(doubles("TRP") == 5);
  CHECK(doubles("HIS") == 3);
  CHECK(doubles("ARG") == 2);
  // One of each is the phosphate's.
  CHECK(doubles("DA") == 5);
  CHECK(doubles("DG") == 5);
  CHECK(doubles("DC") == 4);
  CHECK(doubles("DT") == 4);
  CHECK(formulaBonds("HEM").empty());
}

TEST_CASE("no atom of a formula has more bonds than its valence: carbon and phosphorus 4 or 5, nitrogen 3, oxygen 2") {
  for (const char* residue :
       {"ALA", "ARG", "ASN", "ASP", "CYS", "GLN", "GLU", "GLY", "HIS", "ILE", "LEU", "LYS", "MET", "PHE",
        "PRO", "SER", "THR", "TRP", "TYR", "VAL", "A",   "C",   "G",   "U",   "DA",  "DC",  "DG",  "DT"}) {
    std::map<std::string_view, int> valence;
    for (const NamedBond& b : formulaBonds(residue))
      for (const std::string_view atom : {b.first, b.second}) valence[atom] += b.order == BondOrder::Double ? 2 : 1;
    for (const auto& [atom, bonds] : valence) {
      CAPTURE(residue);
      CAPTURE(atom);
      const int most = atom[0] == 'P'                     ? 6
                       : atom[0] == 'N'                   ? (residue == std::string("ARG") ? 4 : 3)
                       : atom[0] == 'O' || atom[0] == 'S' ? 2
                                                          : 4;
      CHECK(bonds <= most);
    }
  }
}

TEST_CASE("an ideal helix of 20 alanines has 16 hydrogen bonds, each from N to the O four residues before") {
  const Molecule m = libraryMolecule("alpha-helix.pdb");
  const BondTable bonds(m.atoms.size(), findBonds(m));
  int forward = 0;
  for (const HydrogenBond& h : findHydrogenBonds(m, bonds)) {
    CHECK(m.atoms[h.donor].nameText() == "N");
    CHECK(m.atoms[h.acceptor].nameText() == "O");
    forward += m.residues[m.atoms[h.donor].residue].number - m.residues[m.atoms[h.acceptor].residue].number == 4;
  }
  CHECK(forward == 16);
}

TEST_CASE("a molecule whose atoms are moved keeps its bonds and helices, and shares all but its coordinates") {
  const Molecule m = libraryMolecule("alpha-helix.pdb");
  std::vector<Sphere> apart = m.spheres.copy();
  for (Sphere& b : apart) b.centre_A *= 3.0;  // by distance no bond would be found
  const Molecule moved = m.movedTo(apart), again = moved.movedTo(m.spheres);
  CHECK(moved.sameTopology(m));
  CHECK(moved.residues.sharesWith(m.residues));
  CHECK(moved.spheresAsRead().sharesWith(m.spheres));
  CHECK(again.spheresAsRead().sharesWith(m.spheres));
  CHECK(moved.spheres[5].centre_A == 3.0 * m.spheres[5].centre_A);
  CHECK(!findBonds(m).empty());
  CHECK(findBonds(moved) == findBonds(m));
  CHECK(secondaryStructure(moved).elements == secondaryStructure(m).elements);
  CHECK(secondaryStructure(m).elements.size() == 1);
  CHECK_FALSE(libraryMolecule("alpha-helix.pdb").sameTopology(m));
}

TEST_CASE("B-DNA of 8 G-C and 4 A-T pairs has their 32 hydrogen bonds between its strands") {
  const Molecule m = libraryMolecule("b-dna.pdb");
  const BondTable bonds(m.atoms.size(), findBonds(m));
  std::set<std::string> expected, found;
  const std::string sequence = "CGCGAATTCGCG";
  for (int i = 1; i <= 12; ++i)
    for (const bool forth : {true, false}) {
      const int j = 13 - i;
      const char base = sequence[std::size_t(i - 1)];
      const std::string here = std::string("D") + base + std::to_string(i) + (forth ? "A." : "B.");
      const char* partner = base == 'G' ? "C" : "T";
      const std::string there = std::string("D") + partner + std::to_string(j) + (forth ? "B." : "A.");
      if (base == 'G')
        expected.insert({here + "N1>" + there + "N3", here + "N2>" + there + "O2", there + "N4>" + here + "O6"});
      if (base == 'A') expected.insert({here + "N6>" + there + "O4", there + "N3>" + here + "N1"});
    }
  REQUIRE(expected.size() == 32);
  for (const HydrogenBond& h : findHydrogenBonds(m, bonds)) {
    const std::string bond = nameOf(m, h.donor) + ">" + nameOf(m, h.acceptor);
    const Residue &d = m.residues[m.atoms[h.donor].residue], &a = m.residues[m.atoms[h.acceptor].residue];
    if (d.chain != a.chain && d.number + a.number == 13) found.insert(bond);
  }
  CHECK(found == expected);
}

TEST_CASE("ubiquitin's backbone is one stretch of 76, haemoglobin's four of 141 and 146, B-DNA's two of 12") {
  const auto lengths = [](const auto& stretches) {
    std::vector<std::size_t> out;
    for (const auto& s : stretches) out.push_back(s.size());
    return out;
  };
  const Molecule ubiquitin = libraryMolecule("1ubq.pdb");
  CHECK(lengths(proteinBackbone(ubiquitin)) == std::vector<std::size_t>{76});
  const auto whole = proteinBackbone(ubiquitin);
  for (const AminoAcidAtoms& a : whole[0]) CHECK(a.whole());
  CHECK(nucleicBackbone(ubiquitin).empty());
  CHECK(lengths(proteinBackbone(libraryMolecule("2hhb.pdb"))) == std::vector<std::size_t>{141, 146, 141, 146});
  const Molecule dna = libraryMolecule("b-dna.pdb");
  CHECK(proteinBackbone(dna).empty());
  const auto strands = nucleicBackbone(dna);
  CHECK(lengths(strands) == std::vector<std::size_t>{12, 12});
  CHECK(strands[0][0].p == kNoAtom);
  CHECK(dna.atoms[strands[0][0].guide()].nameText() == "O5'");
  for (std::size_t i = 0; i < 12; ++i) {
    // The ends of two bases that are paired lie as far apart as their middle hydrogen bond is long.
    const auto at = [&](std::uint32_t atom) { return dna.spheres[atom].centre_A; };
    CHECK(glm::distance(at(strands[0][i].base), at(strands[1][11 - i].base)) == doctest::Approx(2.9).epsilon(0.1));
  }
}

TEST_CASE("a backbone ends where three residues are missing, and continues where only CA are there") {
  std::string missing, only_ca;
  std::istringstream lines(libraryText("1ubq.pdb"));
  for (std::string text; std::getline(lines, text);) {
    if (!text.starts_with("ATOM")) continue;
    const int number = std::stoi(text.substr(22, 4));
    if (number < 30 || number > 32) missing += text + "\n";
    if (text.substr(12, 4) == " CA ") only_ca += text + "\n";
  }
  const auto parts = proteinBackbone(moleculeOf(missing + "END\n"));
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].size() == 29);
  CHECK(parts[1].size() == 44);
  const auto backbone = proteinBackbone(moleculeOf(only_ca + "END\n"));
  REQUIRE(backbone.size() == 1);
  CHECK(backbone[0].size() == 76);
}
