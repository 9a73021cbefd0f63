#include "engine/molecule/catalogue.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/molecule/pdb_id.h"
#include "engine/platform/folders.h"

namespace moltact {
namespace fs = std::filesystem;
namespace {

/// The number of letters to add, remove or change to turn `a` into `b` (Levenshtein).
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, changed});
    }
  }
  return row[b.size()];
}

Expected<std::vector<CatalogueEntry>> entriesFrom(const nlohmann::json& json, const std::string& file) {
  std::vector<CatalogueEntry> out;
  for (const auto& item : json.at("molecules")) {
    CatalogueEntry e;
    e.id = item.at("id").get<std::string>();
    e.file = item.at("file").get<std::string>();
    e.title = item.at("title").get<std::string>();
    e.good_for = item.at("good_for").get<std::string>();
    e.source = item.at("source").get<std::string>();
    e.left_out = item.value("left_out", std::string());
    e.licence = item.at("licence").get<std::string>();
    e.atoms = item.at("atoms").get<std::size_t>();
    // A name with a folder in it could point outside the library.
    if (e.file.empty() || fs::path(e.file).filename() != e.file)
      return Problem{file, 0, 0, trf("the entry '{0}' has the file '{1}'", e.id, e.file),
                     tr("give the bare name of a file in the folder")};
    if (e.id != lower(e.id) || e.id.empty())
      return Problem{file, 0, 0, trf("the id '{0}' is not in lower case", e.id), tr("write ids in lower case")};
    if (std::any_of(out.begin(), out.end(), [&](const CatalogueEntry& o) { return o.id == e.id; }))
      return Problem{file, 0, 0, trf("the id '{0}' is there twice", e.id), tr("give every molecule its own id")};
    out.push_back(std::move(e));
  }
  return out;
}

/// A file of `folder` with this name and a supported ending; empty if there is none.
fs::path fileNamed(const fs::path& folder, const std::string& name) {
  if (folder.empty() || name.find('/') != std::string::npos) return {};
  std::string upper = name;
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  std::error_code error;
  for (const std::string& stem : {name, upper, lower(name)})
    for (const std::string_view ending : moleculeEndings())
      for (const char* packed : {".gz", ""})
        if (fs::path file = folder / (stem + std::string(ending) + packed); fs::is_regular_file(file, error))
          return file;
  return {};
}

Problem unknown(const std::string& name, const std::vector<CatalogueEntry>& entries) {
  const std::string wanted = lower(name);
  std::string nearest;
  std::size_t distance = 4;  // more than three changed letters, or half of them, is no similarity
  for (const CatalogueEntry& e : entries)
    if (const std::size_t d = editDistance(wanted, e.id);
        d < distance && 2 * d <= std::max(wanted.size(), e.id.size())) {
      distance = d;
      nearest = e.id;
    }
  std::string remedy;
  if (!nearest.empty()) remedy = trf("did you mean '{0}'?", nearest);
  if (!pdbId(name).empty())
    remedy += (remedy.empty() ? "" : " ") + trf("'moltact fetch {0}' downloads an entry of the PDB", name);
  if (remedy.empty()) {
    remedy = tr("name a file, or one of:");
    for (const CatalogueEntry& e : entries) remedy += ' ' + e.id;
  }
  return {name, 0, 0, tr("there is no such file, and no molecule of this name in the library"), remedy};
}

}  // namespace

Expected<std::vector<CatalogueEntry>> readCatalogue(const fs::path& folder) {
  const fs::path path = folder / "catalogue.json";
  std::ifstream in(path);
  if (!in)
    return Problem{path.string(), 0, 0, tr("the catalogue of molecules cannot be opened"),
                   tr("install the program again, or set MOLTACT_HOME")};
  try {
    return entriesFrom(nlohmann::json::parse(in), path.string());
  } catch (const nlohmann::json::exception& e) {
    return Problem{path.string(), 0, 0, trf("the catalogue is not as it should be: {0}", e.what()),
                   tr("mend the file")};
  }
}

MoleculeFolders MoleculeFolders::ofThisComputer() { return {moleculesFolder(), userMoleculesFolder()}; }

Expected<fs::path> findMolecule(const std::string& name, const MoleculeFolders& folders) {
  if (name.empty())
    return Problem{"", 0, 0, tr("no molecule is named"), tr("name a file or a molecule of the library, such as 1ubq")};
  std::error_code error;
  // A folder of the same name must not hide a molecule of the library.
  const bool is_path =
      name.find('/') != std::string::npos || (fs::exists(name, error) && !fs::is_directory(name, error));
  if (is_path) return fs::path(name);
  auto entries = readCatalogue(folders.library);
  if (entries)
    for (const CatalogueEntry& e : *entries)
      if (e.id == lower(name)) return folders.library / e.file;
  for (const fs::path& folder : {folders.beside, folders.fetched})
    if (fs::path file = fileNamed(folder, name); !file.empty()) return file;
  if (fs::exists(name, error)) return fs::path(name);
  // A name with an ending denotes a file: the reader reports that it is missing.
  const std::string ending = lower(fs::path(name).extension().string());
  if (ending == ".gz" || hasMoleculeName(name)) return fs::path(name);
  if (!entries) return entries.problem();
  return unknown(name, *entries);
}

Expected<MoleculeKey> findMoleculeKey(const NamedMolecule& named, const MoleculeFolders& folders) {
  Expected<fs::path> file = findMolecule(named.name, folders);
  if (!file) return file.problem();
  return MoleculeKey{*std::move(file), named.reading};
}

NamedMolecule lastingName(const MoleculeKey& key, const MoleculeFolders& folders) {
  std::error_code error;
  const std::string name = key.file.filename().string(), id = name.substr(0, name.find('.'));
  if (const Expected<fs::path> found = findMolecule(id, folders); found && *found != id)
    if (fs::equivalent(*found, key.file, error)) return {id, key.reading};
  return {fs::absolute(key.file, error).lexically_normal().string(), key.reading};
}

Expected<Molecule> openMolecule(const std::string& name, const ReadOptions& options) {
  auto file = findMolecule(name, MoleculeFolders::ofThisComputer());
  if (!file) return file.problem();
  return readMolecule(*file, options);
}

}  // namespace moltact
