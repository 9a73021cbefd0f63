#include "app/ui/extensions/lesson_list.h"

#include <algorithm>
#include <system_error>
#include <tuple>

#include "app/ui/application/application_options.h"
#include "app/ui/application/opener.h"
#include "app/ui/application/panel_state.h"
#include "app/ui/extensions/attempt_recorder.h"
#include "app/ui/files/library.h"
#include "app/ui/files/own_lessons.h"
#include "app/ui/files/user_folders.h"
#include "app/ui/lesson/lesson_guide.h"
#include "app/ui/widgets/messages.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/minutes.h"
#include "engine/lesson/reader.h"
#include "engine/pack/unpack.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

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
  card.description = lesson.description;
  card.order = lesson.order;
  card.minutes = shownMinutes(lesson).core;
  card.scene = lesson.steps[lesson.cardStep().value_or(0)].scene;
  if (Expected<MoleculeKey> key = moleculeOf(*card.scene, card.file)) card.molecule = *std::move(key);
}

}  // namespace

fs::path lessonFolderOf(const Settings& settings) {
  return settings.lesson_folder.empty() ? ownLessonsFolder() : fs::path(settings.lesson_folder);
}

fs::path packsFolderOf(const ApplicationOptions& options) {
  return options.packs_folder.empty() ? packsFolder() : options.packs_folder;
}

void LessonList::list() {
  cards_.clear();
  next_ = 0;
  listed_in_ = language();
  std::vector<LessonProgress> progress;
  if (!options_.attempts_folder.empty()) progress = readProgress(options_.attempts_folder);
  const auto cardOf = [&](const LibraryItem& item, bool own) {
    LessonCard card;
    card.file = item.file;
    card.id = item.id;
    card.title = item.label;
    card.level = item.level;
    card.order = item.order;
    card.minutes = item.minutes;
    card.own = own;
    for (const LessonProgress& p : progress)
      if (p.isOf(item.file, item.label)) card.progress = p;
    return card;
  };
  for (const LibraryItem& item : lessons()) cards_.push_back(cardOf(item, false));
  if (const fs::path own = lessonFolderOf(settings_); !own.empty())
    for (const LibraryItem& item : lessonItems(own)) cards_.push_back(cardOf(item, true));
  for (const LibraryItem& item : packedLessons(packsFolderOf(options_))) cards_.push_back(cardOf(item, true));
  // Lessons opened from other folders are listed once work on them has begun, unless the same lesson is already listed.
  for (const LibraryItem& item : lessonsAmong(settings_.recent)) {
    LessonCard card = cardOf(item, true);
    const bool there = std::any_of(cards_.begin(), cards_.end(), [&](const LessonCard& c) {
      return c.file.filename() == card.file.filename() && c.title == card.title;
    });
    if (card.progress && !there) cards_.push_back(std::move(card));
  }
  sort();
}

// The order depends only on each file's front matter, so that it is the same before and after the lessons are read.
void LessonList::sort() {
  std::stable_sort(cards_.begin(), cards_.end(), [](const LessonCard& a, const LessonCard& b) {
    if (a.own != b.own) return b.own;
    const auto item = [](const LessonCard& c) {
      return LibraryItem{c.own ? c.title : c.id, c.title, c.file, c.own ? "" : c.level, c.own ? 0 : c.minutes, c.order};
    };
    return precedes(item(a), item(b));
  });
}

void LessonList::begin(const LessonCard& card) {
  const fs::path lesson = card.file, attempt = card.progress && card.progress->canResume() ? card.progress->file : "";
  if (attempt.empty())
    opener_.open(lesson);
  else
    recorder_.resume(lesson, attempt);
}

fs::path LessonList::add(const fs::path& file) {
  const Expected<fs::path> lesson = addLesson(file, packsFolderOf(options_));
  if (!lesson) {
    messages_.error(lesson.problem().text());
    return {};
  }
  list();
  messages_.notice(trf("On the shelf: {0}", lessonItem(*lesson).label));
  return *lesson;
}

bool LessonList::open(FileKind kind, const fs::path& file) {
  if (kind != FileKind::Pack) return false;
  recorder_.flush();  // the open lesson may be among them
  const fs::path lesson = add(file);
  const auto card = std::find_if(cards_.begin(), cards_.end(), [&](const LessonCard& c) { return c.file == lesson; });
  if (card != cards_.end())
    begin(LessonCard(*card));
  else if (!lesson.empty())
    opener_.open(lesson);
  else
    panels_.pages.welcome = panels_.pages.welcome || !opener_.hasWork();
  return true;
}

const LessonCard* LessonList::after(const fs::path& file) const {
  if (next_ < cards_.size()) return nullptr;
  // The file may have been opened under another path.
  std::error_code error;
  for (std::size_t k = 0; k + 1 < cards_.size(); ++k)
    if (cards_[k + 1].fault.empty() && (cards_[k].file == file || fs::equivalent(cards_[k].file, file, error)))
      return &cards_[k + 1];
  return nullptr;
}

const LessonCard* LessonList::latest() const {
  const LessonCard* best = nullptr;
  for (const LessonCard& c : cards_)
    if (c.progress && c.progress->canResume() && (!best || c.progress->touched > best->progress->touched)) best = &c;
  return best;
}

void LessonList::afterPanels() {
  const bool opened = panels_.pages.welcome && !open_, other_language = listed_in_ != language();
  open_ = panels_.pages.welcome;
  const bool asked = !open_ && lesson_.closing();
  if (opened || ((open_ || asked) && other_language)) list();
  if ((!open_ && !asked) || next_ >= cards_.size()) return;
  read(cards_[next_++]);
}

}  // namespace moltact
