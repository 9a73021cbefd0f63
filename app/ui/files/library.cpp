#include "app/ui/files/library.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/lesson/lesson_files.h"
#include "engine/molecule/catalogue.h"
#include "engine/platform/folders.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

std::vector<LibraryItem> readLibrary() {
  std::vector<LibraryItem> items;
  const fs::path folder = moleculesFolder();
  const Expected<std::vector<CatalogueEntry>> entries = readCatalogue(folder);
  if (!entries) return items;
  for (const CatalogueEntry& e : *entries)
    items.push_back({e.id, e.title.empty() ? e.id : trc("molecule", e.title.c_str()), folder / e.file});
  return items;
}

// The title in the front matter, without reading the whole lesson.
std::string titleOf(const fs::path& file) {
  constexpr int kFrontMatterLines = 30;
  constexpr std::string_view kKey = "title:";
  std::ifstream in(file);
  std::string line;
  for (int k = 0; k < kFrontMatterLines && std::getline(in, line); ++k) {
    if (!line.starts_with(kKey)) continue;
    const std::size_t from = line.find_first_not_of(" \t", kKey.size()), to = line.find_last_not_of(" \t\r");
    if (from != std::string::npos) return line.substr(from, to + 1 - from);
  }
  return file.stem().string();
}

}  // namespace

std::vector<LibraryItem> lessonItems(const fs::path& folder) {
  std::vector<LibraryItem> items;
  for (const fs::path& file : inLanguage(lessonsIn(folder).lessons, language())) items.push_back(lessonItem(file));
  return items;
}

std::vector<LibraryItem> lessonsOf(const std::vector<fs::path>& folders) {
  std::vector<LibraryItem> items;
  for (const fs::path& folder : folders)
    for (LibraryItem& item : lessonItems(folder))
      if (std::none_of(items.begin(), items.end(), [&](const LibraryItem& other) { return other.id == item.id; }))
        items.push_back(std::move(item));
  std::stable_sort(items.begin(), items.end(), [](const LibraryItem& a, const LibraryItem& b) { return a.id < b.id; });
  return items;
}

LibraryItem lessonItem(const fs::path& file) { return {lessonName(file).id, titleOf(file), file}; }

const std::vector<LibraryItem>& library() {
  static std::vector<LibraryItem> items;
  static std::optional<std::string> listed_in;
  if (listed_in != language()) {
    listed_in = language();
    items = readLibrary();
  }
  return items;
}

const std::vector<LibraryItem>& lessons() {
  static std::vector<LibraryItem> items;
  static std::optional<std::string> listed_in;
  if (listed_in != language()) {
    listed_in = language();
    std::vector<fs::path> folders;
    for (const fs::path& shared : sharedDataFolders()) folders.push_back(shared / "lessons");
    folders.push_back(lessonsFolder());
    items = lessonsOf(folders);
  }
  return items;
}

}  // namespace moltact
