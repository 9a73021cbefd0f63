// An OpenGL 3.3 core context without window or display, for image files and tests. It falls back to software rendering
// without a graphics card. Uses EGL. Belongs to the thread that created it.
#pragma once

#include <memory>

#include "engine/core/problem.h"

namespace moltact {

class OffscreenGl {
 public:
  /// Creates a context and makes it current on this thread. Returns a Problem with the reason if EGL or OpenGL 3.3 is
  /// missing.
  static Expected<std::unique_ptr<OffscreenGl>> create();
  ~OffscreenGl();
  OffscreenGl(const OffscreenGl&) = delete;
  OffscreenGl& operator=(const OffscreenGl&) = delete;

  /// Makes the context current again. Returns false if the driver refuses.
  bool makeCurrent();

 private:
  OffscreenGl() = default;
  void* display_ = nullptr;
  void* context_ = nullptr;
  void* surface_ = nullptr;
};

}  // namespace moltact
