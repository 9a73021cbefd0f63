#include "engine/render/annotations.h"

#include <algorithm>
#include <cmath>

#include "engine/render/view_scene.h"

namespace moltact {
namespace {

constexpr double kDash_A = 0.32, kGap_A = 0.22;  // of a hydrogen bond
constexpr double kArc_A = 0.8;                   // radius of an angle's arc; less with a shorter arm
constexpr int kArcPieces = 24;

class Lines {
 public:
  Lines(const Camera& camera, Strokes& out) : camera_(camera), out_(out) {}

  /// Bright on a dark edge, so that it is visible on atoms of every colour.
  template <class Draw>
  void edged(const Colour& colour, float width_px, float hidden, Draw&& draw) {
    for (const bool under : {true, false}) {
      stroke_ = {.colour = under ? Colour(0.0f) : colour,
                 .alpha = under ? 0.5f : 1.0f,
                 .hidden = hidden,
                 .width_px = width_px + (under ? 2.4f : 0.0f)};
      draw();
    }
  }
  void begin() { out_.begin(stroke_); }
  void point(const Vec3& place) { out_.point(glm::vec3(camera_.toView({place}))); }
  void line(const Vec3& a, const Vec3& b) {
    begin();
    point(a);
    point(b);
  }
  void dashes(const Vec3& a, const Vec3& b) {
    for (const auto& [from, to] : dashesBetween({a}, {b})) line(from.A, to.A);
  }
  // An arc around `at` from the direction of `a` to that of `c`.
  void arc(const Vec3& a, const Vec3& at, const Vec3& c) {
    const Vec3 u = a - at, v = c - at;
    const double lu = glm::length(u), lv = glm::length(v);
    if (!(lu > 1e-6) || !(lv > 1e-6)) return;
    const Vec3 n = glm::cross(u / lu, v / lv);
    if (!(glm::length(n) > 1e-6)) return;
    const double radius = std::min({kArc_A, 0.6 * lu, 0.6 * lv}),
                 whole = std::atan2(glm::length(n), glm::dot(u / lu, v / lv));
    const Vec3 x = u / lu, y = glm::normalize(glm::cross(glm::normalize(n), x));
    begin();
    for (int i = 0; i <= kArcPieces; ++i) {
      const double t = whole * i / kArcPieces;
      point(at + radius * (std::cos(t) * x + std::sin(t) * y));
    }
  }

 private:
  const Camera& camera_;
  Strokes& out_;
  Stroke stroke_;
};

}  // namespace

std::vector<std::pair<PointA, PointA>> dashesBetween(PointA a, PointA b) {
  std::vector<std::pair<PointA, PointA>> out;
  const double length = glm::distance(a.A, b.A);
  if (!(length > 0.0)) return out;
  const Vec3 along = (b.A - a.A) / length;
  for (double at = 0.0; at < length; at += kDash_A + kGap_A)
    out.push_back({{a.A + along * at}, {a.A + along * std::min(at + kDash_A, length)}});
  return out;
}

void addLines(const Annotations& annotations, const Camera& camera, const Theme& theme, Strokes& strokes) {
  Lines lines(camera, strokes);
  if (!annotations.bonds.empty())
    lines.edged(theme.bond, 2.0f, 0.25f, [&] {
      for (const auto& [a, b] : annotations.bonds) lines.dashes(a.A, b.A);
    });
  if (!annotations.trail.empty())
    lines.edged(theme.touched, 2.2f, 0.4f, [&] {
      for (const std::vector<PointA>& piece : annotations.trail) {
        lines.begin();
        for (const PointA& p : piece) lines.point(p.A);
      }
    });
  for (const auto& [kind, colour] :
       {std::pair{Annotations::Line::Measure, theme.measure}, std::pair{Annotations::Line::Bond, theme.bond},
        std::pair{Annotations::Line::Clash, theme.strongest}})
    lines.edged(colour, 2.2f, 0.8f, [&, kind = kind] {  // clang 14 does not capture a structured binding
      for (const Annotations::Measure& m : annotations.measures) {
        if (m.line != kind) continue;
        for (std::size_t i = 0; i + 1 < m.places.size(); ++i) lines.dashes(m.places[i].A, m.places[i + 1].A);
        if (m.places.size() == 3) lines.arc(m.places[0].A, m.places[1].A, m.places[2].A);
      }
    });
}

}  // namespace moltact
