#include "app/ui/widgets/picture_texture.h"

#include "app/ui/widgets/imgui_versions.h"

namespace moltact {

PictureTexture::~PictureTexture() {
  if (id_) glDeleteTextures(1, &id_);
}

void PictureTexture::show(const Picture& p) {
  if (!id_) glGenTextures(1, &id_);
  GLint bound = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  glBindTexture(GL_TEXTURE_2D, id_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, p.width_px, p.height_px, 0, GL_RGB, GL_UNSIGNED_BYTE, p.rgb.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_2D, GLuint(bound));
}

ImTextureID PictureTexture::id() const { return textureOf(id_); }

}  // namespace moltact
