#include "app/ui/extensions/name_asker.h"

#include <utility>

#include "app/ui/application/application_options.h"
#include "app/ui/application/opener.h"
#include "app/ui/application/panel_state.h"
#include "app/ui/extensions/attempt_recorder.h"
#include "app/ui/extensions/class_turns.h"
#include "app/ui/extensions/learner_known.h"
#include "app/ui/extensions/playback.h"
#include "app/ui/lesson/lesson_guide.h"
#include "engine/core/printable.h"
#include "engine/core/text.h"

namespace moltact {
namespace {

std::string cleaned(const std::string& name) {
  std::string out = oneLine(trimmed(name)), cut;
  std::string_view rest = out;
  for (std::size_t n = 0; n < NameAsker::kLongest && !rest.empty(); ++n) {
    const std::size_t bytes = firstCodePoint(rest).bytes;
    cut += rest.substr(0, bytes);
    rest.remove_prefix(bytes);
  }
  return cut;
}

}  // namespace

std::optional<LessonProgress> NameAsker::lastAttempt(const std::optional<std::string>& student) const {
  const Lesson& lesson = lesson_.session()->lesson();
  for (LessonProgress& p : readProgress(options_.attempts_folder, student))
    if (p.isOf(lesson_.file(), lesson.title)) return std::move(p);
  return std::nullopt;
}

// Keeps the recorder paused until the answer, even if another extension has resumed it.
void NameAsker::beforeTicks() {
  if (!asking_) return;
  recorder_.pause(true);
  if (!assignedCode().empty()) give(assignedCode());
}

void NameAsker::lessonChanged() {
  const bool same = session_ == lesson_.session();  // the lesson was only read again
  session_ = lesson_.session();
  if (!same && std::exchange(asking_, false)) recorder_.pause(false);
  if (same || giving_ || turns_.on() || playback_.on() || options_.attempts_folder.empty()) return;
  const Lesson& lesson = lesson_.session()->lesson();
  // A lesson that does not ask must not record the name given for another lesson.
  if (!recorder_.student().empty() && recorder_.student() == given_) recorder_.forgetStudent();
  if (!lesson.ask.empty() && !learnerKnown()) ask(lesson.ask == "code");
}

void NameAsker::ask(bool code) {
  recorder_.finish();
  panels_.lesson_memory.teacher_notes = false;
  asking_ = true;
  code_ = code;
  draft = given_;
  if (draft.empty())
    if (const auto last = lastAttempt()) draft = last->student;
  recorder_.pause(true);  // events before the answer belong to no student
}

void NameAsker::give(const std::string& name) {
  if (!asking_) return;
  asking_ = false;
  given_ = cleaned(name);
  recorder_.pause(false);
  giving_ = true;
  const std::filesystem::path lesson = lesson_.file();
  const std::optional<LessonProgress> last = given_.empty() ? std::nullopt : lastAttempt(given_);
  if (last && last->canResume()) {
    recorder_.resume(lesson, last->file);
  } else if (!given_.empty()) {
    recorder_.passTo(given_);
  } else {
    recorder_.forgetStudent();
    opener_.open(lesson);
  }
  giving_ = false;
}

}  // namespace moltact
