// While this object lives, the controls that are drawn are disabled if the lesson locks their key. The student sees
// their values but cannot change them. Window's thread.
#pragma once

#include <imgui.h>

#include <string_view>

namespace moltact {

class Application;

class WhileLocked {
 public:
  /// `key`: the key of a scene: "force", "probe".
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
