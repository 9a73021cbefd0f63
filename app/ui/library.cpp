#include "app/ui/library.h"

#include <algorithm>
#include <fstream>
#include <system_error>

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
  for (const CatalogueEntry& e : *entries) items.push_back({e.id, e.title.empty() ? e.id : e.title, folder / e.file});
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

std::vector<LibraryItem> readLessonList() {
  std::vector<LibraryItem> items;
  std::error_code error;
  for (fs::directory_iterator it(lessonsFolder(), error), end; !error && it != end; it.increment(error))
    if (it->path().extension() == ".md" && it->path().stem() != "README") items.push_back({it->path().stem().string(), titleOf(it->path()), it->path()});
  std::sort(items.begin(), items.end(), [](const LibraryItem& a, const LibraryItem& b) { return a.id < b.id; });
  return items;
}

}  // namespace

const std::vector<LibraryItem>& library() {
  static const std::vector<LibraryItem> items = readLibrary();
  return items;
}

const std::vector<LibraryItem>& lessons() {
  static const std::vector<LibraryItem> items = readLessonList();
  return items;
}

}  // namespace moltact
