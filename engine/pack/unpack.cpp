#include "engine/pack/unpack.h"

#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/language/catalogue.h"
#include "engine/lesson/lesson_files.h"
#include "engine/platform/folders.h"
#include "engine/platform/write_file.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

// Hidden, so that the library ignores it.
constexpr const char* kUnderWay = ".unpacking-";

Problem folderProblem(const fs::path& folder, const std::error_code& error) {
  return {folder.string(), 0, 0, trf("the folder cannot be made: {0}", error.message()),
          tr("check that you may write there and that the disk has room")};
}

std::optional<Problem> writeFiles(const PackFile& pack, const fs::path& folder) {
  for (const PackEntry& entry : pack.entries()) {
    const fs::path file = folder / entry.name;
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error) return folderProblem(file.parent_path(), error);
    Expected<Draft> draft = Draft::begin(file, IfThere::Refuse);
    if (!draft) return draft.problem();
    if (auto fault = pack.read(entry, [&](std::string_view bytes) { return draft->append(bytes); })) return fault;
    if (auto fault = draft->commit()) return fault;
  }
  return std::nullopt;
}

}  // namespace

fs::path packsFolder() {
  const fs::path data = userDataFolder();
  return data.empty() ? data : data / "packs";
}

Expected<fs::path> unpack(const PackFile& pack, const fs::path& packs) {
  if (packs.empty())
    return Problem{pack.name(), 0, 0, tr("there is no folder to unpack it into"),
                   tr("set HOME or XDG_DATA_HOME to a folder of yours")};
  std::error_code error;
  fs::create_directories(packs, error);
  if (error) return folderProblem(packs, error);
  sweepTemporaryFolders(packs, kUnderWay);  // left behind by programs that were killed while unpacking
  Expected<TemporaryFolder> made = TemporaryFolder::in(packs, kUnderWay);
  if (!made) return made.problem();
  // One folder inside the other, so that the previous contents are removed with it.
  const fs::path fresh = made->path() / "new", old = made->path() / "old";
  fs::create_directory(fresh, error);
  if (error) return folderProblem(fresh, error);
  if (auto fault = writeFiles(pack, fresh)) return *std::move(fault);
  const fs::path place = packs / (lessonName(pack.lesson()).id + '-' + pack.hash());
  if (error = replaceFolder(fresh, place, old); error) return folderProblem(place, error);
  return place / pack.lesson();
}

fs::path packedLesson(const fs::path& lesson_file, std::string_view language) {
  std::vector<fs::path> same;
  std::error_code error;
  const std::string id = lessonName(lesson_file).id;
  for (fs::directory_iterator it(lesson_file.parent_path(), error), end; !error && it != end; it.increment(error))
    if (it->path().extension() == ".md" && lessonName(it->path()).id == id) same.push_back(it->path());
  std::sort(same.begin(), same.end());
  same = inLanguage(std::move(same), language);
  return same.empty() ? lesson_file : same.front();
}

Expected<TemporaryPack> TemporaryPack::open(const fs::path& pack_file) {
  Expected<PackFile> pack = PackFile::open(pack_file);
  if (!pack) return pack.problem();
  std::error_code error;
  const fs::path temporary = fs::temp_directory_path(error);
  if (error) return folderProblem(temporary, error);
  constexpr std::string_view kPrefix = "moltact-pack-";
  sweepTemporaryFolders(temporary, kPrefix);
  Expected<TemporaryFolder> folder = TemporaryFolder::in(temporary, kPrefix);
  if (!folder) return folder.problem();
  auto at_signal = std::make_unique<RemovedAtSignal>(folder->path());
  if (auto fault = writeFiles(*pack, folder->path())) return *std::move(fault);
  return TemporaryPack(*std::move(pack), *std::move(folder), std::move(at_signal));
}

std::string TemporaryPack::shown(std::string text) const {
  const std::string folder = folder_.path().string();
  for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder, at + pack_.name().size()))
    text.replace(at, folder.size(), pack_.name());
  return text;
}

}  // namespace moltact
