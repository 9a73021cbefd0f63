// Molecules by format. What is read must be finite and in order.
#include <zlib.h>

#include <cmath>

#include "engine/haptics/ball_scene.h"
#include "engine/molecule/reader.h"
#include "engine/molecule/summary.h"
#include "tests/fuzz/target.h"

namespace moltact::fuzz {
namespace {

void soundly(const Molecule& m) {
  mustBe(!m.atoms.empty() && m.atoms.size() <= kMaxMoleculeAtoms, "some atoms");
  for (const Atom& atom : m.atoms) {
    for (int k = 0; k < 3; ++k) mustBe(std::abs(atom.position.A[k]) <= kMaxCoordinate_A, "a place within 1e9 A");
    mustBe(atom.radius_A >= 0 && atom.radius_A <= kMaxCoordinate_A, "a radius");
    mustBe(atom.name.back() == 0, "a name with an end");
    mustBe(atom.residue == kNoResidue || atom.residue < m.residues.size(), "a residue that is there");
  }
  std::uint32_t next = 0, residue = 0;
  for (const Residue& r : m.residues) {
    mustBe(r.first_atom == next && r.atom_count > 0 && r.chain < m.chains.size(), "residues one after the other");
    next += r.atom_count;
  }
  mustBe(m.residues.empty() || next == m.atoms.size(), "every atom in a residue");
  for (const Chain& c : m.chains) {
    mustBe(c.first_residue == residue && c.residue_count > 0, "chains one after the other");
    residue += c.residue_count;
  }
  mustBe(residue == m.residues.size(), "every residue in a chain");
  mustBe(summarise(m).atoms == m.atoms.size(), "a summary of them all");
  for (std::size_t i = 0; i < m.atoms.size(); i += 1 + m.atoms.size() / 20)
    mustBe(!m.describe(i).empty(), "a name to be called by");
}

void read(std::string_view bytes, const char* name) {
  for (const bool plain : {true, false}) {
    ReadOptions options;
    if (!plain) options = {.model = 2, .waters = true, .assembly = "1"};
    const auto molecule = readMoleculeBytes(std::string(bytes), name, options);
    if (molecule)
      soundly(*molecule);
    else
      mustBe(!molecule.problem().message.empty(), "a message");
    if (plain) {
      options.assembly = "1";
      if (const auto whole = readMoleculeBytes(std::string(bytes), name, options)) soundly(*whole);
    }
  }
}

std::string packed(std::string_view bytes) {
  z_stream stream{};
  deflateInit2(&stream, 1, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&stream, uLong(bytes.size())) + 32, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = uInt(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = uInt(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(out.size() - stream.avail_out);
  deflateEnd(&stream);
  return out;
}

}  // namespace

void pdb(std::string_view bytes) { read(bytes, "x.pdb"); }
void mmcif(std::string_view bytes) { read(bytes, "x.cif"); }
void xyzr(std::string_view bytes) { read(bytes, "x.xyzr"); }
void anyMolecule(std::string_view bytes) { read(bytes, "x"); }

// Packed bytes as they are, and soundly packed ones of which some are then cut, changed or doubled.
void gzip(std::string_view bytes) {
  read(bytes, "x.pdb.gz");
  Choices choices(bytes);
  const std::size_t how = choices.pick(5), where = choices.pick(65536);
  std::string file = packed(choices.rest());
  switch (how) {
    case 1:
      file.resize(where % (file.size() + 1));
      break;
    case 2:
      file[where % file.size()] ^= char(1 + where % 255);
      break;
    case 3:
      file += file;
      break;
    case 4:
      file.append(where % 40, '\0');
      break;
    default:
      break;
  }
  read(file, "x.xyzr.gz");
}

}  // namespace moltact::fuzz
