#include "app/ui/extensions/name_asker.h"

#include <optional>
#include <utility>

#include "app/ui/application/application.h"
#include "app/ui/extensions/attempt_recorder.h"
#include "app/ui/extensions/class_turns.h"
#include "app/ui/extensions/playback.h"
#include "engine/core/printable.h"
#include "engine/core/text.h"
#include "engine/results/progress.h"

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

std::optional<LessonProgress> lastAttempt(const Application& app, const std::optional<std::string>& student = {}) {
  const Lesson& lesson = app.lesson.session()->lesson();
  for (LessonProgress& p : readProgress(app.options().attempts_folder, student))
    if (p.isOf(app.lesson.file(), lesson.title)) return std::move(p);
  return std::nullopt;
}

}  // namespace

// Whatever else has paused the recorder and lets it go on: not before the answer.
void NameAsker::beforeTicks(Application&) {
  if (asking_) recorder_.pause(true);
}

void NameAsker::lessonChanged(Application& app) {
  const bool same = session_ == app.lesson.session();  // read again
  session_ = app.lesson.session();
  if (!same && std::exchange(asking_, false)) recorder_.pause(false);
  if (same || giving_ || turns_.on() || playback_.on() || app.options().attempts_folder.empty()) return;
  const Lesson& lesson = app.lesson.session()->lesson();
  // A lesson that does not ask does not get a name that was given to another.
  if (!recorder_.student().empty() && recorder_.student() == given_) recorder_.forgetStudent();
  if (!lesson.ask.empty()) ask(app, lesson.ask == "code");
}

void NameAsker::ask(Application& app, bool code) {
  recorder_.finish();
  app.panels.teacher_notes = false;
  asking_ = true;
  code_ = code;
  draft = given_;
  if (draft.empty())
    if (const auto last = lastAttempt(app)) draft = last->student;
  recorder_.pause(true);  // what comes before the answer is nobody's
}

void NameAsker::give(Application& app, const std::string& name) {
  if (!asking_) return;
  asking_ = false;
  given_ = cleaned(name);
  recorder_.pause(false);
  giving_ = true;
  const std::filesystem::path lesson = app.lesson.file();
  const std::optional<LessonProgress> last = given_.empty() ? std::nullopt : lastAttempt(app, given_);
  if (last && last->canResume()) {
    recorder_.resume(app, lesson, last->file);
  } else if (!given_.empty()) {
    recorder_.passTo(app, given_);
  } else {
    recorder_.forgetStudent();
    app.open(lesson);
  }
  giving_ = false;
}

}  // namespace moltact
