// Small files that would need much memory: an excess is reported before it is allocated. The memory of a molecule is
// measured by counting every allocation.
#include <doctest/doctest.h>
#include <malloc.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>

#include "engine/molecule/mmcif_operators.h"
#include "engine/molecule/text_source.h"
#include "tests/molecule/files.h"

using namespace moltact;
using namespace moltact::test;

namespace {

std::atomic<std::size_t> held{0}, most_held{0};

void* taken(std::size_t bytes) {
  void* const out = std::malloc(bytes);
  if (!out) throw std::bad_alloc();
  const std::size_t now = held += malloc_usable_size(out);
  if (now > most_held) most_held = now;
  return out;
}

}  // namespace

void* operator new(std::size_t bytes) { return taken(bytes); }
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  try {
    return taken(bytes);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* at) noexcept {
  if (at) held -= malloc_usable_size(at);
  std::free(at);
}
void operator delete(void* at, std::size_t) noexcept { operator delete(at); }

namespace {

/// The most that reading took beyond what is there before (unit: byte).
std::size_t tookToRead(const std::string& bytes, const std::string& name, std::size_t atoms,
                       const ReadOptions& options = {}) {
  const Scratch scratch;
  const auto file = scratch.write(name, bytes);
  const std::size_t before = held;
  most_held = before;
  const auto molecule = readMolecule(file, options);
  const std::size_t took = most_held - before;
  if (!molecule) FAIL(molecule.problem().text());
  CHECK(molecule->atoms.size() == atoms);
  return took;
}

std::string repeated(const std::string& line, std::size_t times) {
  std::string out;
  out.reserve(line.size() * times);
  for (std::size_t k = 0; k < times; ++k) out += line;
  return out;
}

const std::string kCifHead =
    "data_X\nloop_\n_atom_site.group_PDB\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_comp_id\n_"
    "atom_site.label_asym_id\n"
    "_atom_site.auth_seq_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.occupancy\n";

/// Three chains of `residues` residues of 8 atoms, and turns and shifts in two brackets that copy them.
std::string capsid(int residues, int first_bracket, int second_bracket) {
  std::string out = kCifHead;
  char line[160];
  for (const char chain : {'A', 'B', 'C'})
    for (int r = 1; r <= residues; ++r)
      for (const char* name : {"N", "CA", "C", "O", "CB", "CG", "CD1", "CD2"}) {
        std::snprintf(line, sizeof line, "ATOM %c %s LEU %c %d %.3f %.3f %.3f 1.0\n", name[0], name, chain, r,
                      800 + 0.9 * r, chain - 66.0, 1.3 * name[0] + name[1]);
        out += line;
      }
  out +=
      "loop_\n_pdbx_struct_assembly_gen.assembly_id\n_pdbx_struct_assembly_gen.oper_expression\n_pdbx_struct_assembly_"
      "gen.asym_id_list\n1 '(1-" +
      std::to_string(first_bracket) + ")(" + std::to_string(first_bracket + 1) + '-' +
      std::to_string(first_bracket + second_bracket) + ")' A,B,C\nloop_\n_pdbx_struct_oper_list.id\n";
  for (int i = 1; i <= 3; ++i)
    for (int j = 1; j <= 3; ++j)
      out += "_pdbx_struct_oper_list.matrix[" + std::to_string(i) + "][" + std::to_string(j) + "]\n";
  for (int i = 1; i <= 3; ++i) out += "_pdbx_struct_oper_list.vector[" + std::to_string(i) + "]\n";
  for (int k = 1; k <= first_bracket + second_bracket; ++k) {
    const double a = k <= first_bracket ? 6.283185307 * k / first_bracket : 0.0;
    std::snprintf(line, sizeof line, "%d %.9f %.9f 0 %.9f %.9f 0 0 0 1 0 0 %d\n", k, std::cos(a), -std::sin(a),
                  std::sin(a), std::cos(a), k <= first_bracket ? 0 : 1000 * k);
    out += line;
  }
  return out;
}

}  // namespace

