// Antialiased lines of any width, drawn over the picture: at full opacity where visible, fainter where something nearer
// hides them. Needs a current context. Widths in pixels.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/render/gl_objects.h"
#include "engine/render/projection.h"

namespace moltact {

struct Stroke {
  glm::vec3 colour{1.0f};
  float alpha = 1.0f;     ///< opacity where visible
  float hidden = 0.15f;   ///< fraction of alpha where hidden
  float width_px = 1.5f;  ///< width
};

/// Polylines in the camera's axes, collected for one picture.
class Strokes {
 public:
  struct Line {
    std::size_t begin, end;
    Stroke stroke;
  };
  void clear() {
    points_.clear();
    lines_.clear();
  }
  void begin(const Stroke& stroke) { lines_.push_back({points_.size(), points_.size(), stroke}); }
  void point(const glm::vec3& view) {
    points_.push_back(view);
    lines_.back().end = points_.size();
  }
  std::span<const Line> lines() const { return lines_; }
  const glm::vec3& operator[](std::size_t i) const { return points_[i]; }

 private:
  std::vector<glm::vec3> points_;
  std::vector<Line> lines_;
};

class Wireframe {
 public:
  static Expected<Wireframe> build();

  /// `scale` is a factor on every width, for screens with small pixels.
  void draw(const Strokes& strokes, const Projection& projection, float scale);

 private:
  struct Vertex {
    float x, y, z, across_px, half_px;
    std::uint32_t colour;
    float hidden;
  };
  Wireframe() : stream_(std::make_unique<GlStream>()) {}
  void pushPiece(std::span<const glm::vec3> ndc, const Strokes::Line& line, const Projection& projection, float scale);

  GlProgram program_;
  std::unique_ptr<GlStream> stream_;
  std::vector<Vertex> vertices_;
  std::vector<glm::vec3> ndc_;
};

}  // namespace moltact
