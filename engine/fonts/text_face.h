// Rasterizes a line of text in the window's fonts, for pictures made without a window. One object per size; belongs to
// its thread.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <utility>

namespace moltact {

class TextFace {
 public:
  /// `line_px`: height of a line's letters, from the top of the tallest to the bottom of the lowest. Without installed
  /// fonts nothing is drawn and every size is 0.
  explicit TextFace(double line_px);
  ~TextFace();
  TextFace(const TextFace&) = delete;
  TextFace& operator=(const TextFace&) = delete;

  bool good() const;

  /// Width and height of a line (unit: pixel).
  std::pair<double, double> size(std::span<const char32_t> line) const;

  /// Calls `pixel(x, y, coverage)` for each pixel covered by the line (coverage 0 to 1). (x_px, y_px) is its upper left
  /// corner.
  void draw(std::span<const char32_t> line, double x_px, double y_px,
            const std::function<void(int x, int y, float coverage)>& pixel) const;

 private:
  struct Fonts;
  std::unique_ptr<Fonts> fonts_;
};

}  // namespace moltact
