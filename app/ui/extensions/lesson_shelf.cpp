#include "app/ui/extensions/lesson_shelf.h"

#include <algorithm>
#include <array>
#include <system_error>
#include <tuple>

#include "app/ui/application/application.h"
#include "app/ui/files/library.h"
#include "app/ui/files/user_folders.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/reader.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

int levelRank(const std::string& level) {
  static constexpr std::array<std::string_view, 3> kLevels{N_("beginner"), N_("intermediate"), N_("advanced")};
  const auto known = std::find(kLevels.begin(), kLevels.end(), level);
  return int(known - kLevels.begin());
}

void read(LessonCard& card) {
  card.read = true;
  LessonReading reading = readLesson(card.file);
  if (!reading.lesson) {
    card.fault = reading.errors.empty() ? tr("This is not a lesson.") : reading.errors.front().text();
    return;
  }
  const Lesson& lesson = *reading.lesson;
  card.title = lesson.title.empty() ? card.id : lesson.title;
  card.level = lesson.level;
  card.minutes = lesson.minutes;
  card.scene = lesson.steps.front().scene;
  if (Expected<MoleculeKey> key = moleculeOf(*card.scene, card.file)) card.molecule = *std::move(key);
}

}  // namespace

fs::path lessonFolderOf(const Settings& settings) {
  return settings.lesson_folder.empty() ? ownLessonsFolder() : fs::path(settings.lesson_folder);
}

void LessonShelf::list(const Application& app) {
  cards_.clear();
  next_ = 0;
  listed_in_ = language();
  const auto add = [this](const std::vector<LibraryItem>& items, bool own) {
    for (const LibraryItem& item : items) {
      LessonCard& card = cards_.emplace_back();
      card.file = item.file;
      card.id = item.id;
      card.title = item.label;
      card.own = own;
    }
  };
  add(lessons(), false);
  if (const fs::path own = lessonFolderOf(app.settings); !own.empty()) add(lessonItems(own), true);
  if (app.options().attempts_folder.empty()) return;
  for (LessonProgress& p : readProgress(app.options().attempts_folder))
    for (LessonCard& card : cards_)
      if (card.file.filename() == p.lesson) card.progress = p;
}

const LessonCard* LessonShelf::latest() const {
  const LessonCard* best = nullptr;
  for (const LessonCard& c : cards_)
    if (c.progress && c.progress->canResume() && (!best || c.progress->touched > best->progress->touched)) best = &c;
  return best;
}

void LessonShelf::afterPanels(Application& app) {
  const bool opened = app.panels.welcome && !open_, other_language = listed_in_ != language();
  open_ = app.panels.welcome;
  if (opened || (open_ && other_language)) list(app);
  if (!open_ || next_ >= cards_.size()) return;
  read(cards_[next_++]);
  if (next_ < cards_.size()) return;
  std::stable_sort(cards_.begin(), cards_.end(), [](const LessonCard& a, const LessonCard& b) {
    const auto order = [](const LessonCard& c) {
      return std::tuple(c.own, levelRank(c.level), c.id != kFirstLesson, c.own ? 0 : c.minutes, c.own ? c.title : c.id);
    };
    return order(a) < order(b);
  });
}

}  // namespace moltact
