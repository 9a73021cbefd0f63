// Reads PDB files line by line. Atoms are read here, so that messages name the line and column of an invalid number and
// only the molecule needs memory. gemmi reads the records that name, describe and copy them. gemmi alone takes 0.14 s
// and 166 MB for a million atoms, this reader 0.26 s and 54 MB (build/release/reading_benchmark). gemmi rejects files
// from before 1996, whose columns 73 to 80 contain the entry's name and line numbers. For every file of the library
// both read the same atoms (tests/molecule/gemmi_agrees_test.cpp).
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <gemmi/pdb.hpp>
#include <new>
#include <optional>

#include "engine/language/catalogue.h"
#include "engine/molecule/parsed_structure.h"

namespace moltact {
namespace {

constexpr std::size_t kLineWidth = 80;
constexpr std::size_t kMaxLineWarnings = 20;
constexpr std::size_t kMaxHead = std::size_t{32} << 20;  // limit on titles and descriptions of assemblies (unit: byte)

bool startsWith(std::string_view line, std::string_view record) {
  if (line.size() < record.size()) return false;
  for (std::size_t i = 0; i < record.size(); ++i)
    if (std::toupper(static_cast<unsigned char>(line[i])) != record[i]) return false;
  return true;
}

/// The lines of a PDB file that are passed to gemmi, and observations made on the way.
struct PdbRecords {
  std::string kept;  // lines of 80 columns and a line feed
  std::vector<std::string> warnings;
  int models = 0;
  std::size_t atoms_in_file = 0;    // in all models
  std::size_t atoms_in_first = 0;   // of model 1
  std::size_t atoms_by_master = 0;  // according to the MASTER record; 0: unknown
  bool ends_in_atom = false;
  std::optional<Problem> bad_operator;  // the first invalid BIOMT line
  // Residue numbers have four columns, up to 9999. The conventions of programs for larger ones are undone along a
  // chain.
  std::string chain;
  int last_number = 0, beyond = 0;  // as in the file; the offset to add
};

struct Field {
  std::size_t first, width;  // first counts from 0
  const char* name;
};

constexpr Field kCoordinateFields[3] = {{30, 8, "x"}, {38, 8, "y"}, {46, 8, "z"}};
constexpr Field kOccupancyField = {54, 6, "occupancy"};
constexpr Field kBFactorField = {60, 6, "B factor"};

std::string columns(const Field& f) { return trf("columns {0}-{1}", f.first + 1, f.first + f.width); }

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

/// The residue number of a valid field: decimal, from 10 000 in hybrid-36; 0 if it is blank.
int residueNumber(std::string_view field) {
  if (std::isalpha(static_cast<unsigned char>(field[0]))) {
    const std::string digits(field);
    return static_cast<int>(std::strtol(digits.c_str(), nullptr, 36)) - 466560 + 10000;
  }
  return static_cast<int>(std::strtol(std::string(field).c_str(), nullptr, 10));
}

bool isDigits(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// The residue number of an atom's line. `five_columns`: column 27 is its last digit, because VMD and others write
/// 10000 into columns 23-27. GROMACS writes 0 after 9999, which is read as 10000 within the same chain.
int numberInChain(PdbRecords& records, std::string_view line, std::string_view chain, bool& five_columns) {
  five_columns = isDigits(line.substr(22, 5));
  const int written = five_columns ? static_cast<int>(std::strtol(std::string(line.substr(22, 5)).c_str(), nullptr, 10))
                                   : residueNumber(line.substr(22, 4));
  if (records.chain != chain) {
    records.chain = chain;
    records.beyond = 0;
  } else if (written == 0 && records.last_number == 9'999) {
    records.beyond += 10'000;
  } else if (written == 0 && records.last_number == 99'999) {
    records.beyond += 100'000;
  }
  records.last_number = written;
  return written + records.beyond;
}

/// Names of four letters in columns 18-21, as simulation programs write them; in other files column 21 belongs to the
/// chain.
bool isLongName(std::string_view name) {
  static constexpr std::string_view kNames[] = {"TIP3", "TIP4", "POPC", "POPE", "POPG", "POPS", "POPA", "DOPC",
                                                "DOPE", "DOPG", "DOPS", "DPPC", "DPPE", "DPPG", "DPPS", "DMPC",
                                                "DMPE", "DMPG", "DLPC", "DLPE", "DSPC", "DSPE", "CHL1", "CHOL"};
  return std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames);
}

/// The element of columns 77-78, else of the atom's name: names such as HG11 and 1HB are hydrogens.
gemmi::Element elementOf(const char* line, bool has_element) {
  if (has_element) return gemmi::Element(line + 76);
  const auto digit = [&](int column) { return std::isdigit(static_cast<unsigned char>(line[column])) != 0; };
  if (std::toupper(static_cast<unsigned char>(line[12])) == 'H' && line[15] != ' ') return gemmi::El::H;
  if (digit(12)) return gemmi::impl::find_single_letter_element(line[13] & ~0x20);
  if (digit(13)) return gemmi::impl::find_single_letter_element(line[12] & ~0x20);
  return gemmi::Element(line + 12);
}

/// Parses one ATOM or HETATM line and adds its atom; returns a Problem if it is invalid.
std::optional<Problem> addAtom(MoleculeBuilder& builder, PdbRecords& records, std::string_view line,
                               const std::string& file, std::size_t number) {
  constexpr const char* kLineRemedy =
      N_("the PDB format has x, y, z in columns 31-54; correct the line, or convert the file to mmCIF");
  if (line.size() < 54)
    return Problem{file, number, line.size() + 1, tr("the atom's line ends before its coordinates do"),
                   tr(kLineRemedy)};
  char out[kLineWidth + 1];
  std::memset(out, ' ', kLineWidth);
  line.copy(out, kLineWidth);
  out[kLineWidth] = 0;
  for (std::size_t i = 0; i < kLineWidth; ++i)
    if (static_cast<unsigned char>(out[i]) < ' ' || static_cast<unsigned char>(out[i]) > '~') out[i] = ' ';
  const std::string_view clean(out, kLineWidth);
  ParsedAtom atom;
  for (int k = 0; k < 3; ++k) {
    const Field& f = kCoordinateFields[k];
    const std::string_view field = line.substr(f.first, f.width);
    if (!parseNumber(field, atom.position_A[k]) || std::abs(atom.position_A[k]) > kMaxCoordinate_A)
      return Problem{file, number, f.first + 1,
                     trf("{0} ({1}) is not a number: {2}", f.name, columns(f), inQuotes(field)), tr(kLineRemedy)};
  }
  if (!isResidueNumber(clean.substr(22, 4)))
    return Problem{file, number, 23,
                   trf("the residue number (columns 23-26) is not a number: {0}", inQuotes(clean.substr(22, 4))),
                   tr(kLineRemedy)};
  const std::string_view field = clean.substr(kOccupancyField.first, kOccupancyField.width);
  if (const bool blank = trimmed(field).empty(); blank || !parseNumber(field, atom.occupancy)) {
    if (!blank && records.warnings.size() < kMaxLineWarnings)
      records.warnings.push_back(
          trf("Line {0}: the occupancy {1} is not a number and was taken as 1.", number, inQuotes(field)));
    atom.occupancy = 1.0;
  }
  const std::string_view b_factor = clean.substr(kBFactorField.first, kBFactorField.width);
  if (const bool blank = trimmed(b_factor).empty(); blank || !parseNumber(b_factor, atom.b_factor_A2)) {
    if (!blank && records.warnings.size() < kMaxLineWarnings)
      records.warnings.push_back(
          trf("Line {0}: the B factor {1} is not a number and was taken as 0.", number, inQuotes(b_factor)));
    atom.b_factor_A2 = 0.0;
  }
  // Since 1996 columns 77-80 contain an element and a charge, before that a part of the line number.
  const bool has_element = (std::isalpha(static_cast<unsigned char>(out[77])) &&
                            (out[76] == ' ' || std::isalpha(static_cast<unsigned char>(out[76])))) ||
                           (std::isalpha(static_cast<unsigned char>(out[76])) && out[77] == ' ');
  const gemmi::Element element = elementOf(out, has_element);
  atom.name = trimmed(clean.substr(12, 4));
  const bool long_name = isLongName(clean.substr(17, 4));
  atom.residue = trimmed(clean.substr(17, long_name ? 4 : 3));
  atom.chain = trimmed(long_name ? clean.substr(21, 1) : clean.substr(20, 2));
  atom.element = element.elem == gemmi::El::X ? atom.name : std::string_view(element.name());
  atom.atomic_number = element.atomic_number();
  atom.line = number;
  bool five_columns = false;
  atom.number = numberInChain(records, clean, atom.chain, five_columns);
  atom.insertion = five_columns ? ' ' : clean[26];
  atom.alternate = clean[16];
  atom.hetero = std::toupper(static_cast<unsigned char>(out[0])) == 'H';
  return builder.add(atom);
}

/// The count of ATOM and HETATM records in a MASTER record (columns 51-55); 0 if it is missing or invalid.
std::size_t masterCount(std::string_view line) {
  std::size_t count = 0;
  if (line.size() < 55) return count;
  for (char c : trimmed(line.substr(50, 5))) {
    if (!std::isdigit(static_cast<unsigned char>(c))) return 0;
    count = 10 * count + static_cast<std::size_t>(c - '0');
  }
  return count;
}

/// A file that ends between two lines reads as a smaller molecule: warns if there is evidence of this.
void warnOfCut(PdbRecords& records) {
  constexpr std::size_t kMaxByMaster = 99'999;  // the largest number that its columns can contain
  if (records.ends_in_atom)
    records.warnings.push_back(tr("The file ends with an atom and has no END record after it: it may be cut short."));
  // With several models the PDB counts only the first, other programs all.
  if (records.atoms_by_master && records.atoms_in_file <= kMaxByMaster &&
      records.atoms_by_master != records.atoms_in_file && records.atoms_by_master != records.atoms_in_first)
    records.warnings.push_back(
        trf("The MASTER record counts {0} atoms, but the file has {1}: it may be cut short or edited.",
            records.atoms_by_master, records.atoms_in_file));
}

/// Rearranges a line "REMARK 350   BIOMT2  17  …" into the columns that gemmi reads. They have three digits for the
/// operator's number; from 1000 on the rest of the line is shifted. Returns an empty text if it is not such a line, and
/// nothing if it contains an invalid number.
std::optional<std::string> operatorInColumns(std::string_view line) {
  constexpr std::size_t kWord = 13;
  if (line.size() < kWord + 6 || !startsWith(line.substr(kWord), "BIOMT")) return std::string();
  std::string_view rest = line.substr(kWord + 5);
  const char row = rest.front();
  rest.remove_prefix(1);
  std::string_view words[5];
  double value[4] = {};
  for (std::string_view& word : words) {
    rest = trimmed(rest);
    word = rest.substr(0, rest.find(' '));
    rest.remove_prefix(word.size());
  }
  bool sound = row >= '1' && row <= '3' && !words[0].empty() && isDigits(words[0]);
  for (int k = 0; k < 4; ++k)
    sound = sound && parseNumber(words[k + 1], value[k]) && std::abs(value[k]) < (k < 3 ? 100.0 : 1e7);
  if (!sound) return std::nullopt;
  char shift[32];  // with as many decimals as fit into ten columns
  for (int digits = 5; digits > 0; --digits)
    if (std::snprintf(shift, sizeof shift, "%.*f", digits, value[3]) <= 10) break;
  char out[kLineWidth + 1];
  std::snprintf(out, sizeof out, "REMARK 350   BIOMT%c    %10.6f%10.6f%10.6f     %10.10s", row, value[0], value[1],
                value[2], shift);
  return std::string(out);
}

/// True for a HELIX or SHEET line with a valid first and last residue.
bool namesResidues(std::string_view line) {
  const std::size_t first = startsWith(line, "HELIX") ? 21 : 22;
  return line.size() >= 37 && isResidueNumber(line.substr(first, 4)) && isResidueNumber(line.substr(33, 4));
}

/// Reads the file line by line: passes the atoms of model `wanted` to the builder and keeps the records that name and
/// describe the molecule and its assemblies.
std::optional<Problem> scanRecords(PdbRecords& records, MoleculeBuilder& builder, TextSource& text, int wanted) {
  bool in_model = false;
  for (std::string_view line; text.next(line);) {
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (startsWith(line, "ATOM") || startsWith(line, "HETATM")) {
      if (!in_model) {
        in_model = true;
        ++records.models;
      }
      ++records.atoms_in_file;
      records.atoms_in_first += records.models == 1;
      records.ends_in_atom = true;
      if (records.models == wanted)
        if (auto problem = addAtom(builder, records, line, text.file(), text.number())) return problem;
      continue;
    }
    // These records belong to the preceding atom.
    const bool of_atom = startsWith(line, "ANISOU") || startsWith(line, "SIGATM") || startsWith(line, "SIGUIJ");
    if (!of_atom && !trimmed(line).empty()) records.ends_in_atom = false;
    if (startsWith(line, "MASTER")) {
      records.atoms_by_master = masterCount(line);
    } else if (startsWith(line, "MODEL ")) {
      in_model = true;
      ++records.models;
    } else if (startsWith(line, "ENDMDL")) {
      in_model = false;
    } else if (startsWith(line, "END") && trimmed(line).size() == 3) {
      // Simulation programs write END between frames; a following atom starts another model.
      in_model = false;
    } else if (startsWith(line, "HEADER") || startsWith(line, "TITLE") || startsWith(line, "REMARK 350") ||
               startsWith(line, "HELIX ") || startsWith(line, "SHEET ")) {
      if (records.kept.size() > kMaxHead)
        return Problem{text.file(), text.number(), 0, tr("more than 32 MiB of titles and descriptions of assemblies"),
                       tr("take the file again from its source")};
      std::string kept(line.substr(0, kLineWidth));
      if (startsWith(line, "REMARK")) {
        const auto aligned = operatorInColumns(line);
        if (!aligned && !records.bad_operator)
          records.bad_operator =
              Problem{text.file(), text.number(), 14,
                      tr("the assembly's operator is not four numbers after its own: a row of a matrix and a shift"),
                      tr("correct the line, take the mmCIF file, or read it without an assembly")};
        if (!aligned) continue;
        if (!aligned->empty()) kept = *aligned;
      } else if ((startsWith(line, "HELIX") || startsWith(line, "SHEET")) && !namesResidues(kept)) {
        if (records.warnings.size() < kMaxLineWarnings)
          records.warnings.push_back(
              trf("Line {0}: the helix or strand names no residues and was left out.", text.number()));
        continue;
      }
      for (char& c : kept)
        if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') c = ' ';
      kept.resize(kLineWidth, ' ');
      records.kept += kept + '\n';
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

ParsedSecondaryStructure elementFrom(const gemmi::AtomAddress& first, const gemmi::AtomAddress& last,
                                     RecordedStructure structure) {
  const auto end = [](const gemmi::AtomAddress& at) {
    return ParsedSecondaryStructure::End{at.res_id.seqid.num.has_value() ? *at.res_id.seqid.num : 0,
                                         at.res_id.seqid.icode};
  };
  return {structure, first.chain_name, end(first), end(last)};
}

std::vector<ParsedSecondaryStructure> elementsFrom(const gemmi::Structure& st) {
  using Class = gemmi::Helix::HelixClass;
  std::vector<ParsedSecondaryStructure> out;
  for (const gemmi::Helix& helix : st.helices) {
    const Class c = helix.pdb_helix_class;
    const HelixKind kind = c == Class::R310                                 ? HelixKind::ThreeTen
                           : c == Class::RPi                                ? HelixKind::Pi
                           : c == Class::RAlpha || c == Class::UnknownHelix ? HelixKind::Alpha
                                                                            : HelixKind::Other;
    out.push_back(elementFrom(helix.start, helix.end, {SecondaryStructure::Helix, kind}));
  }
  for (const gemmi::Sheet& sheet : st.sheets)
    for (const gemmi::Sheet::Strand& strand : sheet.strands)
      out.push_back(elementFrom(strand.start, strand.end, {SecondaryStructure::Strand}));
  return out;
}

std::string information(const gemmi::Structure& st, const char* key) {
  const auto found = st.info.find(key);
  return found == st.info.end() ? std::string() : std::string(trimmed(found->second));
}

}  // namespace

Expected<Molecule> readPdb(TextSource& text, const ReadOptions& options) {
  const std::string& file = text.file();
  PdbRecords records;
  MoleculeBuilder builder(text, options);
  if (auto problem = scanRecords(records, builder, text, options.model)) return *problem;
  if (records.models == 0)
    return Problem{file, 0, 0, tr("there is no ATOM or HETATM line in it"),
                   tr("take a coordinate file from the PDB (www.rcsb.org)")};
  if (options.model < 1 || options.model > records.models) return noSuchModel(file, options.model, records.models);
  if (records.bad_operator && !options.assembly.empty()) return *records.bad_operator;
  warnOfCut(records);
  ParsedHeader head;
  head.warnings = records.warnings;
  head.models = records.models;
  try {
    const gemmi::Structure st = gemmi::read_pdb_from_memory(records.kept.data(), records.kept.size(), file);
    head.id = information(st, "_entry.id");
    head.title = information(st, "_struct.title");
    for (const gemmi::Assembly& assembly : st.assemblies) head.assemblies.push_back(assemblyFrom(assembly));
    head.elements = elementsFrom(st);
  } catch (const std::bad_alloc&) {
    throw;  // not an error in the file
  } catch (const std::exception& e) {
    return Problem{file, 0, 0, trf("it is not a sound PDB file: {0}", e.what()),
                   tr("take the file again from its source")};
  }
  return builder.finish(std::move(head));
}

}  // namespace moltact
