// A line of text as coverage of pixels, in the window's fonts, for pictures that are made without a window. One object a
// size; belongs to its thread.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <utility>

namespace moltact {

class TextFace {
 public:
  /// The letters of a line are so many pixels high, from the top of the tallest to the lowest. Where no font is
  /// installed nothing is written and every size is 0.
  explicit TextFace(double line_px);
  ~TextFace();
  TextFace(const TextFace&) = delete;
  TextFace& operator=(const TextFace&) = delete;

  bool good() const;

  /// Width and height of a line (unit: pixel).
  std::pair<double, double> size(std::span<const char32_t> line) const;

  /// Calls `pixel(x, y, coverage)` for each pixel that a line covers, 0 to 1, its upper left corner at (x_px, y_px).
  void draw(std::span<const char32_t> line, double x_px, double y_px,
            const std::function<void(int x, int y, float coverage)>& pixel) const;

 private:
  struct Fonts;
  std::unique_ptr<Fonts> fonts_;
};

}  // namespace moltact
