#include "engine/lesson/lesson_molecules.h"

#include <system_error>

#include "engine/language/catalogue.h"
#include "engine/molecule/catalogue.h"
#include "engine/molecule/reader.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

Expected<std::shared_ptr<const Molecule>> read(const MoleculeKey& key) {
  auto molecule = readMolecule(key);
  if (molecule) return std::make_shared<const Molecule>(*std::move(molecule));
  const Problem& why = molecule.problem();
  const std::string file_name = fs::path(why.file).filename().string();
  std::string message =
      file_name.empty() ? trf("the molecule's file cannot be used: {0}", why.message)
      : why.line ? trf("the molecule's file cannot be used: {0}, line {1}: {2}", file_name, why.line, why.message)
                 : trf("the molecule's file cannot be used: {0}: {1}", file_name, why.message);
  return Problem{{}, 0, 0, std::move(message), why.remedy};
}

Expected<fs::path> fileOf(const fs::path& lesson_file, const std::string& name) {
  std::error_code error;
  if (const fs::path beside = lesson_file.parent_path() / name; fs::is_regular_file(beside, error)) return beside;
  if (name.find('/') != std::string::npos)
    return Problem{{},
                   0,
                   0,
                   trf("there is no file '{0}' beside the lesson", name),
                   tr("check its name; it is looked for in the lesson's folder")};
  MoleculeFolders folders = MoleculeFolders::ofThisComputer();
  folders.beside = lesson_file.has_parent_path() ? lesson_file.parent_path() : fs::path(".");
  Expected<fs::path> known = findMolecule(name, folders);
  if (!known)
    return Problem{
        {}, 0, 0, trf("there is no molecule '{0}' in the library nor beside the lesson", name), known.problem().remedy};
  if (!fs::is_regular_file(*known, error))
    return Problem{{},
                   0,
                   0,
                   trf("there is no file '{0}' beside the lesson", name),
                   tr("check its name; it is looked for in the lesson's folder")};
  return known;
}

}  // namespace

Expected<MoleculeKey> lessonMolecule(const fs::path& lesson_file, const NamedMolecule& named) {
  Expected<fs::path> file = fileOf(lesson_file, named.name);
  if (!file) return file.problem();
  MoleculeKey key{*std::move(file), named.reading};
  if (!named.reading.beside.empty()) {
    const Expected<fs::path> other = fileOf(lesson_file, named.reading.beside);
    if (!other) return other.problem();
    // A library name is kept; a file beside the lesson needs its path to be found from elsewhere.
    std::error_code error;
    const fs::path folder = lesson_file.has_parent_path() ? lesson_file.parent_path() : fs::path(".");
    if (fs::equivalent(other->has_parent_path() ? other->parent_path() : fs::path("."), folder, error))
      key.reading.beside = fs::absolute(*other, error).lexically_normal().string();
  }
  return key;
}

Expected<fs::path> simulationFile(const fs::path& lesson_file, const MoleculeKey& molecule, const std::string& name) {
  std::error_code error;
  for (const fs::path& beside : {lesson_file, molecule.file})
    if (const fs::path file = beside.parent_path() / name; !name.empty() && fs::is_regular_file(file, error))
      return file;
  return Problem{{},
                 0,
                 0,
                 trf("there is no file '{0}' beside the lesson or the molecule", name),
                 tr("make it with 'moltact simulate prepare', or mend its name")};
}

Expected<std::shared_ptr<const Molecule>> LessonMolecules::find(const fs::path& lesson_file,
                                                                const NamedMolecule& named) {
  const Expected<MoleculeKey> key = lessonMolecule(lesson_file, named);
  if (!key) return key.problem();
  std::error_code error;
  const fs::file_time_type written = fs::last_write_time(key->file, error);
  if (const auto kept = kept_.find(*key); kept != kept_.end() && kept->second.written == written)
    return kept->second.molecule;
  return kept_.insert_or_assign(*key, Kept{written, read(*key)}).first->second.molecule;
}

}  // namespace moltact
