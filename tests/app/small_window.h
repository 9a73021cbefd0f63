// A small window, for tests that need no panels.
#pragma once

#include <algorithm>
#include <filesystem>

#include "tests/app/scripted_user_fixture.h"

namespace moltact {

/// Attempts are written to `folder`; an empty one: none are.
inline ScriptedUser::Options smallWindow(const std::filesystem::path& folder = {}) {
  ScriptedUser::Options options;
  options.width = 1000;
  options.height = 600;
  options.application.attempts_folder = folder;
  return options;
}

/// The greatest distance of a drawn atom from its place in this list.
inline double farthestFrom_A(ScriptedUser& user, const SharedArray<Sphere>& places) {
  const SharedArray<Sphere>& now = user.app().scene.atoms().seen()->spheres;
  double out = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i)
    out = std::max(out, glm::distance(now[i].centre_A, places[i].centre_A));
  return out;
}

/// Presses in the middle of the view, and leads the hand into it by 40 notches of the wheel.
inline void pressDeep(ScriptedUser& user) {
  user.point("view", 0.5, 0.5);
  user.press();
  for (int k = 0; k < 40; ++k) {
    user.wheel(1.0);
    user.frames(2);
  }
}

}  // namespace moltact
