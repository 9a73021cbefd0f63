// Owners of OpenGL objects and the two things made from them: a shader program and a framebuffer.
// All calls need the context current in which the object was made.
#pragma once

#include <string>
#include <utility>

#include "engine/core/problem.h"
#include "engine/render/gl.h"

namespace moltact {

/// A shader program; 0 until built.
class GlProgram {
 public:
  GlProgram() = default;
  ~GlProgram() { reset(0); }
  GlProgram(GlProgram&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  GlProgram& operator=(GlProgram&& other) noexcept {
    reset(std::exchange(other.id_, 0));
    return *this;
  }

  /// Compiles and links; `name` appears in the problem beside the compiler's own words. "#version" and what goes with it is put in front.
  static Expected<GlProgram> build(const std::string& name, const std::string& vertex, const std::string& fragment);

  GLuint id() const { return id_; }
  GLint uniform(const char* name) const { return glGetUniformLocation(id_, name); }

 private:
  void reset(GLuint id) {
    if (id_) glDeleteProgram(id_);
    id_ = id;
  }
  GLuint id_ = 0;
};

/// Colour and depth textures of one size, drawn into as a framebuffer.
class GlTarget {
 public:
  GlTarget() = default;
  ~GlTarget();
  GlTarget(const GlTarget&) = delete;
  GlTarget& operator=(const GlTarget&) = delete;

  /// Makes new textures if the size differs. Returns false if the driver refuses the size.
  bool resize(int width_px, int height_px);
  void bind() const;

  GLuint framebuffer() const { return framebuffer_; }
  GLuint colour() const { return colour_; }
  GLuint depth() const { return depth_; }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  GLuint framebuffer_ = 0, colour_ = 0, depth_ = 0;
  int width_ = 0, height_ = 0;
};

/// A texture of bytes in three dimensions, between whose middles the card interpolates.
class GlVolume {
 public:
  GlVolume() = default;
  ~GlVolume();
  GlVolume(const GlVolume&) = delete;
  GlVolume& operator=(const GlVolume&) = delete;

  /// Replaces what it holds: bytes with x running fastest, then y.
  void upload(int width, int height, int depth, const void* bytes);
  /// Binds it to a texture unit (0 for the first); an empty one is made where nothing was uploaded.
  void bind(unsigned unit);

 private:
  GLuint texture_ = 0;
};

/// A vertex array with one vertex buffer that is filled for each picture.
class GlStream {
 public:
  GlStream() = default;
  ~GlStream();
  GlStream(const GlStream&) = delete;
  GlStream& operator=(const GlStream&) = delete;

  /// Binds the vertex array, making it at first use; returns whether the attributes still have to be named.
  bool bind();
  /// Replaces the vertices.
  void upload(const void* data, std::size_t bytes);
  /// Makes sure that the element buffer holds the two triangles of that many quads.
  void reserveQuads(std::size_t quads);

  /// Names attribute `index` of the bound array.
  static void floats(GLuint index, int count, std::size_t stride, std::size_t offset);
  static void bytes4(GLuint index, std::size_t stride, std::size_t offset);

 private:
  GLuint array_ = 0, vertices_ = 0, elements_ = 0;
  std::size_t quads_ = 0;
};

}  // namespace moltact
