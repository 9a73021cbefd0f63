// The lessons on the welcome page: the program's and the user's own. The user's own are those in the lesson folder,
// those from packs that were opened or added, and others that were begun. Lessons are read one per frame while the page
// is open, so that many lessons do not block it. Window's thread.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/application/extension.h"
#include "app/ui/files/settings.h"
#include "engine/lesson/lesson.h"
#include "engine/results/progress.h"

namespace moltact {

struct LessonCard {
  std::filesystem::path file;
  std::string id;           ///< the file's name without extension and language
  std::string title;        ///< the file's name until the lesson has been read
  std::string level;        ///< the author's text; may be empty
  std::string description;  ///< one line by the author; may be empty
  int order = 0;            ///< position among the lessons; 0: not given
  int minutes = 0;          ///< duration of its core; 0 until the lesson has been read
  bool own = false;         ///< one of the user's own lessons
  bool read = false;
  std::string fault;                       ///< why it cannot be opened; empty if it can
  std::optional<SceneSpec> scene;          ///< of its first step
  MoleculeKey molecule;                    ///< the scene's molecule; empty if its file is not found
  std::optional<LessonProgress> progress;  ///< empty: never begun
};

struct ApplicationOptions;
class AttemptRecorder;
class LessonGuide;
class Messages;
class Opener;
struct PanelState;

class LessonList : public Extension {
 public:
  LessonList(AttemptRecorder& recorder, Opener& opener, const LessonGuide& lesson, const Settings& settings,
             Messages& messages, PanelState& panels, const ApplicationOptions& options)
      : opener_(opener),
        lesson_(lesson),
        settings_(settings),
        messages_(messages),
        panels_(panels),
        options_(options),
        recorder_(recorder) {}

  /// The program's lessons, then the user's own. In each group, lessons with a position come first in that order; then
  /// the program's lessons by level and the user's own by title. Each is in the language in use if available.
  const std::vector<LessonCard>& cards() const { return cards_; }
  /// The unfinished lesson with the most recent attempt, or null.
  const LessonCard* latest() const;

  /// Opens a lesson where it was left, or at its beginning. A lesson that asks for a name continues after the answer.
  void begin(const LessonCard& card);
  /// Adds a pack, or a lesson's file with all files that it needs, and reports the result in a message. Returns the
  /// lesson's file, empty on failure.
  std::filesystem::path add(const std::filesystem::path& file);

  /// Adds a pack and begins its lesson.
  bool open(FileKind kind, const std::filesystem::path& file) override;
  /// The lesson that follows this file's lesson; null if there is none or the lessons have not been read yet.
  const LessonCard* after(const std::filesystem::path& file) const;
  /// Reads the lessons whenever the welcome page is opened, one per frame, and once for a lesson's closing page, which
  /// suggests the next lesson.
  void afterPanels() override;
  bool live() const override { return next_ < cards_.size(); }

 private:
  Opener& opener_;
  const LessonGuide& lesson_;
  const Settings& settings_;
  Messages& messages_;
  PanelState& panels_;
  const ApplicationOptions& options_;
  void list();
  void sort();

  AttemptRecorder& recorder_;
  std::vector<LessonCard> cards_;
  std::size_t next_ = 0;   // the next card to read
  std::string listed_in_;  // the language of the list
  bool open_ = false;      // the page was open in the last frame
};

/// The folder of the user's own lessons: that of the settings, else ownLessonsFolder().
std::filesystem::path lessonFolderOf(const Settings& settings);
/// The folder for unpacked packs: that of the options, else packsFolder().
std::filesystem::path packsFolderOf(const ApplicationOptions& options);

}  // namespace moltact
