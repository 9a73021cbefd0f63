// The states of residues that pairAtoms assumes, or reads from the hydrogens and names of a file. Each state changes the
// net charge by a whole number.
#include <doctest/doctest.h>

#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "engine/structure/amber/pair_atoms.h"
#include "tests/structure/library.h"

using namespace moltact;

namespace {

using Kind = PairAtoms::Note::Kind;

struct Proton {
  const char *name, *residue;
  int number;
  Vec3 at_A;
};

// 1UBQ with hydrogens after the last atom of their residues, 1 A beside the atom that carries them.
std::string ubiquitinWith(const std::vector<Proton>& protons) {
  std::string text = test::libraryText("1ubq.pdb");
  for (const Proton& p : protons) {
    char id[16], line[96];
    std::snprintf(id, sizeof id, "%3s A%4d ", p.residue, p.number);
    std::snprintf(line, sizeof line, "ATOM   9999  %-4s%s   %8.3f%8.3f%8.3f  1.00  0.00           H\n", p.name, id,
                  p.at_A.x, p.at_A.y, p.at_A.z);
    // The records of the atoms, not those of the sequence.
    const std::size_t last = text.rfind(std::string(id) + "   ");
    REQUIRE(last != std::string::npos);
    text.insert(text.find('\n', last) + 1, line);
  }
  return text;
}

// "HIS 68: HID", with a star where the file states it.
std::vector<std::string> states(const Molecule& m, const PairAtoms& a, Kind kind) {
  std::vector<std::string> out;
  for (const auto& n : a.notes)
    if (n.kind == kind)
      out.push_back(std::to_string(m.residues[n.residue].number) + ' ' + n.template_name + (n.stated ? "*" : ""));
  return out;
}

std::map<std::string, int> counted(const PairAtoms& a, Kind kind) {
  std::map<std::string, int> out;
  for (const auto& n : a.notes)
    if (n.kind == kind) ++out[n.template_name + (n.stated ? "*" : "")];
  return out;
}

}  // namespace

TEST_CASE("1UBQ without hydrogens: 5 ASP, 6 GLU and 7 LYS assumed charged, HIS 68 assumed, ends NMET and CGLY") {
  const Molecule m = test::libraryMolecule("1ubq.pdb");
  const PairAtoms a = pairAtoms(m);
  CHECK(counted(a, Kind::SideChain) == std::map<std::string, int>{{"ASP", 5}, {"GLU", 6}, {"LYS", 7}});
  REQUIRE(states(m, a, Kind::Histidine).size() == 1);
  CHECK(states(m, a, Kind::Histidine)[0].back() != '*');
  CHECK(states(m, a, Kind::Terminus) == std::vector<std::string>{"1 NMET", "76 CGLY"});
  CHECK(counted(a, Kind::InnerEnd).empty());
  CHECK(counted(a, Kind::Cysteine).empty());
}

TEST_CASE(
    "hydrogens in the file state the protons of 1UBQ: ASH 21 and HIP 68 add 1 e each, LYN 48 takes 1 e, ASP 52 with "
    "another hydrogen stays charged") {
  const Proton ash{"HD2", "ASP", 21, {32.6, 21.2, 7.4}};
  const Proton hd1{"HD1", "HIS", 68, {24.7, 37.0, 17.9}}, he2{"HE2", "HIS", 68, {21.1, 35.3, 16.8}};
  const Proton hz1{"HZ1", "LYS", 48, {16.8, 24.0, 20.4}}, hz2{"HZ2", "LYS", 48, {17.4, 25.6, 20.5}};
  const auto net = [](const std::vector<Proton>& protons) {
    return pairAtoms(test::moleculeOf(ubiquitinWith(protons))).net_charge_e;
  };
  CHECK(net({}) == doctest::Approx(0.0).epsilon(0.001));
  CHECK(net({ash}) == doctest::Approx(1.0).epsilon(0.001));
  CHECK(net({hd1, he2}) == doctest::Approx(1.0).epsilon(0.001));
  CHECK(net({hz1, hz2}) == doctest::Approx(-1.0).epsilon(0.001));
  CHECK(net({hd1}) == doctest::Approx(0.0).epsilon(0.001));
  const Molecule m = test::moleculeOf(ubiquitinWith({ash, hd1, he2, hz1, hz2, {"H", "ASP", 52, {0.0, 0.0, 0.0}}}));
  const PairAtoms a = pairAtoms(m);
  CHECK(a.net_charge_e == doctest::Approx(1.0).epsilon(0.001));
  CHECK(states(m, a, Kind::Histidine) == std::vector<std::string>{"68 HIP*"});
  CHECK(counted(a, Kind::SideChain) ==
        std::map<std::string, int>{{"ASH*", 1}, {"ASP", 3}, {"ASP*", 1}, {"GLU", 6}, {"LYN*", 1}, {"LYS", 6}});
}

TEST_CASE("a histidine with only HD1 in the file is HID, with only HE2 HIE, whatever is near") {
  for (const char* name : {"HD1", "HE2"}) {
    const Molecule m = test::moleculeOf(ubiquitinWith({{name, "HIS", 68, {24.7, 37.0, 17.9}}}));
    CHECK(states(m, pairAtoms(m), Kind::Histidine) ==
          std::vector<std::string>{name == std::string("HD1") ? "68 HID*" : "68 HIE*"});
  }
}

