// Broken files: each gives its own clear message, and nothing crashes, hangs or returns a NaN.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "engine/molecule/text_source.h"
#include "tests/molecule/files.h"

using namespace moltact;
using namespace moltact::test;

namespace {

const std::string kPdbRemedy =
    "the PDB format has x, y, z in columns 31-54; correct the line, or convert the file to mmCIF";
const std::string kXyzrRemedy = "write four numbers a line, x y z r in angstroms, with blanks between them";

/// Reads; what is read must be finite and in order. Returns whether it was read.
bool readsSoundly(std::string bytes, const std::string& name, const ReadOptions& options = {}) {
  auto molecule = readMoleculeBytes(std::move(bytes), name, options);
  if (!molecule) {
    CHECK_FALSE(molecule.problem().message.empty());
    return false;
  }
  CHECK_FALSE(molecule->atoms.empty());
  bool sound = true;
  for (const PlacedAtom& atom : molecule->placedAtoms()) {
    for (int k = 0; k < 3; ++k) sound &= std::abs(atom.position.A[k]) <= kMaxCoordinate_A;
    sound &= atom.radius_A >= 0 && std::isfinite(atom.radius_A);
    sound &= atom.name.back() == 0 && (atom.residue == kNoResidue || atom.residue < molecule->residues.size());
  }
  std::uint32_t next = 0;
  for (const Residue& residue : molecule->residues) {
    sound &= residue.first_atom == next && residue.chain < molecule->chains.size();
    next += residue.atom_count;
  }
  sound &= molecule->residues.empty() || next == molecule->atoms.size();
  CHECK(sound);
  return true;
}

/// A PDB file's first atoms as mmCIF text.
std::string asMmcif(const std::string& pdb, int most) {
  std::string out = "data_T\n_entry.id T\n_struct.title 'a title'\nloop_\n";
  for (const char* tag : {"group_PDB", "id", "type_symbol", "label_atom_id", "label_alt_id", "label_comp_id",
                          "label_asym_id", "auth_seq_id", "Cartn_x", "Cartn_y", "Cartn_z", "occupancy"})
    out += std::string("_atom_site.") + tag + '\n';
  std::istringstream lines(pdb);
  for (std::string line; most > 0 && std::getline(lines, line);)
    if (line.starts_with("ATOM")) {
      out += "ATOM " + line.substr(6, 5) + ' ' + line.substr(76, 2) + ' ' + line.substr(12, 4) + " . " +
             line.substr(17, 3) + " A " + line.substr(22, 4) + ' ' + line.substr(30, 8) + ' ' + line.substr(38, 8) +
             ' ' + line.substr(46, 8) + " 1.0\n";
      --most;
    }
  return out;
}

}  // namespace

TEST_CASE("a missing file, a folder and an empty file are distinguished") {
  const Scratch scratch;
  const auto text = [](const std::filesystem::path& p) { return readMolecule(p).problem().message; };
  CHECK(readMolecule("no/such.pdb").problem().text() ==
        "no/such.pdb: there is no such file; check the name and the folder");
  CHECK(text(scratch.folder) == "it is a folder");
  CHECK(text(scratch.write("a.pdb", "")) == "the file is empty");
  CHECK(text(scratch.write("b.xyzr", " \n\n")) == "the file is empty");
  CHECK(text("/dev/zero") == "it is not an ordinary file");
}

TEST_CASE("a file of another kind is refused with the formats that are read") {
  CHECK(problemOf("Dear reader,\n1 2 3\n", "letter.txt") ==
        "letter.txt: it is not a molecule in a format that is read here; those are .cif .pdb .ent .mmcif .sdf .mol "
        ".mol2 .pqr .pdbqt .gro .xyzr, each also with .gz");
  CHECK(problemOf("Dear reader\n", "letter.pdb") ==
        "letter.pdb: there is no ATOM or HETATM line in it; take a coordinate file from the PDB "
        "(www.rcsb.org)");
  CHECK(problemOf("data_x\n_a.b 1\n", "x.cif") ==
        "x.cif: there is no _atom_site table with Cartn_x, Cartn_y and Cartn_z in it; take a coordinate file "
        "from the PDB (www.rcsb.org)");
  CHECK(problemOf("# nothing\n", "x.xyzr") == "x.xyzr: the file holds no atoms; " + kXyzrRemedy);
}

