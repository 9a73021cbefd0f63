// The extensions of the window, one member each. Window's thread.
#pragma once

#include <array>

#include "app/ui/extensions/atom_movers.h"
#include "app/ui/extensions/attempt_recorder.h"
#include "app/ui/extensions/card_pictures.h"
#include "app/ui/extensions/class_turns.h"
#include "app/ui/extensions/device_link.h"
#include "app/ui/extensions/force_faults.h"
#include "app/ui/extensions/hand_model.h"
#include "app/ui/extensions/hand_recorder.h"
#include "app/ui/extensions/held_poses.h"
#include "app/ui/extensions/lesson_list.h"
#include "app/ui/extensions/lesson_locks.h"
#include "app/ui/extensions/lesson_pictures.h"
#include "app/ui/extensions/lesson_watch.h"
#include "app/ui/extensions/measuring.h"
#include "app/ui/extensions/name_asker.h"
#include "app/ui/extensions/own_look.h"
#include "app/ui/extensions/playback.h"
#include "app/ui/extensions/potential_colours.h"
#include "app/ui/extensions/reveal_policy.h"
#include "app/ui/extensions/scene_change.h"
#include "app/ui/extensions/scene_history.h"
#include "app/ui/extensions/settings_keeper.h"
#include "app/ui/extensions/state_text.h"
#include "app/ui/extensions/surface_scan.h"
#include "app/ui/extensions/task_stager.h"
#include "app/ui/extensions/touch_paint.h"
#include "app/ui/extensions/touch_sound.h"

namespace moltact {

class Application;

struct Extensions final : ExtensionSet {
  explicit Extensions(Application& app);
  Extensions(const Extensions&) = delete;  // all_ holds the addresses of the members
  Extensions& operator=(const Extensions&) = delete;

  // Each receives references to the extensions that it uses, which are declared above it.
  SettingsKeeper settings_keeper;
  LessonWatch lesson_watch;
  LessonLocks lesson_locks;
  AtomMovers movers;
  AttemptRecorder recorder;
  ClassTurns turns;
  Playback playback;
  NameAsker name_asker;
  SceneChange scene_change;
  SceneHistory history;
  LessonList lesson_list;
  CardPictures card_pictures;
  LessonPictures lesson_pictures;
  TaskStager task_stager;
  RevealPolicy reveal_policy;
  HandModel hand_model;
  StateText state_text;
  TouchSound touch_sound;
  Measuring measuring;
  OwnLook own_look;
  HeldPoses held_poses;
  SurfaceScan surface_scan;
  PotentialColours potential_colours;
  ForceFaults force_faults;
  TouchPaint touch_paint;
  DeviceLink device;
  HandRecorder hand_recorder;

  float stripHeight() const override;
  std::span<Extension* const> all() const override { return all_; }

 private:
  // The order of the calls. Locks precede the history, so that it never records a change of a locked value. The history
  // precedes the scene change, whose glide it queries. The name is asked for before the recorder begins. The device
  // precedes the hand recorder, which replaces the device's clutch and scale by those of the recording.
  std::array<Extension*, 27> all_{
      &settings_keeper, &lesson_watch, &lesson_locks, &name_asker,   &recorder,          &turns,       &playback,
      &history,         &scene_change, &hand_model,   &lesson_list,  &card_pictures,     &task_stager, &reveal_policy,
      &movers,          &state_text,   &touch_sound,  &measuring,    &touch_paint,       &device,      &hand_recorder,
      &lesson_pictures, &own_look,     &held_poses,   &surface_scan, &potential_colours, &force_faults};
};

}  // namespace moltact
