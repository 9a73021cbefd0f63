// The haptic methods there are. A method is added with its own files and one line in methods.cpp.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "engine/haptics/ball_scene.h"
#include "engine/haptics/tracker.h"

namespace moltact {

struct Method {
  std::string_view name;      ///< as in `--method exact`
  std::string_view sentence;  ///< what it is, for the screen and `--help`
  std::unique_ptr<Tracker> (*make)(std::shared_ptr<const BallScene> scene, double probe_A);
};

/// All methods, the default first.
std::span<const Method> methods();

/// The method of that name, or nullptr.
const Method* findMethod(std::string_view name);

}  // namespace moltact
