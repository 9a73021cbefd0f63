// Asks the student for a name or code when a lesson that requires one is opened (front matter "ask"), and restores the
// earlier work under it. Nothing is recorded before the answer, which may be empty.
// app/ui/panels/lesson/name_question.cpp draws it. Window's thread.
#pragma once

#include <optional>
#include <string>

#include "app/ui/application/extension.h"
#include "engine/results/progress.h"

namespace moltact {

struct ApplicationOptions;
class AttemptRecorder;
class ClassTurns;
class LessonGuide;
class Opener;
struct PanelState;
class Playback;

class NameAsker : public Extension {
 public:
  NameAsker(AttemptRecorder& recorder, const ClassTurns& turns, const Playback& playback, Opener& opener,
            const LessonGuide& lesson, PanelState& panels, const ApplicationOptions& options)
      : opener_(opener),
        lesson_(lesson),
        panels_(panels),
        options_(options),
        recorder_(recorder),
        turns_(turns),
        playback_(playback) {}

  /// Asks for a name, or with `code` for a code, for the open lesson. Ends the attempt so far.
  void ask(bool code);
  bool asking() const { return asking_; }
  bool asksForCode() const { return code_; }
  /// The text being typed; initially the last answer, here or in this lesson's last attempt.
  std::string draft;

  /// The student's answer; empty: works without a name. The lesson continues where this name left it, or begins.
  void give(const std::string& name);

  static constexpr std::size_t kLongest = 60;  ///< maximum length of a name; longer ones are cut (unit: character)

  void beforeTicks() override;
  void lessonChanged() override;

 private:
  Opener& opener_;
  const LessonGuide& lesson_;
  PanelState& panels_;
  const ApplicationOptions& options_;
  AttemptRecorder& recorder_;
  const ClassTurns& turns_;
  const Playback& playback_;
  // The last attempt at the open lesson by this student, or by any student.
  std::optional<LessonProgress> lastAttempt(const std::optional<std::string>& student = {}) const;

  bool asking_ = false, code_ = false;
  bool giving_ = false;            // give() is reopening the lesson for the name
  const void* session_ = nullptr;  // the session of the last call
  std::string given_;              // the last answer
};

}  // namespace moltact
