// Owners of OpenGL objects: shader program, framebuffer, volume texture and vertex stream. In every call
// the context that created the object must be current.
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

  /// Compiles and links a program; `name` appears in the Problem with the compiler's message. "#version" and the
  /// precision lines are prepended.
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

/// A framebuffer with colour and depth textures of one size.
class GlTarget {
 public:
  GlTarget() = default;
  ~GlTarget();
  GlTarget(const GlTarget&) = delete;
  GlTarget& operator=(const GlTarget&) = delete;

  /// Creates new textures if the size differs. Returns false if the driver refuses the size.
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

/// A three-dimensional texture of bytes with linear interpolation.
class GlVolume {
 public:
  GlVolume() = default;
  ~GlVolume();
  GlVolume(const GlVolume&) = delete;
  GlVolume& operator=(const GlVolume&) = delete;

  /// Replaces the contents: bytes with x varying fastest, then y.
  void upload(int width, int height, int depth, const void* bytes);
  /// Binds it to a texture unit (from 0); without an upload, an empty texture is created.
  void bind(unsigned unit);

 private:
  GLuint texture_ = 0;
};

/// A vertex array with a vertex buffer, which is refilled for each picture, and an element buffer for quads.
class GlStream {
 public:
  GlStream() = default;
  ~GlStream();
  GlStream(const GlStream&) = delete;
  GlStream& operator=(const GlStream&) = delete;

  /// Binds the vertex array and creates it at first use; returns true if the attributes must be defined.
  bool bind();
  /// Replaces the vertices.
  void upload(const void* data, std::size_t bytes);
  /// Ensures that the element buffer contains the two triangles of that number of quads.
  void reserveQuads(std::size_t quads);

  /// Defines attribute `index` of the bound array.
  static void floats(GLuint index, int count, std::size_t stride, std::size_t offset);
  static void bytes4(GLuint index, std::size_t stride, std::size_t offset);

 private:
  GLuint array_ = 0, vertices_ = 0, elements_ = 0;
  std::size_t quads_ = 0;
};

}  // namespace moltact
