#include "engine/molecule/reader.h"

#include <algorithm>
#include <filesystem>
#include <new>
#include <optional>

#include "engine/language/catalogue.h"
#include "engine/molecule/parsed_structure.h"
#include "engine/molecule/side_by_side.h"
#include "engine/platform/read_file.h"

// One line per file name ending, with a reader function of this name in its own file, and whether the format has partial
// charges. A reader of a binary format takes its input from TextSource::bytes(). The catalogue, the window's file
// browser and the messages use this table. Of two files of the same name the earlier ending takes precedence.
#define MOLTACT_FORMATS(X)      \
  X(".cif", readMmcif, false)   \
  X(".pdb", readPdb, false)     \
  X(".ent", readPdb, false)     \
  X(".mmcif", readMmcif, false) \
  X(".sdf", readSdf, false)     \
  X(".mol", readSdf, false)     \
  X(".mol2", readMol2, true)    \
  X(".pqr", readPqr, true)      \
  X(".pdbqt", readPdbqt, true)  \
  X(".gro", readGro, false)     \
  X(".xyzr", readXyzr, false)

namespace moltact {

#define MOLTACT_DECLARE(ending, reader, charges) \
  Expected<Molecule> reader(TextSource& text, const ReadOptions& options);
MOLTACT_FORMATS(MOLTACT_DECLARE)
#undef MOLTACT_DECLARE

namespace {

using ReadText = Expected<Molecule> (*)(TextSource& text, const ReadOptions& options);

struct Format {
  const char* extension;
  ReadText read;
  bool has_charges;  // partial charges of the atoms
};

#define MOLTACT_ROW(ending, reader, charges) Format{ending, reader, charges},
constexpr Format kFormats[] = {MOLTACT_FORMATS(MOLTACT_ROW)};
#undef MOLTACT_ROW

constexpr const char* kTooLargeRemedy = N_("split it, or keep one model");

/// The name without .gz.
std::filesystem::path innerName(std::filesystem::path file) {
  if (lower(file.extension().string()) == ".gz") file.replace_extension();
  return file;
}

/// True if the first line that is neither blank nor a comment contains four numbers.
bool looksLikeXyzr(std::string_view text) {
  while (!text.empty()) {
    const std::size_t newline = text.find('\n');
    std::string_view line = trimmed(text.substr(0, newline));
    text.remove_prefix(newline == std::string_view::npos ? text.size() : newline + 1);
    if (line.empty() || line[0] == '#') continue;
    int numbers = 0;
    while (!line.empty() && numbers < 4) {
      const std::size_t blank = line.find_first_of(" \t");
      double value;
      if (!parseNumber(line.substr(0, blank), value)) return false;
      ++numbers;
      line = blank == std::string_view::npos ? std::string_view() : trimmed(line.substr(blank));
    }
    return numbers == 4;
  }
  return false;
}

/// The Problem for a known but unsupported format of molecules, with a remedy; empty for other files.
std::optional<Problem> notRead(std::string_view head, const std::string& extension, const std::string& file) {
  if (head.starts_with("PK\x03\x04") || head.starts_with("PK\x05\x06"))
    return Problem{file, 0, 0, tr("it is a zip archive"), tr("unpack it, and open the molecule's file that is in it")};
  const bool read = std::any_of(std::begin(kFormats), std::end(kFormats),
                                [&](const Format& format) { return extension == format.extension; });
  if (!read && (extension == ".bcif" || extension == ".mmtf"))
    return Problem{file, 0, 0, tr("binary files of molecules are not read"), tr("take the .cif file of the entry")};
  return std::nullopt;
}

/// True for a PDBQT file, whose lines of atoms are those of a PDB file with two differences. Columns 71-76 have a
/// charge of three decimals, where PDB has four letters of a segment at most. A type follows from column 78 on.
bool looksLikePdbqt(std::string_view text) {
  std::size_t atoms = 0;
  while (!text.empty()) {
    const std::size_t newline = text.find('\n');
    const std::string_view line = text.substr(0, newline);
    if (newline == std::string_view::npos) break;  // the text that was read ahead may end within it
    text.remove_prefix(newline + 1);
    if (!line.starts_with("ATOM  ") && !line.starts_with("HETATM")) continue;
    double charge_e = 0.0;
    if (line.size() < 78 || line[72] != '.' || line[76] != ' ' || line[77] == ' ' ||
        !parseNumber(trimmed(line.substr(66, 10)), charge_e))
      return false;
    ++atoms;
  }
  return atoms > 0;
}

/// The reader for the content of a file; null if it is not supported.
ReadText readerByContent(std::string_view text) {
  const std::string_view head = text;
  std::size_t line_number = 0;
  for (std::string_view rest = head; !rest.empty();) {
    const std::size_t newline = rest.find('\n');
    const std::string_view line = rest.substr(0, newline);
    for (const char* record : {"ATOM  ", "HETATM", "HEADER    ", "MODEL ", "CRYST1", "REMARK "})
      if (line.starts_with(record)) return looksLikePdbqt(text) ? readPdbqt : readPdb;
    if (line.starts_with("data_")) return readMmcif;
    if (line.starts_with("@<TRIPOS>")) return readMol2;
    rest.remove_prefix(newline == std::string_view::npos ? rest.size() : newline + 1);
    if (++line_number == 4 &&
        (line.find("V2000") != std::string_view::npos || line.find("V3000") != std::string_view::npos))
      return readSdf;
  }
  return looksLikeXyzr(head) ? readXyzr : nullptr;
}

Expected<Molecule> readText(TextSource& text, const std::filesystem::path& path, const ReadOptions& options) {
  const std::string& file = text.file();
  const Problem empty{file, 0, 0, tr("the file is empty"), tr("copy or download it again")};
  if (text.ahead().empty()) return text.problem().value_or(empty);
  const std::filesystem::path inner = innerName(path);
  const std::string extension = lower(inner.extension().string());
  if (auto problem = notRead(text.ahead(), extension, file)) return *problem;
  ReadText read = nullptr;
  for (const Format& format : kFormats)
    if (extension == format.extension) read = format.read;
  if (!read) read = readerByContent(text.ahead());
  // Programs for docking write PDBQT under names that end in .pdb too; read as PDB it would lose its charges.
  if (read == readPdb && looksLikePdbqt(text.ahead())) read = readPdbqt;
  if (!read && text.problem()) return *text.problem();
  if (!read && trimmed(text.ahead()).empty()) return empty;
  if (!read)
    return Problem{file, 0, 0, tr("it is not a molecule in a format that is read here"),
                   trf("those are {0}, each also with .gz", moleculeEndingsText())};
  Expected<Molecule> molecule = read(text, options);
  if (text.problem()) return *text.problem();
  if (!molecule && text.number() > 0 && text.blank()) return empty;
  if (molecule && molecule->id.empty()) molecule->id = inner.stem().string();
  return molecule;
}

}  // namespace

std::vector<std::string_view> moleculeEndings() {
  std::vector<std::string_view> out;
  for (const Format& format : kFormats) out.emplace_back(format.extension);
  return out;
}

std::string moleculeEndingsText() {
  std::string out;
  for (const Format& format : kFormats) out += (out.empty() ? "" : " ") + std::string(format.extension);
  return out;
}

std::string chargedEndingsText() {
  std::string out;
  for (const Format& format : kFormats)
    if (format.has_charges) out += (out.empty() ? "" : " ") + std::string(format.extension);
  return out;
}

bool hasMoleculeName(const std::filesystem::path& file) {
  const std::string ending = lower(innerName(file).extension().string());
  return std::any_of(std::begin(kFormats), std::end(kFormats),
                     [&](const Format& format) { return ending == format.extension; });
}

Expected<Molecule> readMoleculeBytes(std::string bytes, const std::filesystem::path& path, const ReadOptions& options) {
  TextSource text(memorySource(bytes), bytes.size(), kMaxMoleculeBytes, path.string());
  return readText(text, path, options);
}

Expected<Molecule> readMolecule(const std::filesystem::path& path, const ReadOptions& options) {
  if (!options.beside.empty()) return readSideBySide(path, options);
  try {
    auto open = openFile(path, kMaxMoleculeBytes, tr(kTooLargeRemedy));
    if (!open) return open.problem();
    TextSource text(fileSource(std::move(open->in), open->size, path.string()), open->size, kMaxMoleculeBytes,
                    path.string());
    return readText(text, path, options);
  } catch (const std::bad_alloc&) {
    return Problem{path.string(), 0, 0, tr("there is not enough memory to read it"),
                   tr("close other programs, or take a smaller file")};
  }
}

}  // namespace moltact
