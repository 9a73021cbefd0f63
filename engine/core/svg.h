// Writes a drawing as SVG 1.1, element by element. Coordinates are in user units with one decimal; `attributes` are
// written unchanged (class="bar"). Any thread except the haptic one.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

#include "engine/core/markup.h"

namespace moltact {

/// Formats a length with one decimal; a value that is not finite becomes 0.
inline std::string svgNumber(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.1f", std::isfinite(value) && std::abs(value) < 1e15 ? value : 0.0);
  std::string out(text);
  if (out.ends_with(".0")) out.resize(out.size() - 2);
  return out == "-0" ? "0" : out;
}

class Svg {
 public:
  /// `anchor`: start, middle or end. The text is escaped.
  Svg& text(double x, double y, std::string_view anchor, std::string_view what, std::string_view attributes = {}) {
    begin("text", attributes).length("x", x).length("y", y);
    if (anchor != "start") value("text-anchor", anchor);
    out_.append(">").append(escaped(what)).append("</text>\n");
    return *this;
  }
  Svg& line(double x0, double y0, double x1, double y1, std::string_view attributes) {
    return begin("line", attributes).length("x1", x0).length("y1", y0).length("x2", x1).length("y2", y1).end();
  }
  Svg& rect(double x, double y, double width, double height, std::string_view attributes) {
    return begin("rect", attributes)
        .length("x", x)
        .length("y", y)
        .length("width", width)
        .length("height", height)
        .end();
  }
  Svg& circle(double x, double y, double radius, std::string_view attributes) {
    return begin("circle", attributes).length("cx", x).length("cy", y).length("r", radius).end();
  }
  /// `commands`: a sequence of svgPoint() results.
  Svg& path(std::string_view commands, std::string_view attributes) {
    return begin("path", attributes).value("d", commands).end();
  }

  /// The accessible title of the drawing. The text is escaped.
  Svg& title(std::string_view what) {
    out_.append("<title>").append(escaped(what)).append("</title>\n");
    return *this;
  }
  /// Fills the whole drawing with one colour.
  Svg& ground(std::string_view colour) {
    return begin("rect", "width=\"100%\" height=\"100%\"").value("fill", colour).end();
  }

  /// Returns the elements enclosed in an <svg> element with these attributes.
  std::string within(std::string_view attributes) && {
    return std::string("<svg ").append(attributes).append(">").append(out_).append("</svg>");
  }

 private:
  Svg& begin(std::string_view element, std::string_view attributes) {
    out_.append("<").append(element);
    if (!attributes.empty()) out_.append(" ").append(attributes);
    return *this;
  }
  Svg& value(std::string_view name, std::string_view what) {
    out_.append(" ").append(name).append("=\"").append(what).append("\"");
    return *this;
  }
  Svg& length(std::string_view name, double what) { return value(name, svgNumber(what)); }
  Svg& end() {
    out_.append("/>\n");
    return *this;
  }

  std::string out_;
};

/// A path command with its point: "M3 4.5".
inline std::string svgPoint(char command, double x, double y) { return command + svgNumber(x) + " " + svgNumber(y); }

}  // namespace moltact