TEST_CASE("without OXT the last residue of 1UBQ is as within a chain and the net charge is 1 e instead of 0") {
  std::string text = test::libraryText("1ubq.pdb");
  const std::size_t oxt = text.find("OXT GLY"), line = text.rfind('\n', oxt);
  text.erase(line, text.find('\n', oxt) - line);
  const Molecule m = test::moleculeOf(text);
  const PairAtoms a = pairAtoms(m);
  CHECK(a.net_charge_e == doctest::Approx(1.0).epsilon(0.001));
  CHECK(states(m, a, Kind::InnerEnd) == std::vector<std::string>{"76 GLY"});
  CHECK(states(m, a, Kind::Terminus) == std::vector<std::string>{"1 NMET"});
}

TEST_CASE("the eight cysteines of lysozyme (1HEL) are CYX and its net charge is 8 e") {
  const PairAtoms a = pairAtoms(test::libraryMolecule("1hel.pdb"));
  CHECK(counted(a, Kind::Cysteine) == std::map<std::string, int>{{"CYX", 8}});
  CHECK(a.net_charge_e == doctest::Approx(8.0).epsilon(0.001));
}

TEST_CASE(
    "in the zinc fingers of 1A1F six cysteines are CYM; the DNA's strands begin at a 5' and end at a 3' template") {
  const Molecule m = test::libraryMolecule("1a1f.pdb");
  const PairAtoms a = pairAtoms(m);
  CHECK(counted(a, Kind::Cysteine) == std::map<std::string, int>{{"CYM", 6}});
  std::map<char, int> ends;
  for (const auto& n : a.notes)
    if (n.kind == Kind::Terminus && m.residues[n.residue].kind == ResidueKind::Nucleotide) ++ends[n.template_name[2]];
  CHECK(ends == std::map<char, int>{{'3', 2}, {'5', 2}});
}

TEST_CASE(
    "B-DNA begins at DC5 and ends at DG3; without its first nucleotide the strand begins with a phosphate, as within a "
    "chain, and lacks the -0.3079 e of a 5' end") {
  const std::string text = test::libraryText("b-dna.pdb");
  const Molecule whole = test::moleculeOf(text);
  const PairAtoms a = pairAtoms(whole);
  CHECK(states(whole, a, Kind::Terminus) == std::vector<std::string>{"1 DC5", "12 DG3", "1 DC5", "12 DG3"});
  CHECK(counted(a, Kind::InnerEnd).empty());
  std::string shorter;
  for (std::size_t at = 0; at < text.size();) {
    const std::string line = text.substr(at, text.find('\n', at) + 1 - at);
    if (line.find("DC A   1 ") == std::string::npos) shorter += line;
    at += line.size();
  }
  const Molecule m = test::moleculeOf(shorter);
  const PairAtoms b = pairAtoms(m);
  CHECK(states(m, b, Kind::Terminus) == std::vector<std::string>{"12 DG3", "1 DC5", "12 DG3"});
  CHECK(states(m, b, Kind::InnerEnd) == std::vector<std::string>{"2 DG"});
  CHECK(b.net_charge_e - a.net_charge_e == doctest::Approx(0.3079).epsilon(0.001));
}

TEST_CASE(
    "names state protons of a file without hydrogens: HIP and GLH in 1UBQ, CYX in 1HEL; the charges of a PQR file need "
    "no state") {
  const std::string text = test::libraryText("1ubq.pdb");
  std::string named = text;
  const auto rename = [](std::string& in, const std::string& from, const std::string& to) {
    for (std::size_t at = in.find(from + " "); at != std::string::npos; at = in.find(from + " ", at + 1))
      in.replace(at, 3, to);
  };
  rename(named, "HIS A  68", "HIP");
  rename(named, "GLU A  16", "GLH");
  const Molecule m = test::moleculeOf(named);
  const PairAtoms a = pairAtoms(m);
  CHECK(states(m, a, Kind::Histidine) == std::vector<std::string>{"68 HIP*"});
  CHECK(counted(a, Kind::SideChain)["GLH*"] == 1);
  CHECK(a.net_charge_e == doctest::Approx(2.0).epsilon(0.001));

  std::string lysozyme = test::libraryText("1hel.pdb");
  rename(lysozyme, "CYS A", "CYX");
  CHECK(counted(pairAtoms(test::moleculeOf(lysozyme)), Kind::Cysteine) == std::map<std::string, int>{{"CYX*", 8}});

  const PairAtoms pqr = pairAtoms(test::moleculeOf(
      "ATOM 1 N ASP A 1 0 0 0 -0.5 1.8\nATOM 2 CA ASP A 1 1.5 0 0 0.5 1.8\nATOM 3 N HIS A 2 3 0 0 0.5 1.8\n", "x.pqr"));
  CHECK(pqr.file_charges);
  for (const auto& n : pqr.notes) {
    CHECK(n.kind != Kind::Histidine);
    CHECK(n.kind != Kind::SideChain);
    CHECK(n.kind != Kind::Terminus);
    CHECK(n.kind != Kind::InnerEnd);
  }
}
