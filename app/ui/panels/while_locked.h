// Greys out and switches off the controls that are drawn while it lives, where the lesson locks what they set: the
// student sees how it is, and that it is not to be changed. Window's thread.
#pragma once

#include <imgui.h>

#include <string_view>

namespace moltact {

class Application;

class WhileLocked {
 public:
  /// `key` is that of a scene: "force", "probe".
  WhileLocked(const Application& app, std::string_view key);
  ~WhileLocked();
  WhileLocked(const WhileLocked&) = delete;
  WhileLocked& operator=(const WhileLocked&) = delete;

 private:
  bool locked_ = false;
  ImVec2 low_{};
  float width_ = 0.0f;
};

}  // namespace moltact