TEST_CASE("a PDB line with a broken column names line, column and field") {
  const std::string good = atomLine(" N", ' ', "GLY", 'A', 1, ' ', 1, 2, 3, 1, "N");
  std::string bad = good;
  bad.replace(38, 8, "   2.x00");
  CHECK(problemOf(good + bad, "x.pdb") == "x.pdb:2:39: y (columns 39-46) is not a number: '   2.x00'; " + kPdbRemedy);
  bad = good;
  bad.replace(30, 8, "     nan");
  CHECK(problemOf(bad, "x.pdb") == "x.pdb:1:31: x (columns 31-38) is not a number: '     nan'; " + kPdbRemedy);
  bad = good;
  bad.replace(46, 8, "        ");
  CHECK(problemOf(bad, "x.pdb") == "x.pdb:1:47: z (columns 47-54) is not a number: '        '; " + kPdbRemedy);
  bad = good;
  bad.insert(20, " ");  // every column one too far to the right
  CHECK(problemOf(bad, "x.pdb") == "x.pdb:1:39: y (columns 39-46) is not a number: '0   2.00'; " + kPdbRemedy);
  CHECK(problemOf(good.substr(0, 40), "x.pdb") ==
        "x.pdb:1:41: the atom's line ends before its coordinates do; " + kPdbRemedy);
  bad = good;
  bad.replace(22, 4, "1x 2");
  CHECK(problemOf(bad, "x.pdb") ==
        "x.pdb:1:23: the residue number (columns 23-26) is not a number: '1x 2'; " + kPdbRemedy);
  bad = good;
  bad.replace(54, 6, "  abc ");
  const auto read = readMoleculeBytes(bad + "END\n", "x.pdb");
  REQUIRE(read);
  CHECK(read->warnings ==
        std::vector<std::string>{"Line 1: the occupancy '  abc ' is not a number and was taken as 1."});
}

TEST_CASE(
    "a PDB file that ends with an atom, or has not the atoms its MASTER record counts, is read with a "
    "warning") {
  const std::string cut = "The file ends with an atom and has no END record after it: it may be cut short.";
  const auto counts = [](int by_master, int atoms) {
    return "The MASTER record counts " + std::to_string(by_master) + " atoms, but the file has " +
           std::to_string(atoms) + ": it may be cut short or edited.";
  };
  const auto master = [](int atoms) {
    char line[96];
    std::snprintf(line, sizeof line, "MASTER    %5d%5d%5d%5d%5d%5d%5d%5d%5d%5d%5d%5d\n", 5, 0, 0, 0, 0, 0, 0, 6, atoms,
                  1, 0, 1);
    return std::string(line);
  };
  const auto notes = [](const std::string& text) {
    const auto read = readMoleculeBytes(text, "x.pdb");
    REQUIRE(read);
    std::vector<std::string> out = read->warnings.copy();
    std::erase_if(out, [](const std::string& w) { return w.find("models; this is model") != std::string::npos; });
    return out;
  };
  using Notes = std::vector<std::string>;
  const std::string atom = atomLine(" N", ' ', "GLY", 'A', 1, ' ', 1, 2, 3, 1, "N");
  const std::string other = atomLine(" CA", ' ', "GLY", 'A', 1, ' ', 2, 2, 3, 1, "C");
  CHECK(notes(atom + other) == Notes{cut});
  CHECK(notes(atom + other + "ANISOU    2  CA  GLY A   1     1000   1000   1000      0      0      0       C\n\n") ==
        Notes{cut});
  CHECK(notes(atom + "END\n" + other) == Notes{cut});
  for (const char* end : {"END\n", "TER\n", "ENDMDL\n", "CONECT    1    2\n", "END"})
    CHECK(notes(atom + other + end).empty());
  CHECK(notes(atom + other + master(2) + "END\n").empty());
  CHECK(notes(atom + other + master(2)).empty());
  CHECK(notes(atom + other + master(0)).empty());
  CHECK(notes(atom + other + master(7) + "END\n") == Notes{counts(7, 2)});
  const std::string models = "MODEL        1\n" + atom + other + "ENDMDL\nMODEL        2\n" + atom + other + "ENDMDL\n";
  CHECK(notes(models + master(2) + "END\n").empty());
  CHECK(notes(models + master(4) + "END\n").empty());
  CHECK(notes(models + master(3) + "END\n") == Notes{counts(3, 4)});
}

TEST_CASE("a coordinate as 1e9 in a PDB column is refused, and so is one beyond 1e9 A in mmCIF and .xyzr") {
  std::string line = atomLine(" N", ' ', "GLY", 'A', 1, ' ', 1, 2, 3, 1, "N");
  line.replace(30, 8, "    1e30");
  CHECK(problemOf(line, "x.pdb").find("x.pdb:1:31: x (columns 31-38) is not a number") == 0);
  const std::string cif =
      "data_x\nloop_\n_atom_site.type_symbol\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n";
  CHECK(problemOf(cif + "C 2e9 0 0\n", "x.cif") ==
        "x.cif: the atom '' lies farther out than 1e9\u00a0Å; correct its coordinates");
  CHECK(problemOf(cif + "C 0 0 0\nC 0 ? 0\n", "x.cif") ==
        "x.cif: row 2 of the _atom_site table: Cartn_y is not a number: '?'; correct the file, or take it "
        "again from its source");
  CHECK(problemOf(cif + "C 0 inf 0\n", "x.cif").find("Cartn_y is not a number: 'inf'") != std::string::npos);
  CHECK(problemOf("2e9 0 0 1\n", "x.xyzr") ==
        "x.xyzr:1:1: x is '2e9', which is not a finite number up to 1e9\u00a0Å; correct or remove the line");
}

