#include "app/ui/files/own_lessons.h"

#include <algorithm>
#include <map>
#include <system_error>
#include <utility>

#include "app/ui/files/file_kinds.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/lesson_files.h"
#include "engine/pack/pack_lesson.h"
#include "engine/pack/unpack.h"

namespace moltact {

namespace fs = std::filesystem;

std::vector<LibraryItem> packedLessons(const fs::path& packs) {
  if (packs.empty()) return {};
  struct Newest {
    LibraryItem item;
    fs::file_time_type unpacked;
  };
  std::map<std::pair<std::string, std::string>, Newest> newest;
  for (LibraryItem& item : lessonItems(packs)) {
    std::error_code error;
    const fs::path pack = packs / *item.file.lexically_relative(packs).begin();
    const fs::file_time_type unpacked = fs::last_write_time(pack, error);
    const auto [at, is_new] = newest.try_emplace({item.id, item.label}, Newest{item, unpacked});
    if (!is_new && at->second.unpacked < unpacked) at->second = {std::move(item), unpacked};
  }
  std::vector<LibraryItem> out;
  for (auto& [name, kept] : newest) out.push_back(std::move(kept.item));
  return out;
}

std::vector<LibraryItem> lessonsAmong(const std::vector<std::string>& files) {
  std::vector<LibraryItem> out;
  std::error_code error;
  for (const std::string& file : files)
    if (fileKind(file) == FileKind::Lesson && fs::is_regular_file(file, error)) out.push_back(lessonItem(file));
  return out;
}

Expected<fs::path> addLesson(const fs::path& file, const fs::path& packs) {
  const auto unpacked = [&](const Expected<PackFile>& pack) -> Expected<fs::path> {
    if (!pack) return pack.problem();
    Expected<fs::path> lesson = unpack(*pack, packs);
    if (!lesson) return lesson.problem();
    return packedLesson(*lesson, language());
  };
  if (hasPackName(file)) return unpacked(PackFile::open(file));
  if (fileKind(file) != FileKind::Lesson)
    return Problem{file.string(), 0, 0, tr("this is not a lesson"), tr("choose a file that ends in .moltact or .md")};
  PackedLesson made = packLesson(file);
  if (!made.pack) return std::move(made.errors.front());
  return unpacked(PackFile::ofBytes(file.string(), std::move(made.pack->bytes)));
}

fs::path fileBesideLesson(const std::string& lesson_file, const std::string& name,
                          const std::vector<fs::path>& folders) {
  for (const fs::path& folder : folders) {
    if (folder.empty()) continue;
    for (const fs::path& lesson : lessonsIn(folder).lessons) {
      if (lesson.filename() != lesson_file) continue;
      std::error_code error, unknown;
      fs::recursive_directory_iterator it(lesson.parent_path(), error);
      for (; !error && it != fs::recursive_directory_iterator(); it.increment(error))
        if (it->path().filename() == name && it->is_regular_file(unknown)) return it->path();
    }
  }
  return {};
}

}  // namespace moltact
