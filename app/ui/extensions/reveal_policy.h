// Decides what may be revealed of a contact, and when a molecule that was felt unseen is shown. All panels, sounds and
// texts query it. A task may ask what is touched, the screen may be dark, or the scene may draw nothing. Then no text,
// sound or outline reveals more of a contact than its force. The molecule fades in once no task and no question depends
// on it. Window's thread.
#pragma once

#include <memory>
#include <string>

#include "app/ui/application/extension.h"
#include "engine/render/view_scene.h"
#include "engine/sound/touch_synth.h"

namespace moltact {

class LessonGuide;
class TaskStager;
class ViewPicture;
struct Settings;

class RevealPolicy final : public Extension {
 public:
  static constexpr double kFade_s = 1.0;

  RevealPolicy(const TaskStager& stager, HapticSession& scene, LessonGuide& lesson, const Settings& settings,
               ViewPicture& picture, const FrameTime& time)
      : stager_(stager), scene_(scene), lesson_(lesson), settings_(settings), picture_(picture), time_(time) {}

  void beforeTicks() override;
  void stepChanged() override;
  bool live() const override { return veil_s_ < kFade_s; }

  /// Whether words, outlines or sound may reveal the contact's atoms or their number.
  bool names(const Contact& contact) const;
  /// Whether the step's molecule is invisible: in the dark, and in a lesson's scene that draws nothing.
  bool all() const { return unseen_; }
  /// Whether a task asks about forces between atoms, which may hold a probe off the surface: even whether it touches would
  /// be an answer.
  bool hidesTouch() const;
  /// Whether the energy between atoms may be shown and heard. Not while a task asks about forces between atoms or about
  /// what is touched; where the molecule is invisible, only if the force is displayed.
  bool tellsEnergy() const;
  /// "touching", "a force is felt" or "not touching"; if hidesTouch(), always the same.
  const char* touchWord() const;
  /// The contact in words if names() is false: "touching" and, if the force is displayed, its magnitude and direction.
  /// `spoken` omits the magnitude, which fluctuates.
  std::string unnamedText(bool spoken) const;
  /// The sound's input for a tick: force and speed of the contact point, and the feature if it may be revealed. The number
  /// of a held body's contacts is that of the frame's last tick. The energy is that of the atoms where tellsEnergy().
  TouchMoment heard(const ServoSample& sample, double slide_A_per_s) const;
  /// The visible parts, without those that outline what must not be revealed.
  ViewPartSet shownParts() const;

  /// The opacity of the previous picture while the molecule fades in (1 to 0).
  double veil() const { return 1.0 - veil_s_ / kFade_s; }
  /// Whether the veil is the dark background; otherwise it is the stored picture.
  bool veilIsDark() const { return dark_veil_; }

 private:
  bool dependsOnUnseen() const;
  void show(bool dark_before);
  void followScene();
  void hide(const AtomList& before, const AtomList& now);

  const TaskStager& stager_;
  HapticSession& scene_;
  LessonGuide& lesson_;
  const Settings& settings_;
  ViewPicture& picture_;
  const FrameTime& time_;
  AtomList hidden_, revealed_;  // atoms that the scene hides, where they are shown; those that stay hidden
  double veil_s_ = kFade_s;
  bool unseen_ = false, dark_ = false, dark_veil_ = false;
};

}  // namespace moltact