TEST_CASE(
    "reading 300 000 atoms takes at most 120 bytes an atom in every format, packed or not, where all are one residue "
    "and where each is a residue and a chain of its own") {
  constexpr std::size_t kAtoms = 300'000, kBuffers = std::size_t{2} << 20;
  std::string pdb, cif = kCifHead;
  for (std::size_t k = 0; k < kAtoms; ++k) {
    const int residue = int(k / 8 % 9999) + 1;
    pdb += atomLine(k % 8 ? " CA" : " N", ' ', "LEU", char('A' + k / 80'000), residue, ' ', 0.001 * double(k), 1, 2, 1,
                    "C");
    cif += "ATOM C C" + std::to_string(k % 8) + " LEU " + char('A' + k / 80'000) + ' ' + std::to_string(residue) +
           " 1.234 5.678 9.012 1.0\n";
  }
  // Each atom a residue and a chain of its own, and one of mmCIF's label chains too.
  std::string own_pdb, own_cif = kCifHead;
  for (std::size_t k = 0; k < kAtoms; ++k) {
    own_pdb += atomLine(" CA", ' ', "LEU", char('A' + k % 26), int(k % 9999) + 1, ' ', 0.001 * double(k), 1, 2, 1, "C");
    own_cif += "ATOM C CA LEU " + std::to_string(100'000 + k) + ' ' + std::to_string(k % 9999 + 1) +
               " 1.234 5.678 9.012 1.0\n";
  }
  const std::string xyzr = repeated("12.345 -6.789 0.123 1.70\n", kAtoms),
                    one = repeated(atomLine(" CA", 'A', "LEU", 'A', 1, ' ', 0, 1, 2, 1, "C"), kAtoms);
  const std::pair<std::string, const std::string*> files[] = {{"x.pdb", &pdb},       {"x.cif", &cif},
                                                              {"x.xyzr", &xyzr},     {"one.pdb", &one},
                                                              {"own.pdb", &own_pdb}, {"own.cif", &own_cif}};
  for (const auto& [name, text] : files) {
    CAPTURE(name);
    CHECK(tookToRead(*text, name, kAtoms) < 120 * kAtoms + kBuffers);
    CHECK(tookToRead(gzipped(*text), name + ".gz", kAtoms) < 120 * kAtoms + kBuffers + (std::size_t{10} << 20));
  }
}

TEST_CASE(
    "an assembly of 240 copies of 3 chains has 720 chains, each named once, every atom in its place, and takes at most "
    "120 bytes an atom") {
  constexpr int kResidues = 40, kRound = 60, kUp = 4;
  constexpr std::size_t kAsymmetric = 3 * kResidues * 8, kAtoms = kAsymmetric * kRound * kUp;
  const std::string text = capsid(kResidues, kRound, kUp);
  CHECK(tookToRead(text, "x.cif", kAtoms, {.assembly = "1"}) < 120 * kAtoms + (std::size_t{2} << 20));
  const auto one = readMoleculeBytes(text, "x.cif"), all = readMoleculeBytes(text, "x.cif", {.assembly = "1"});
  REQUIRE(one);
  REQUIRE(all);
  REQUIRE(all->chains.size() == 720);
  for (int copy = 0; copy < kRound * kUp; ++copy) {
    const std::string suffix = copy ? '-' + std::to_string(copy + 1) : "";
    REQUIRE(all->chains[std::size_t(3 * copy)].name == "A" + suffix);
    REQUIRE(all->chains[std::size_t(3 * copy + 2)].name == "C" + suffix);
    const double a = 6.283185307 * (copy / kUp + 1) / kRound;
    const Vec3 from = one->spheres[5].centre_A, at = all->spheres[std::size_t(copy) * kAsymmetric + 5].centre_A;
    const double z = from.z + 1000.0 * (kRound + 1 + copy % kUp);
    REQUIRE(glm::distance(at, Vec3(std::cos(a) * from.x - std::sin(a) * from.y,
                                   std::sin(a) * from.x + std::cos(a) * from.y, z)) < 1e-4);
  }
}

TEST_CASE("an assembly that carries its atoms onto themselves a thousand times has them once") {
  std::string text = kCifHead + "ATOM C CA LEU A 1 0 0 5 1.0\nATOM C CB LEU A 1 0 0 7 1.0\n";
  std::string generator = capsid(0, 1000, 1);
  text += generator.substr(kCifHead.size());
  const auto molecule = readMoleculeBytes(text, "x.cif", {.assembly = "1"});
  REQUIRE(molecule);
  CHECK(molecule->atoms.size() == 2);
  CHECK(molecule->chains.size() == 1);
}

TEST_CASE("an assembly of 1.8 million chains whose names take 7 GB is refused before it is made") {
  std::string text = kCifHead, chains;
  for (int k = 0; k < 300; ++k) {
    const std::string chain = std::string(2000, 'x') + std::to_string(k);
    text += "ATOM C CA LEU " + chain + " 1 800 " + std::to_string(k) + " 5 1.0\n";
    chains += (k ? "," : "") + chain;
  }
  std::string generator = capsid(0, 1000, 6).substr(kCifHead.size());
  const std::string all = " A,B,C\n";
  generator.replace(generator.find(all), all.size(), "\n;" + chains + "\n;\n");
  const std::size_t before = most_held = held.load();
  CHECK(problemOf(text + generator, "x.cif", {.assembly = "1"}) ==
        "x.cif: the assembly '1' takes more than 3 GB of memory; read it without one");
  CHECK(most_held - before < 200'000'000);
}

TEST_CASE(
    "25 000 001 spheres in 45 kB are refused on their line; so is an assembly of 25.9 million atoms, before it is "
    "made") {
  std::string packed;
  const std::string piece = gzipped(repeated("0 0 0 1\n", 1'000'000));
  for (int k = 0; k < 26; ++k) packed += piece;
  CHECK(packed.size() < 350'000);
  CHECK(problemOf(packed, "x.xyzr.gz") ==
        "x.xyzr.gz:25000001: more than 25 million atoms; split the file, or keep one model");
  const std::size_t before = most_held = held.load();
  const std::string text = capsid(4, 1000, 270);
  CHECK(problemOf(text, "x.cif", {.assembly = "1"}) ==
        "x.cif: the assembly '1' has more than 25 million atoms; read it without one");
  CHECK(most_held - before < 200'000'000);
}

TEST_CASE("a line without an end, a text of CIF without an end and a gzip of gzips are reported") {
  const std::string line = problemOf(gzipped(std::string(20 << 20, 'x')), "x.xyzr.gz");
  CHECK(line.starts_with("x.xyzr.gz:1: the line is longer than 16 MiB"));
  CHECK(problemOf("data_x\n_a.b\n;text\n", "x.cif")
            .starts_with("x.cif:3:1: it is not sound CIF: a text that begins with ';' has no end"));
  CHECK_FALSE(problemOf(gzipped(gzipped("0 0 0 1\n")), "x.xyzr.gz").empty());
  CHECK(readMoleculeBytes(gzipped("0 0 0 1\n") + gzipped("2 0 0 1\n") + std::string(100, '\0'), "x.xyzr.gz")
            ->atoms.size() == 2);
}

TEST_CASE(
    "an operator expression of 2000 brackets ends at once: doubled it has too many copies, of one each it has one") {
  const MmcifOperators two{{"1", {}}, {"2", {}}};
  std::string doubled, single, wide = "(1-2)";
  for (int k = 0; k < 2000; ++k) doubled += "(1-2)", single += "(1)";
  CHECK(operatorsOf(doubled, two).size() == kMaxCopies + 1);
  CHECK(operatorsOf(single, two).size() == 1);
  CHECK(operatorsOf("(1-2)(1,2)(1-2)", two).size() == 8);
  // Half a million copies in each of 2000 brackets.
  for (int k = 1; k < 19; ++k) wide += "(1-2)";
  CHECK(operatorsOf(wide + single, two).size() == kMaxCopies + 1);
  CHECK(operatorsOf("(1-2)(7)(1-2)", two).empty());  // 7 is not known: nothing times anything
}
