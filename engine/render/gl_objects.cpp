#include "engine/render/gl_objects.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

std::string logOf(GLuint object, bool program) {
  GLint length = 0;
  program ? glGetProgramiv(object, GL_INFO_LOG_LENGTH, &length) : glGetShaderiv(object, GL_INFO_LOG_LENGTH, &length);
  std::string log(std::size_t(std::max(length, 1)), '\0');
  GLsizei written = 0;
  program ? glGetProgramInfoLog(object, GLsizei(log.size()), &written, log.data())
          : glGetShaderInfoLog(object, GLsizei(log.size()), &written, log.data());
  log.resize(std::size_t(written));
  return log;
}

Problem shaderProblem(const std::string& name, const std::string& log) {
  return {.file = {},
          .message = trf("the graphics driver refuses the shader '{0}': {1}", name, log),
          .remedy = tr("OpenGL 3.3 is needed; LIBGL_ALWAYS_SOFTWARE=1 uses the software driver")};
}

GLuint compile(GLenum kind, const std::string& text) {
  const GLuint shader = glCreateShader(kind);
  const std::string whole = std::string(kShaderVersion) + "\n" + kShaderPrecision + text;
  const char* source = whole.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  return shader;
}

}  // namespace

Expected<GlProgram> GlProgram::build(const std::string& name, const std::string& vertex, const std::string& fragment) {
  GlProgram program;
  program.id_ = glCreateProgram();
  if (!program.id_) return shaderProblem(name, tr("no program object (has the context been lost?)"));
  std::string failure;
  for (const auto& [kind, text] : {std::pair{GL_VERTEX_SHADER, &vertex}, std::pair{GL_FRAGMENT_SHADER, &fragment}}) {
    const GLuint shader = compile(GLenum(kind), *text);
    GLint good = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (!good && failure.empty()) failure = logOf(shader, false);
    glAttachShader(program.id_, shader);
    glDeleteShader(shader);
  }
  if (!failure.empty()) return shaderProblem(name, failure);
  glLinkProgram(program.id_);
  GLint good = 0;
  glGetProgramiv(program.id_, GL_LINK_STATUS, &good);
  if (!good) return shaderProblem(name, logOf(program.id_, true));
  return {std::move(program)};
}

GlTarget::~GlTarget() {
  if (!framebuffer_) return;
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteTextures(1, &colour_);
  glDeleteTextures(1, &depth_);
}

bool GlTarget::resize(int width_px, int height_px) {
  if (framebuffer_ && width_ == width_px && height_ == height_px) return true;
  if (!framebuffer_) {
    glGenFramebuffers(1, &framebuffer_);
    glGenTextures(1, &colour_);
    glGenTextures(1, &depth_);
  }
  width_ = width_px;
  height_ = height_px;
  const auto make = [&](GLuint texture, GLint inside, GLenum format, GLenum type, GLint filter) {
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, inside, width_, height_, 0, format, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  };
  make(colour_, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, GL_LINEAR);
  make(depth_, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_, 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);
  return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void GlTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, width_, height_);
}

GlVolume::~GlVolume() {
  if (texture_) glDeleteTextures(1, &texture_);
}

void GlVolume::upload(int width, int height, int depth, const void* bytes) {
  if (!texture_) glGenTextures(1, &texture_);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_3D, texture_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage3D(GL_TEXTURE_3D, 0, GL_R8, width, height, depth, 0, GL_RED, GL_UNSIGNED_BYTE, bytes);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_3D, filter, GL_LINEAR);
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTexParameteri(GL_TEXTURE_3D, axis, GL_CLAMP_TO_EDGE);
}

void GlVolume::bind(unsigned unit) {
  if (!texture_) {
    const unsigned char empty = 0;
    upload(1, 1, 1, &empty);
  }
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_3D, texture_);
  glActiveTexture(GL_TEXTURE0);
}

GlStream::~GlStream() {
  if (!array_) return;
  glDeleteVertexArrays(1, &array_);
  glDeleteBuffers(1, &vertices_);
  glDeleteBuffers(1, &elements_);
}

bool GlStream::bind() {
  const bool first = !array_;
  if (first) {
    glGenVertexArrays(1, &array_);
    glGenBuffers(1, &vertices_);
    glGenBuffers(1, &elements_);
  }
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  return first;
}

void GlStream::upload(const void* data, std::size_t bytes) {
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(bytes), data, GL_STREAM_DRAW);
}

void GlStream::reserveQuads(std::size_t quads) {
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, elements_);
  if (quads <= quads_) return;
  quads_ = std::max<std::size_t>(2 * quads_, std::max<std::size_t>(quads, 256));
  std::vector<std::uint32_t> elements(6 * quads_);
  for (std::size_t q = 0; q < quads_; ++q)
    for (const std::size_t k : {0, 1, 2, 3, 4, 5}) {
      constexpr std::uint32_t corner[6] = {0, 1, 2, 2, 1, 3};
      elements[6 * q + k] = std::uint32_t(4 * q) + corner[k];
    }
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(elements.size() * 4), elements.data(), GL_STATIC_DRAW);
}

void GlStream::floats(GLuint index, int count, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, count, GL_FLOAT, GL_FALSE, GLsizei(stride), reinterpret_cast<const void*>(offset));
}

void GlStream::bytes4(GLuint index, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, 4, GL_UNSIGNED_BYTE, GL_TRUE, GLsizei(stride), reinterpret_cast<const void*>(offset));
}

}  // namespace moltact
