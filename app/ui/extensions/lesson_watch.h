// Watches the open lesson's file, so that an author sees changes as soon as they are saved. The lesson is read again,
// the student stays on the same step, and the force restarts from zero. If the file has errors, the last valid lesson
// stays and the panel of lesson problems lists them. Window's thread; the checks run in a thread of their own.
#pragma once

#include <filesystem>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "app/ui/application/extension.h"
#include "app/ui/lesson/lesson_guide.h"
#include "engine/lesson/check.h"
#include "engine/lesson/lesson_molecules.h"

namespace moltact {

struct ApplicationOptions;
class Messages;
class Opener;

class LessonWatch : public Extension {
 public:
  LessonWatch(Opener& opener, HapticSession& scene, LessonGuide& lesson, Messages& messages,
              const ApplicationOptions& options, const FrameTime& time)
      : opener_(opener), scene_(scene), lesson_(lesson), messages_(messages), options_(options), time_(time) {}

  struct Fault {
    bool error = true;  ///< false: a warning
    Problem problem;
  };

  /// The faults of the file in its order. Without errors the list is empty, unless the file has changed since it was
  /// opened: then an author is at work and warnings are listed too.
  const std::vector<Fault>& faults() const { return faults_; }
  std::size_t errors() const { return errors_; }
  /// The file of faults(): the open lesson's, or one that could not be opened.
  const std::filesystem::path& file() const { return file_; }
  /// Whether the lesson on the screen is older than the file, because the file has errors now.
  bool stale() const { return errors_ > 0 && stale_; }
  /// Whether the file is that of the lesson on the screen.
  bool shown(const LessonGuide& lesson) const;

  /// Watches the rejected file and opens it once it is valid.
  void lessonRefused(const std::filesystem::path& file) override;
  void beforeTicks() override;
  void lessonChanged() override;
  bool live() const override { return running_.valid(); }

 private:
  Opener& opener_;
  HapticSession& scene_;
  LessonGuide& lesson_;
  Messages& messages_;
  const ApplicationOptions& options_;
  const FrameTime& time_;
  /// The file's properties that change when an editor saves it.
  struct Look {
    std::filesystem::file_time_type written{};
    std::uintmax_t bytes = 0;
    bool there = false;
    bool operator==(const Look&) const = default;
  };

  static Look lookAt(const std::filesystem::path& file);
  void watch(const std::filesystem::path& file);
  void poll();
  void begin();
  void onLoaded(LessonCheck check);
  void list(const LessonCheck& check);

  std::filesystem::path file_, checking_;
  Look read_, seen_;           // at the last reading, and at the last poll
  std::string bytes_;          // contents of the shown lesson, to detect real changes
  std::string pending_bytes_;  // contents of the lesson that is being checked
  double since_poll_s_ = 0.0, unreadable_s_ = 0.0, since_check_s_ = 0.0;
  std::size_t own_opening_ = 0;  // the lesson guide's count of openings after this watch opened the lesson
  bool changed_ = false;         // since it was opened
  bool stale_ = false;
  std::vector<Fault> faults_;
  std::size_t errors_ = 0;
  std::shared_ptr<LessonMolecules> molecules_ = std::make_shared<LessonMolecules>();  // used by the check while it runs
  std::future<LessonCheck> running_;
};

}  // namespace moltact
