// The state in words for those who cannot see the view well: a line at a pace that can be read, and lines in a terminal
// or a file that a screen reader or speech follows. To a screen reader the window itself is a picture; printed text is
// what works with each of them (Orca or BRLTTY in a terminal, `moltact --state-text - | spd-say -e`). Window's thread.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "app/ui/application/extension.h"
#include "app/ui/scene/state_line.h"
#include "engine/core/problem.h"
#include "engine/platform/append_file.h"

namespace moltact {

class LessonGuide;
struct PanelState;
class HapticSession;
class Unseen;

class StateText : public Extension {
 public:
  StateText(const Unseen& unseen, const HapticSession& scene, const LessonGuide& lesson, const PanelState& panels,
            const FrameTime& time)
      : scene_(scene), lesson_(lesson), panels_(panels), time_(time), unseen_(unseen) {}

  /// From now on lines go to this file, which is emptied first, or to standard output for "-": the step, what its task
  /// asks for, what is touched. Returns what went wrong, or nothing.
  std::optional<Problem> writeTo(const std::filesystem::path& file);

  void stepChanged() override;
  void afterPanels() override;
  bool live() const override { return owing_; }

  /// The contact in words, updated at a pace that can be read, with the figure of the force that the window shows.
  std::string line(const HapticSession& scene) const;
  /// line() tells of a contact, and not that there is none or why.
  bool tellsContact() const { return tells_contact_; }
  /// The atoms that line() names; none where it names none.
  std::optional<std::array<std::int32_t, 3>> namedAtoms() const {
    return tells_contact_ && !tells_unnamed_ ? std::optional(named_atoms_) : std::nullopt;
  }

 private:
  const HapticSession& scene_;
  const LessonGuide& lesson_;
  const PanelState& panels_;
  const FrameTime& time_;
  const Unseen& unseen_;
  void write(const std::string& line);

  StateLine reading_{StateLine::reading()}, speaking_{StateLine::speaking()}, task_{StateLine::speaking()};
  std::optional<AppendFile> file_;
  std::string word_;  // whose meaning was told last
  bool to_terminal_ = false;
  bool tells_contact_ = false, tells_unnamed_ = false;
  std::array<std::int32_t, 3> named_atoms_{-1, -1, -1};
  bool owing_ = false;  // a change has not been written yet
};

}  // namespace moltact
