#include "app/ui/files/library.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <optional>
#include <tuple>
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

// Returns the text after `key` if the line begins with the key, else an empty text.
std::string valueIn(const std::string& line, std::string_view key) {
  if (!line.starts_with(key)) return {};
  const std::size_t from = line.find_first_not_of(" \t", key.size()), to = line.find_last_not_of(" \t\r");
  return from == std::string::npos ? std::string() : line.substr(from, to + 1 - from);
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
  std::stable_sort(items.begin(), items.end(), precedes);
  return items;
}

bool precedes(const LibraryItem& a, const LibraryItem& b) {
  const auto order = [](const LibraryItem& l) {
    const bool placed = l.order > 0;
    return std::tuple(!placed, l.order, placed ? 0 : levelRank(l.level), l.id != kFirstLesson, placed ? 0 : l.minutes,
                      std::string_view(l.id));
  };
  return order(a) < order(b);
}

// Reads only the front matter, not the whole lesson.
LibraryItem lessonItem(const fs::path& file) {
  constexpr int kFrontMatterLines = 30;
  LibraryItem out{lessonName(file).id, file.stem().string(), file, "beginner"};
  std::ifstream in(file);
  std::string line;
  for (int k = 0; k < kFrontMatterLines && std::getline(in, line) && (k == 0 || !line.starts_with("---")); ++k) {
    if (const std::string title = valueIn(line, "title:"); !title.empty()) out.label = title;
    if (const std::string level = valueIn(line, "level:"); !level.empty()) out.level = level;
    if (const std::string minutes = valueIn(line, "minutes:"); !minutes.empty())
      std::from_chars(minutes.data(), minutes.data() + minutes.size(), out.minutes);
    if (const std::string order = valueIn(line, "order:"); !order.empty())
      std::from_chars(order.data(), order.data() + order.size(), out.order);
  }
  return out;
}

int levelRank(std::string_view level) {
  static constexpr std::array<std::string_view, 3> kLevels{"beginner", "intermediate", "advanced"};
  return int(std::find(kLevels.begin(), kLevels.end(), level) - kLevels.begin());
}

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
