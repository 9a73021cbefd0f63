#include "app/ui/extensions/lesson_watch.h"

#include <algorithm>
#include <chrono>

#include "app/ui/application/application_options.h"
#include "app/ui/application/opener.h"
#include "app/ui/widgets/messages.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/lesson_files.h"
#include "engine/platform/background.h"
#include "engine/platform/folders.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

constexpr double kPoll_s = 0.25;
constexpr double kGone_s = 3.0;       // editors that save via another file remove it for a moment
constexpr double kLookAgain_s = 2.0;  // a missing picture or molecule is looked for again at this interval
constexpr const char* kSaveAgain = N_("save it again, or open another lesson");

LessonCheck checkNow(const std::string& name, const std::string& bytes, LessonMolecules& molecules) {
  return checkLesson(name, bytes, [&](const NamedMolecule& molecule) { return molecules.find(name, molecule); });
}

}  // namespace

LessonWatch::Look LessonWatch::lookAt(const fs::path& file) {
  std::error_code error;
  Look look;
  look.there = fs::is_regular_file(file, error);
  if (!look.there) return look;
  look.written = fs::last_write_time(file, error);
  look.bytes = fs::file_size(file, error);
  if (error) look = {};
  return look;
}

bool LessonWatch::shown(const LessonGuide& lesson) const { return lesson.session() && lesson.file() == file_; }

void LessonWatch::watch(const fs::path& file) {
  file_ = file;
  seen_ = lookAt(file);
  read_ = {};
  bytes_.clear();
  since_poll_s_ = unreadable_s_ = 0.0;
  changed_ = stale_ = false;
  faults_.clear();
  errors_ = 0;
}

void LessonWatch::lessonChanged() {
  if (lesson_.openings() == own_opening_ && lesson_.file() == file_) return;
  watch(lesson_.file());
  // Without background threads, the program's own lessons are not checked until they change.
  if (!threadsAvailable() && file_.parent_path() == lessonsFolder()) {
    read_ = seen_;
    return;
  }
  begin();
}

void LessonWatch::lessonRefused(const fs::path& file) {
  watch(file);
  // A file that the user has just chosen is reported at once.
  const Expected<std::string> bytes = readLessonFile(file);
  if (bytes && !bytes->empty()) return begin();
  list({{}, {bytes ? Problem{file.string(), 0, 0, tr("the file is empty"), tr(kSaveAgain)} : bytes.problem()}, {}});
  read_ = seen_;
}

void LessonWatch::beforeTicks() {
  if (running_.valid() && (options_.clock == ServoClock::Frames ||
                           running_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)) {
    LessonCheck check = running_.get();
    if (checking_ == file_) onLoaded(std::move(check));
  }
  since_check_s_ += time_.dt_s;
  since_poll_s_ += time_.dt_s;
  if (file_.empty() || running_.valid() || since_poll_s_ < kPoll_s) return;
  since_poll_s_ = 0.0;
  poll();
}

void LessonWatch::poll() {
  const Look now = lookAt(file_);
  const bool settled = now == seen_;
  seen_ = now;
  if (!now.there || now.bytes == 0) {
    unreadable_s_ += kPoll_s;
    if (unreadable_s_ < kGone_s || now == read_) return;
    read_ = now;
    list({{},
          {{file_.string(), 0, 0, now.there ? tr("the file is empty") : tr("the file is gone"), tr(kSaveAgain)}},
          {}});
    return;
  }
  unreadable_s_ = 0.0;
  // Wait while the file still changes.
  if (!settled) return;
  if (now != read_ || (errors_ > 0 && since_check_s_ > kLookAgain_s)) begin();
}

void LessonWatch::begin() {
  // Let a running check finish first; the next poll starts another.
  if (running_.valid()) return;
  const Look before = lookAt(file_);
  Expected<std::string> bytes = readLessonFile(file_);
  // The file is missing or has changed meanwhile; the next poll sees it.
  if (!bytes || bytes->empty() || lookAt(file_) != before) return;
  read_ = before;
  checking_ = file_;
  since_check_s_ = 0.0;
  pending_bytes_ = *std::move(bytes);
  const auto work = [name = file_.string(), text = pending_bytes_, molecules = molecules_] {
    return checkNow(name, text, *molecules);
  };
  running_ = inBackground(work);
}

void LessonWatch::onLoaded(LessonCheck check) {
  const bool is_shown = shown(lesson_), first = is_shown && bytes_.empty() && !changed_;
  if (first) {
    // The lesson was just opened: its text is on the screen, even with faults.
    bytes_ = pending_bytes_;
    list(check);
    return;
  }
  const bool another = pending_bytes_ != bytes_;
  changed_ = changed_ || another;
  stale_ = another;
  list(check);
  if (!check.errors.empty() || !check.lesson) return;
  if (!is_shown) {
    // A copy, because opening the file changes file_.
    opener_.open(fs::path(file_));
    return;
  }
  if (!another) return;
  bytes_ = pending_bytes_;
  lesson_.replace(*std::move(check.lesson));
  own_opening_ = lesson_.openings();
  scene_.force().startSoftly();
  messages_.notice(trf("Read again: {0}", file_.filename().string()));
}

void LessonWatch::list(const LessonCheck& check) {
  faults_.clear();
  errors_ = check.errors.size();
  for (const Problem& p : check.errors) faults_.push_back({true, p});
  if (errors_ > 0 || changed_)
    for (const Problem& p : check.warnings) faults_.push_back({false, p});
  std::stable_sort(faults_.begin(), faults_.end(),
                   [](const Fault& a, const Fault& b) { return a.problem.line < b.problem.line; });
  // No further check is expected soon, so the molecules are released.
  if (faults_.empty() && !changed_) molecules_ = std::make_shared<LessonMolecules>();
}

}  // namespace moltact
