// What moves the atoms of a scene. At most one of a scene's keys may do so. Any thread except the haptic one.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "engine/lesson/lesson.h"

namespace moltact {

/// One key by which a scene names a mover of its atoms.
struct MoverKey {
  std::string_view key;       ///< "trajectory"
  const char* without;        ///< how to leave it out, untranslated (N_): "write 'trajectory: none'"
  bool lockable;              ///< whether a lesson may lock it against the student
  Place ScenePlaces::*place;  ///< where a scene has it
  bool (*moves)(const SceneSpec& scene);
};

/// All of them. A new mover that a scene names is a row in scene_movers.cpp.
std::span<const MoverKey> moverKeys();

/// Those that this scene names, in the order of the table.
std::vector<const MoverKey*> moversOf(const SceneSpec& scene);

}  // namespace moltact
