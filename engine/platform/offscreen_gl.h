// An OpenGL 3.3 core context without a window or a display, in software where there is no graphics card: for pictures
// to a file and for tests. Uses EGL. Belongs to the thread that made it.
#pragma once

#include <memory>

#include "engine/core/problem.h"

namespace moltact {

class OffscreenGl {
 public:
  /// Makes a context and makes it current on this thread. Fails with the reason where EGL or OpenGL 3.3 is missing.
  static Expected<std::unique_ptr<OffscreenGl>> create();
  ~OffscreenGl();
  OffscreenGl(const OffscreenGl&) = delete;
  OffscreenGl& operator=(const OffscreenGl&) = delete;

  /// Makes it current again after another context was. Returns false where the driver refuses.
  bool makeCurrent();

 private:
  OffscreenGl() = default;
  void* display_ = nullptr;
  void* context_ = nullptr;
  void* surface_ = nullptr;
};

}  // namespace moltact
