// What may be told of a contact, and when a molecule that was felt unseen is shown. Each panel, sound and text asks here.
// A task may ask what is touched, the screen may be dark, or the scene may draw nothing: then nothing that is written,
// spoken, sounded or outlined says more of a contact than its force does. What was unseen fades in once no task and no
// question depends on it. Window's thread.
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

class Unseen final : public Extension {
 public:
  static constexpr double kFade_s = 1.0;

  Unseen(const TaskStager& stager, HapticSession& scene, LessonGuide& lesson, const Settings& settings,
         ViewPicture& picture, const FrameTime& time)
      : stager_(stager), scene_(scene), lesson_(lesson), settings_(settings), picture_(picture), time_(time) {}

  void beforeTicks() override;
  void stepChanged() override;
  bool live() const override { return veil_s_ < kFade_s; }

  /// Whether the atoms of a contact, or how many of them hold the probe, may be told in words, by outlines or by sound.
  bool names(const Contact& contact) const;
  /// Nothing of the step's molecule is to be seen, and the hand finds its way without: in the dark, and in a scene of a
  /// lesson that draws nothing.
  bool all() const { return unseen_; }
  /// The contact in words as far as it may be told where `names` is false: "touching", and where the force is shown how
  /// great it is and whereto it pushes. `spoken` leaves the force's figure out, which trembles.
  std::string unnamedText(bool spoken) const;
  /// What may be heard of a tick: its force and the speed of its contact point, and what holds the probe where that may be
  /// told.
  TouchMoment heard(const ServoSample& sample, double slide_A_per_s) const;
  /// The parts of the picture without those that outline what may not be told.
  ViewPartSet shownParts() const;

  /// How strongly what was there before still covers the picture (1 to 0) while the molecule fades in.
  double veil() const { return 1.0 - veil_s_ / kFade_s; }
  /// What covers it: the ground of the dark; else the picture that was kept.
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
  AtomList hidden_, revealed_;  // what the scene hides, where it is shown; and what stays hidden of it
  double veil_s_ = kFade_s;
  bool unseen_ = false, dark_ = false, dark_veil_ = false;
};

}  // namespace moltact
