// Reads PDB files through gemmi, which parses numbers silently: every coordinate line is checked here first,
// and gemmi is given only the records that matter, in clean columns. The serial number handed to gemmi is the
// line's place in our list.
#include <cctype>
#include <cstring>
#include <gemmi/pdb.hpp>
#include <new>
#include <optional>

#include "engine/molecule/parsed_structure.h"

namespace moltact {
namespace {

constexpr std::size_t kLineWidth = 80;
constexpr std::size_t kMostLineWarnings = 20;
constexpr std::size_t kMaxAtoms = 40'000'000;  // what a five-column hybrid-36 serial can count

bool startsWith(std::string_view line, std::string_view record) {
  if (line.size() < record.size()) return false;
  for (std::size_t i = 0; i < record.size(); ++i)
    if (std::toupper(static_cast<unsigned char>(line[i])) != record[i]) return false;
  return true;
}

/// Writes `index` into the five columns at `at`: decimal, from 100 000 on hybrid-36.
void writeSerial(char* at, std::size_t index) {
  const bool wide = index >= 100'000;
  std::size_t value = wide ? index - 100'000 + 16'796'160 : index;
  const std::size_t base = wide ? 36 : 10;
  for (int i = 4; i >= 0; --i, value /= base) at[i] = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ"[value % base];
}

/// The lines of a PDB file that gemmi is to see, and what was noticed on the way.
struct Sieve {
  std::string kept;                    // lines of 80 columns and a line feed
  std::vector<std::size_t> atom_line;  // line in the file of the k-th kept atom
  std::vector<std::string> warnings;
  int models = 0;
  std::size_t atoms_in_file = 0;     // of all models
  std::size_t atoms_in_first = 0;    // of model 1
  std::size_t atoms_by_master = 0;   // as the MASTER record counts them; 0 where it does not
  bool ends_in_atom = false;
};

struct Field {
  std::size_t first, width;  // first counts from 0
  const char* name;
};

constexpr Field kCoordinates[3] = {{30, 8, "x"}, {38, 8, "y"}, {46, 8, "z"}};
constexpr Field kOccupancy = {54, 6, "occupancy"};

std::string columns(const Field& f) {
  return "columns " + std::to_string(f.first + 1) + "-" + std::to_string(f.first + f.width);
}

bool isResidueNumber(std::string_view field) {
  field = trimmed(field);
  if (field.empty()) return true;
  if (std::isalpha(static_cast<unsigned char>(field[0]))) {  // hybrid-36, for more than 9999 residues
    if (field.size() != 4) return false;
    for (char c : field)
      if (!std::isalnum(static_cast<unsigned char>(c))) return false;
    return true;
  }
  if (field[0] == '-' || field[0] == '+') field.remove_prefix(1);
  if (field.empty()) return false;
  for (char c : field)
    if (!std::isdigit(static_cast<unsigned char>(c))) return false;
  return true;
}

/// Checks one ATOM or HETATM line and adds it in clean columns; a problem where it cannot be read.
std::optional<Problem> keepAtom(Sieve& sieve, std::string_view line, const std::string& file,
                                std::size_t number) {
  constexpr const char* kRemedy =
      "the PDB format has x, y, z in columns 31-54; correct the line, or convert the file to mmCIF";
  if (line.size() < 54)
    return Problem{file, number, line.size() + 1, "the atom's line ends before its coordinates do", kRemedy};
  if (sieve.atom_line.size() >= kMaxAtoms)
    return Problem{file, number, 0, "more than 40 million atoms", "split the file, or keep one model"};
  char out[kLineWidth + 1];
  std::memset(out, ' ', kLineWidth);
  std::memcpy(out, line.data(), std::min(line.size(), kLineWidth));
  out[kLineWidth] = '\n';
  for (std::size_t i = 0; i < kLineWidth; ++i)
    if (static_cast<unsigned char>(out[i]) < ' ' || static_cast<unsigned char>(out[i]) > '~') out[i] = ' ';
  const std::string_view clean(out, kLineWidth);
  for (const Field& f : kCoordinates) {
    double value = 0;
    const std::string_view field = line.substr(f.first, f.width);
    if (!parseNumber(field, value) || std::abs(value) > kMaxCoordinate_A)
      return Problem{file, number, f.first + 1,
                     std::string(f.name) + " (" + columns(f) + ") is not a number: " + inQuotes(field),
                     kRemedy};
    // written anew, for a form such as 1e3 that gemmi's column may cut
    if (field.find_first_of("+eE") != std::string_view::npos) {
      char text[40];
      std::snprintf(text, sizeof text, "%8.3f", value);
      if (std::strlen(text) != f.width)
        return Problem{file, number, f.first + 1,
                       std::string(f.name) + " does not fit its columns: " + inQuotes(field), kRemedy};
      std::memcpy(out + f.first, text, f.width);
    }
  }
  if (!isResidueNumber(clean.substr(22, 4)))
    return Problem{file, number, 23,
                   "the residue number (columns 23-26) is not a number: " + inQuotes(clean.substr(22, 4)),
                   kRemedy};
  double occupancy = 1.0;
  const std::string_view field = clean.substr(kOccupancy.first, kOccupancy.width);
  if (const bool blank = trimmed(field).empty(); blank || !parseNumber(field, occupancy)) {
    if (!blank && sieve.warnings.size() < kMostLineWarnings)
      sieve.warnings.push_back("Line " + std::to_string(number) + ": the occupancy " + inQuotes(field) +
                               " is not a number and was taken as 1.");
    std::memcpy(out + kOccupancy.first, "  1.00", kOccupancy.width);
  }
  std::memset(out + 60, ' ', 16);  // B factor and segment are not used
  // Columns 77-80 hold an element and a charge since 1996, a part of the line's number before.
  const bool has_element = (std::isalpha(static_cast<unsigned char>(out[77])) &&
                            (out[76] == ' ' || std::isalpha(static_cast<unsigned char>(out[76])))) ||
                           (std::isalpha(static_cast<unsigned char>(out[76])) && out[77] == ' ');
  if (!has_element) out[76] = out[77] = ' ';
  out[78] = out[79] = ' ';
  writeSerial(out + 6, sieve.atom_line.size());
  sieve.kept.append(out, kLineWidth + 1);
  sieve.atom_line.push_back(number);
  return std::nullopt;
}

/// The count of ATOM and HETATM records in a MASTER record (columns 51-55); 0 where there is none to be read.
std::size_t masterCount(std::string_view line) {
  std::size_t count = 0;
  if (line.size() < 55) return count;
  for (char c : trimmed(line.substr(50, 5))) {
    if (!std::isdigit(static_cast<unsigned char>(c))) return 0;
    count = 10 * count + static_cast<std::size_t>(c - '0');
  }
  return count;
}

/// A file cut between two lines reads as a smaller molecule: what gives it away is told.
void warnOfCut(Sieve& sieve) {
  constexpr std::size_t kMostByMaster = 99'999;  // its columns hold no more
  if (sieve.ends_in_atom)
    sieve.warnings.push_back("The file ends with an atom and has no END record after it: it may be cut short.");
  // Of several models the PDB counts the first alone, other programs all.
  if (sieve.atoms_by_master && sieve.atoms_in_file <= kMostByMaster &&
      sieve.atoms_by_master != sieve.atoms_in_file && sieve.atoms_by_master != sieve.atoms_in_first)
    sieve.warnings.push_back("The MASTER record counts " + std::to_string(sieve.atoms_by_master) +
                             " atoms, but the file has " + std::to_string(sieve.atoms_in_file) +
                             ": it may be cut short or edited.");
}

/// Walks over the lines: keeps the atoms of the model asked for and the records that name, describe and copy
/// them.
std::optional<Problem> sift(Sieve& sieve, std::string_view text, const std::string& file, int wanted) {
  bool in_model = false;
  std::size_t number = 0;
  while (!text.empty()) {
    const std::size_t newline = text.find('\n');
    std::string_view line = text.substr(0, newline);
    text.remove_prefix(newline == std::string_view::npos ? text.size() : newline + 1);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    ++number;
    if (startsWith(line, "ATOM") || startsWith(line, "HETATM")) {
      if (!in_model) {
        in_model = true;
        ++sieve.models;
      }
      ++sieve.atoms_in_file;
      sieve.atoms_in_first += sieve.models == 1;
      sieve.ends_in_atom = true;
      if (sieve.models == wanted)
        if (auto problem = keepAtom(sieve, line, file, number)) return problem;
      continue;
    }
    // These belong to the atom before them.
    const bool of_atom = startsWith(line, "ANISOU") || startsWith(line, "SIGATM") || startsWith(line, "SIGUIJ");
    if (!of_atom && !trimmed(line).empty()) sieve.ends_in_atom = false;
    if (startsWith(line, "MASTER")) {
      sieve.atoms_by_master = masterCount(line);
    } else if (startsWith(line, "MODEL ")) {
      in_model = true;
      ++sieve.models;
    } else if (startsWith(line, "ENDMDL")) {
      in_model = false;
    } else if (startsWith(line, "END") && trimmed(line).size() == 3) {
      // Simulation programs write END between frames; another atom after it would begin another model.
      in_model = false;
    } else if (startsWith(line, "TER") ? sieve.models == wanted
                                       : startsWith(line, "HEADER") || startsWith(line, "TITLE") ||
                                             startsWith(line, "REMARK 350")) {
      std::string kept(line.substr(0, kLineWidth));
      for (char& c : kept)
        if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') c = ' ';
      kept.resize(kLineWidth, ' ');
      sieve.kept += kept + '\n';
    }
  }
  return std::nullopt;
}

Vec3 vec(const gemmi::Vec3& v) { return {v.x, v.y, v.z}; }

ParsedAssembly assemblyFrom(const gemmi::Assembly& from) {
  ParsedAssembly out{from.name, {}};
  for (const gemmi::Assembly::Gen& gen : from.generators) {
    ParsedAssembly::Part part{gen.chains, {}, {}};
    for (const gemmi::Assembly::Operator& op : gen.operators) {
      const auto& m = op.transform.mat;
      const glm::dmat3 rows(vec(m.row_copy(0)), vec(m.row_copy(1)), vec(m.row_copy(2)));
      part.operators.push_back({glm::transpose(rows), vec(op.transform.vec)});
    }
    out.parts.push_back(std::move(part));
  }
  return out;
}

void fill(ParsedStructure& out, const gemmi::Structure& st, const Sieve& sieve) {
  out.atoms.resize(sieve.atom_line.size());
  for (const gemmi::Chain& chain : st.models.front().chains)
    for (const gemmi::Residue& residue : chain.residues)
      for (const gemmi::Atom& atom : residue.atoms) {
        const std::size_t place = static_cast<std::size_t>(atom.serial);
        if (place >= out.atoms.size()) continue;
        ParsedAtom& a = out.atoms[place];
        a.name = atom.name;
        a.residue = residue.name;
        a.chain = chain.name;
        a.element = atom.element.elem == gemmi::El::X ? atom.name : atom.element.name();
        a.atomic_number = atom.element.atomic_number();
        a.position_A = {atom.pos.x, atom.pos.y, atom.pos.z};
        a.occupancy = static_cast<double>(atom.occ);
        a.line = sieve.atom_line[place];
        a.number = residue.seqid.num.has_value() ? *residue.seqid.num : 0;
        a.insertion = residue.seqid.icode;
        a.alternate = atom.altloc ? atom.altloc : ' ';
        a.hetero = residue.het_flag == 'H';
      }
}

std::string information(const gemmi::Structure& st, const char* key) {
  const auto found = st.info.find(key);
  return found == st.info.end() ? std::string() : std::string(trimmed(found->second));
}

}  // namespace

Expected<Molecule> readPdb(std::string_view text, const std::string& file, const ReadOptions& options) {
  Sieve sieve;
  if (auto problem = sift(sieve, text, file, options.model)) return *problem;
  if (sieve.models == 0)
    return Problem{file, 0, 0, "there is no ATOM or HETATM line in it",
                   "take a coordinate file from the PDB (www.rcsb.org)"};
  if (options.model < 1 || options.model > sieve.models)
    return noSuchModel(file, options.model, sieve.models);
  warnOfCut(sieve);
  try {
    const gemmi::Structure st = gemmi::read_pdb_from_memory(sieve.kept.data(), sieve.kept.size(), file);
    ParsedStructure parsed;
    parsed.id = information(st, "_entry.id");
    parsed.title = information(st, "_struct.title");
    parsed.warnings = sieve.warnings;
    parsed.models = sieve.models;
    if (!sieve.atom_line.empty()) fill(parsed, st, sieve);
    for (const gemmi::Assembly& assembly : st.assemblies) parsed.assemblies.push_back(assemblyFrom(assembly));
    return buildMolecule(std::move(parsed), file, options);
  } catch (const std::bad_alloc&) {
    throw;  // no fault of the file
  } catch (const std::exception& e) {
    return Problem{file, 0, 0, std::string("it is not a sound PDB file: ") + e.what(),
                   "take the file again from its source"};
  }
}

}  // namespace moltact
