// A picture of the renderer as a texture that ImGui draws. Window's thread, while its OpenGL context is current.
#pragma once

#include <imgui.h>

#include "engine/render/gl.h"
#include "engine/render/picture.h"

namespace moltact {

class PictureTexture {
 public:
  PictureTexture() = default;
  ~PictureTexture();
  PictureTexture(const PictureTexture&) = delete;
  PictureTexture& operator=(const PictureTexture&) = delete;

  /// Replaces the texture's picture. The first row is at the top.
  void show(const Picture& picture);
  bool empty() const { return id_ == 0; }
  /// Null before the first picture.
  ImTextureID id() const;

 private:
  GLuint id_ = 0;
};

}  // namespace moltact
