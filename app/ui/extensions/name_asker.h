// Asks a student for a name or code when a lesson is opened that wants one (front matter "ask"), and takes up what was
// done under it before. Nothing is kept until there is an answer; none is an answer too. app/ui/panels/lesson/name_question.cpp
// draws it. Window's thread.
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

  /// Asks for a name, or with `code` for a code, about the lesson that is open; what was done in it until now is over.
  void ask(bool code);
  bool asking() const { return asking_; }
  bool asksForCode() const { return code_; }
  /// What is being written; at first the name that was given last, here or in this lesson's last attempt.
  std::string draft;

  /// The student's answer; empty: works without a name. The lesson goes on where this name left it, or begins.
  void give(const std::string& name);

  static constexpr std::size_t kLongest = 60;  ///< of a name; what is longer is cut (unit: character)

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
  // At the open lesson, of this student; without one, of whoever it was.
  std::optional<LessonProgress> lastAttempt(const std::optional<std::string>& student = {}) const;

  bool asking_ = false, code_ = false;
  bool giving_ = false;            // opens the lesson anew for the name
  const void* session_ = nullptr;  // that was met last
  std::string given_;              // last
};

}  // namespace moltact
