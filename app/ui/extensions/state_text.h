// The contact in words, for users who cannot see the view well. A line in the window changes at a readable pace; lines
// in a terminal or file are for speech output. To a screen reader the window is only a picture; printed text works with
// each of them (Orca or BRLTTY in a terminal, `moltact --state-text - | spd-say -e`). Window's thread.
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
class RevealPolicy;

class StateText : public Extension {
 public:
  StateText(const RevealPolicy& policy, const HapticSession& scene, const LessonGuide& lesson, const PanelState& panels,
            const FrameTime& time)
      : scene_(scene), lesson_(lesson), panels_(panels), time_(time), policy_(policy) {}

  /// Writes lines to this file, which is emptied first, or to standard output for "-": the step, the task's
  /// instruction, the contact. Returns a Problem on failure.
  std::optional<Problem> writeTo(const std::filesystem::path& file);

  void stepChanged() override;
  void afterPanels() override;
  bool live() const override { return owing_; }

  /// The contact in words, updated at a readable pace, with the force that the window displays.
  std::string line(const HapticSession& scene) const;
  /// Whether line() describes a contact, not its absence.
  bool tellsContact() const { return tells_contact_; }
  /// The atoms that line() names, or nothing.
  std::optional<std::array<std::int32_t, 3>> namedAtoms() const {
    return tells_contact_ && !tells_unnamed_ ? std::optional(named_atoms_) : std::nullopt;
  }

 private:
  const HapticSession& scene_;
  const LessonGuide& lesson_;
  const PanelState& panels_;
  const FrameTime& time_;
  const RevealPolicy& policy_;
  void write(const std::string& line);

  StateLine reading_{StateLine::reading()}, speaking_{StateLine::speaking()}, task_{StateLine::speaking()};
  std::optional<AppendFile> file_;
  std::string word_;  // the glossary word explained last
  bool to_terminal_ = false;
  bool tells_contact_ = false, tells_unnamed_ = false;
  std::array<std::int32_t, 3> named_atoms_{-1, -1, -1};
  bool owing_ = false;  // a change is not written yet
};

}  // namespace moltact
