// Watches the lesson's file while it is open, so that an author sees what was written as soon as it is saved: the
// lesson is read again, the student stays on the same step, and the force starts from nothing. With errors the last
// good lesson stays, and the panel of lesson problems lists them until they are mended. Window's thread; the checking
// has its own.
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

  /// The faults of the file as it is now, in its order: all of them where there are errors, else none; with warnings
  /// too once the file has changed while it was open, for then its author is at work.
  const std::vector<Fault>& faults() const { return faults_; }
  std::size_t errors() const { return errors_; }
  /// The file that `faults` are of: the open lesson's, or one that could not be opened.
  const std::filesystem::path& file() const { return file_; }
  /// The lesson on the screen is not the file as it is now, but as it was before it had errors.
  bool stale() const { return errors_ > 0 && stale_; }
  /// The file is the one of the lesson that is shown.
  bool shown(const LessonGuide& lesson) const;

  /// It is watched, and opened once it can be.
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
  /// How a file looks from outside; editors change at least one of these when they save.
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
  Look read_, seen_;           // as it was when it was last read, and at the last poll
  std::string bytes_;          // of the lesson that is shown, to tell a change from a mere touch
  std::string pending_bytes_;  // of the one that is being checked
  double since_poll_s_ = 0.0, unreadable_s_ = 0.0, since_check_s_ = 0.0;
  std::size_t own_opening_ = 0;  // of the lesson guide, when it was this watch that put the lesson there
  bool changed_ = false;         // since it was opened
  bool stale_ = false;
  std::vector<Fault> faults_;
  std::size_t errors_ = 0;
  std::shared_ptr<LessonMolecules> molecules_ = std::make_shared<LessonMolecules>();  // the check's, while it runs
  std::future<LessonCheck> running_;
};

}  // namespace moltact
