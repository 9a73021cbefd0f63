// The lessons that can be begun, as the welcome page shows them: the program's, and the person's own, which are those
// in a folder of theirs, those of packs that were opened or added, and those that were begun from anywhere else.
// Lessons are read one a frame while the page is open, so that a full shelf does not stop it. Window's thread.
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
  std::string id;           ///< the file's name without its ending and language
  std::string title;        ///< the file's name until it has been read
  std::string level;        ///< as the author wrote it; may be empty
  std::string description;  ///< one line of the author's; may be empty
  int order = 0;            ///< its place among the others, 0: none
  int minutes = 0;          ///< of its core; 0 until it has been read
  bool own = false;         ///< the person's own
  bool read = false;
  std::string fault;                       ///< why it cannot be opened; empty when it can
  std::optional<SceneSpec> scene;          ///< of its first step
  MoleculeKey molecule;                    ///< the scene's; empty where its file is not found
  std::optional<LessonProgress> progress;  ///< none: never begun
};

struct ApplicationOptions;
class AttemptRecorder;
class LessonGuide;
class Messages;
class Opener;
struct PanelState;

class LessonShelf : public Extension {
 public:
  LessonShelf(AttemptRecorder& recorder, Opener& opener, const LessonGuide& lesson, const Settings& settings,
              Messages& messages, PanelState& panels, const ApplicationOptions& options)
      : opener_(opener),
        lesson_(lesson),
        settings_(settings),
        messages_(messages),
        panels_(panels),
        options_(options),
        recorder_(recorder) {}

  /// The program's lessons, then the person's own; of each first those to which their authors gave a place, in that
  /// order, then the program's by level and the own by title. Each in the language in use where it has it.
  const std::vector<LessonCard>& cards() const { return cards_; }
  /// The lesson to go on with: the one touched last, where it was not finished. Null without one.
  const LessonCard* latest() const;

  /// Opens a lesson where it was left, or at its beginning. One that asks for a name goes on when that is given.
  void begin(const LessonCard& card);
  /// Puts a pack, or a lesson file with all that it needs, on the shelf; tells what came of it. Empty where that cannot
  /// be.
  std::filesystem::path add(const std::filesystem::path& file);

  /// A pack: put on the shelf and begun.
  bool open(FileKind kind, const std::filesystem::path& file) override;
  /// The lesson that stands after this file's; null where none does, or the shelf has not been read yet.
  const LessonCard* after(const std::filesystem::path& file) const;
  /// Reads the lessons again while the welcome page is open, starting when it is opened; once too for the closing
  /// page of a lesson, which tells what comes next.
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
  std::size_t next_ = 0;   // the card to be read
  std::string listed_in_;  // the language
  bool open_ = false;      // the page was open in the last frame
};

/// Where the person's own lessons are looked for: the folder of the settings, else ownLessonsFolder().
std::filesystem::path lessonFolderOf(const Settings& settings);
/// Where packs are unpacked: the folder of the options, else packsFolder().
std::filesystem::path packsFolderOf(const ApplicationOptions& options);

}  // namespace moltact