TEST_CASE("of 30 000 mmCIF models the first, the last and one whose rows are parted by others are read") {
  std::string cif =
      "data_x\nloop_\n_atom_site.type_symbol\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
      "_atom_site.pdbx_PDB_model_num\n";
  for (int model = 1; model <= 30'000; ++model)
    cif += "C " + std::to_string(model) + " 0 0 " + std::to_string(model) + '\n';
  cif += "C 0.5 0 0 7\n";
  for (const auto& [model, atoms] : {std::pair{1, 1u}, {7, 2u}, {30'000, 1u}}) {
    ReadOptions options;
    options.model = model;
    const auto read = readMoleculeBytes(cif, "x.cif", options);
    REQUIRE(read);
    CHECK(read->models_in_file == 30'000);
    REQUIRE(read->atoms.size() == atoms);
    CHECK(read->spheres[0].centre_A.x == model);
  }
}

TEST_CASE("broken mmCIF syntax names the line and column") {
  const std::string text = problemOf("data_x\nloop_\n_atom_site.id\n_atom_site.Cartn_x\n1 2 3\n", "x.cif");
  CHECK(text.find("x.cif:") == 0);
  CHECK(text.find("it is not sound CIF") != std::string::npos);
  CHECK(problemOf("data_x\n_atom_site.Cartn_x 'open\n", "x.cif").find("x.cif:2:") == 0);
}

TEST_CASE("an .xyzr line with 3 numbers, a word, a NaN, a comma or a negative radius names line and column") {
  CHECK(problemOf("0 0 0 1\n1 2 3\n", "x.xyzr") == "x.xyzr:2:6: expected 4 numbers, found 3; " + kXyzrRemedy);
  CHECK(problemOf("0 zero 0 1\n", "x.xyzr") == "x.xyzr:1:3: expected a number for y, found 'zero'; " + kXyzrRemedy);
  CHECK(problemOf("0 0 nan 1\n", "x.xyzr") ==
        "x.xyzr:1:5: z is 'nan', which is not a finite number up to 1e9\u00a0Å; correct or remove the line");
  CHECK(problemOf("0,0,0,1\n", "x.xyzr") == "x.xyzr:1:1: expected a number for x, found '0,0,0,1'; " + kXyzrRemedy);
  CHECK(problemOf("0 0 0 -1\n", "x.xyzr") == "x.xyzr:1:7: the radius is negative: '-1'; give a radius of 0 or more");
  CHECK(problemOf("12\ncomment\n", "x.xyzr") == "x.xyzr:1:3: expected 4 numbers, found 1; " + kXyzrRemedy);
}

TEST_CASE("a gzip file that is cut short or damaged says so") {
  std::string text;
  for (int i = 0; i < 3000; ++i) text += std::to_string(i) + " 0 0 1\n";
  const std::string zip = gzipped(text);
  CHECK(problemOf(zip.substr(0, zip.size() / 2), "x.xyzr.gz") ==
        "x.xyzr.gz: the gzip file is cut short; copy or download the file again");
  CHECK(problemOf(zip.substr(0, 5), "x.xyzr.gz") ==
        "x.xyzr.gz: the gzip file is cut short; copy or download the file again");
  std::string damaged = zip;
  for (std::size_t i = 20; i < 40; ++i) damaged[i] = static_cast<char>(~damaged[i]);
  CHECK(problemOf(damaged, "x.xyzr.gz") == "x.xyzr.gz: the gzip file is damaged; copy or download the file again");
}

TEST_CASE("gzip that unpacks to more than 1 MiB is refused where 1 MiB is the most") {
  const std::string bomb = gzipped(std::string(64 << 20, '\n'));
  CHECK(bomb.size() < (1 << 17));
  TextSource text(memorySource(bomb), bomb.size(), 1 << 20, "x.pdb.gz");
  std::string_view line;
  while (text.next(line)) {
  }
  REQUIRE(text.problem());
  CHECK(text.problem()->text() == "x.pdb.gz: it unpacks to more than 1 MiB; split it, or keep one model");
}

TEST_CASE("ten million lines of rubbish are refused in every format") {
  std::string rubbish;
  rubbish.reserve(200'000'000);
  for (int i = 0; i < 10'000'000; ++i) rubbish += "the quick brown fox\n";
  for (const char* name : {"x.pdb", "x.cif", "x.xyzr", "x.dat"}) CHECK_FALSE(problemOf(rubbish, name).empty());
}

TEST_CASE("ubiquitin as PDB, mmCIF, .xyzr and gzip, cut at 300 places each, is read soundly or refused") {
  std::string pdb = contentOf(libraryFolder() / "1ubq.pdb");
  pdb.resize(pdb.find('\n', 30'000) + 1);
  std::string xyzr;
  for (int i = 0; i < 500; ++i) xyzr += std::to_string(i * 0.37) + " 1.25 -3.5 1.7\n";
  const std::pair<const char*, std::string> files[] = {
      {"x.pdb", pdb}, {"x.cif", asMmcif(pdb, 200)}, {"x.xyzr", xyzr}, {"x.pdb.gz", gzipped(pdb)}};
  for (const auto& [name, whole] : files) {
    CAPTURE(name);
    CHECK_MESSAGE(readsSoundly(whole, name), problemOf(whole, name));
    for (std::size_t k = 0; k < 300; ++k) readsSoundly(whole.substr(0, whole.size() * k / 300), name);
    for (std::size_t k = 1; k < 100 && k < whole.size(); ++k) readsSoundly(whole.substr(0, whole.size() - k), name);
  }
}

TEST_CASE("4000 files with 1 to 20 random bytes changed, doubled or removed are read soundly or refused") {
  const unsigned seed = 20260;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  std::string pdb =
      "MODEL        1\nREMARK 350 BIOMOLECULE: 1\nREMARK 350 APPLY THE FOLLOWING TO CHAINS: A\n"
      "REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        0.00000\n"
      "REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000\n"
      "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000\n";
  pdb += contentOf(libraryFolder() / "1ubq.pdb");
  pdb.resize(pdb.find('\n', 4000) + 1);
  std::string cif = asMmcif(contentOf(libraryFolder() / "1ubq.pdb"), 30) +
                    "loop_\n_pdbx_struct_assembly_gen.assembly_id\n_pdbx_struct_assembly_gen.oper_expression\n"
                    "_pdbx_struct_assembly_gen.asym_id_list\n1 '(1-2)(1,2)' A\n"
                    "loop_\n_pdbx_struct_oper_list.id\n";
  for (int i = 1; i <= 3; ++i)
    for (int j = 1; j <= 3; ++j)
      cif += "_pdbx_struct_oper_list.matrix[" + std::to_string(i) + "][" + std::to_string(j) + "]\n";
  for (int i = 1; i <= 3; ++i) cif += "_pdbx_struct_oper_list.vector[" + std::to_string(i) + "]\n";
  cif += "1 1 0 0 0 1 0 0 0 1 0 0 0\n2 0 -1 0 1 0 0 0 0 1 0 0 0\n";
  std::string xyzr;
  for (int i = 0; i < 40; ++i) xyzr += std::to_string(i * 0.37) + " 1.25 -3.5 1.7\n";
  const std::pair<const char*, std::string> files[] = {
      {"x.pdb", pdb}, {"x.cif", cif}, {"x.xyzr", xyzr}, {"x.pdb.gz", gzipped(pdb)}};
  int read = 0;
  for (const auto& [name, whole] : files) {
    for (int k = 0; k < 1000; ++k) {
      std::string bytes = whole;
      // Every other file is hurt lightly, without moving a column, so that it reaches behind the first check.
      const bool lightly = k % 2 == 0;
      for (std::size_t n = 1 + below(lightly ? 2 : 20); n > 0; --n) {
        const std::size_t at = below(bytes.size());
        switch (lightly ? 1 : below(4)) {
          case 0:
            bytes[at] = static_cast<char>(below(256));
            break;
          case 1:
            bytes[at] = "0123456789 -+.eE\n'\"(),_#;"[below(25)];
            break;
          case 2:
            bytes.insert(at, bytes.substr(at, below(60)));
            break;
          default:
            bytes.erase(at, below(8));
            break;
        }
      }
      ReadOptions options;
      if (k % 3 == 0) options.assembly = "1";
      CAPTURE(name);
      CAPTURE(k);
      read += readsSoundly(std::move(bytes), name, options);
    }
  }
  CHECK(read > 200);
  CHECK(read < 3900);
}

TEST_CASE("bytes of a binary format come out as they are, 1 000 at a time and between lines, packed by gzip or not") {
  std::string whole = "a line\n";
  for (std::uint32_t k = 0; k < 300'000; ++k) whole += static_cast<char>(k * 7919u >> 3);
  for (const std::string& stored : {whole, gzipped(whole)}) {
    TextSource text(memorySource(stored), stored.size(), 1 << 20, "x.bin");
    std::string_view line;
    REQUIRE(text.next(line));
    CHECK(line == "a line");
    std::string rest;
    while (text.bytes(1000, rest)) {
    }
    CHECK_FALSE(text.problem());
    CHECK(rest == whole.substr(7));
  }
}
