#include "engine/render/label_layout.h"

#include <algorithm>
#include <cmath>

#include "engine/haptics/sweep.h"

namespace moltact {
namespace {

constexpr double kFaint = 0.45;                     // opacity where atoms hide the point
constexpr double kAcross = 9.0, kDown = 4.0;        // padding
constexpr double kReaches[] = {58.0, 86.0, 120.0};  // candidate distances from an arrow's tip to its name
constexpr double kBeside = 6.0;                     // half the minimum distance between two boxes
constexpr std::size_t kMax = 400;                   // number of labels considered

struct Wanted {
  const std::string* text;
  PointA at;
  double clear_A;
  bool arrow, always, measure;
  const Annotations::Measure* line = nullptr;  // a line that the label leaves visible
  Vec3 px{0.0};
  bool hidden = false;
};

bool overlaps(const PlacedLabel& a, const PlacedLabel& b, double gap) {
  return a.low.x < b.high.x + gap && b.low.x < a.high.x + gap && a.low.y < b.high.y + gap && b.low.y < a.high.y + gap;
}

// True if a sphere hides the point from the eye, other than those that belong to the label.
bool hidden(const SphereGrid& spheres, const Camera& camera, const Wanted& w) {
  const Vec3 eye = camera.eye().A, offset = w.at.A - eye;
  const double length = glm::length(offset), free = length - w.clear_A - 0.3;
  if (!(free > 0.0)) return false;
  return sweep(spheres, 0.0, eye, eye + offset * (free / length)).sphere >= 0;
}

// True if the atoms are drawn opaquely as spheres.
bool hidesPlaces(const AtomsLook& look) {
  if (look.cut || look.hidden) return false;
  return look.styles.empty() || std::any_of(look.styles.begin(), look.styles.end(), [](const StyledAtoms& s) {
           return infoOf(s.style).hides_places && !s.atoms && s.opacity >= 1.0f;
         });
}

}  // namespace

glm::dvec2 labelPadding_px(double unit_px) { return glm::dvec2(kAcross, kDown) * unit_px; }

std::vector<PlacedLabel> layOutLabels(const ViewScene& scene, const SphereGrid* spheres, const LabelRoom& room) {
  std::vector<Wanted> wanted;
  if (!hidesPlaces(scene.look)) spheres = nullptr;
  std::vector<std::shared_ptr<const Annotations>> all = scene.annotations;
  if (scene.held_lines) all.push_back(scene.held_lines);
  for (const auto& a : all) {
    for (const Annotations::Label& l : a->labels)
      wanted.push_back({&l.text, l.at, l.clear_A, l.arrow, l.always, false});
    for (const Annotations::Measure& m : a->measures) {
      Vec3 middle(0.0);
      // A torsion is labelled at its middle bond, an angle at its vertex.
      const std::size_t first = m.places.size() > 2 ? 1 : 0, last = m.places.size() > 3   ? 2
                                                                    : m.places.size() > 2 ? 1
                                                                                          : 1;
      for (std::size_t i = first; i <= last && i < m.places.size(); ++i)
        middle += m.places[i].A / double(last - first + 1);
      wanted.push_back({&m.text,
                        {middle},
                        2.5,
                        false,
                        true,
                        true,
                        m.line != Annotations::Line::Measure && m.places.size() == 2 ? &m : nullptr});
    }
  }
  std::erase_if(wanted, [&](Wanted& w) {
    w.px = scene.camera.project(w.at, room.width_px, room.height_px);
    return !(w.px.z > 0.0) || !(w.px.x >= 0 && w.px.x < room.width_px && w.px.y >= 0 && w.px.y < room.height_px);
  });
  // The author's labels and measures first, the others by distance.
  std::stable_sort(wanted.begin(), wanted.end(),
                   [](const Wanted& a, const Wanted& b) { return a.always != b.always ? a.always : a.px.z < b.px.z; });
  if (wanted.size() > kMax) wanted.resize(kMax);

  const Vec3 centre = scene.camera.project(scene.camera.target, room.width_px, room.height_px);
  const double u = room.unit_px;
  const glm::dvec2 pad = labelPadding_px(u);
  std::vector<PlacedLabel> placed;
  for (Wanted& w : wanted) {
    w.hidden = spheres && hidden(*spheres, scene.camera, w);
    if (w.hidden && !w.always) continue;
    PlacedLabel label{.text = *w.text,
                      .low = {},
                      .high = {},
                      .tip = {w.px.x, w.px.y},
                      .arrow = w.arrow,
                      .measure = w.measure,
                      .strength = w.hidden ? kFaint : 1.0};
    const glm::dvec2 half = 0.5 * room.textSize(*w.text) + pad;
    const auto fits = [&](const glm::dvec2& middle) {
      label.low = glm::round(middle - half);
      label.high = label.low + 2.0 * half;
      if (label.low.x < 2 * u || label.low.y < 2 * u || label.high.x > room.width_px - 2 * u ||
          label.high.y > room.height_px - 2 * u)
        return false;
      return std::none_of(placed.begin(), placed.end(),
                          [&](const PlacedLabel& other) { return overlaps(label, other, kBeside * u); });
    };
    bool found = false;
    if (w.arrow) {
      // Outward from the middle of the picture, or rotated by multiples of 45 degrees to either side.
      const glm::dvec2 away = label.tip - glm::dvec2(centre);
      const double begin = glm::length(away) > 4.0 * u ? std::atan2(away.y, away.x) : -0.9;
      for (const double reach : kReaches)
        for (const int eighth : {0, 1, -1, 2, -2, 3, -3, 4}) {
          const double angle = begin + eighth * 0.7853981633974483;
          const glm::dvec2 direction(std::cos(angle), std::sin(angle));
          // The box starts at the end of the arrow, whatever its width.
          found = found || fits(label.tip + direction * (reach * u) + direction * half);
          if (found) break;
        }
    } else if (w.line) {
      // On either side of the line.
      const Vec3 from = scene.camera.project(w.line->places[0], room.width_px, room.height_px),
                 to = scene.camera.project(w.line->places[1], room.width_px, room.height_px);
      const glm::dvec2 along(to.x - from.x, to.y - from.y);
      const double length = glm::length(along);
      const glm::dvec2 side = length > u ? glm::dvec2(along.y, -along.x) / length : glm::dvec2(0.0, -1.0);
      const double off = std::abs(side.x) * half.x + std::abs(side.y) * half.y + 4.0 * u;
      for (const double away : {off, -off, 2.0 * off, -2.0 * off})
        if (!found) found = fits(label.tip + away * side);
    } else {
      const double off = (w.measure ? 4.0 : 0.0) * u + half.y;
      for (const glm::dvec2& by : {glm::dvec2(0, 0), glm::dvec2(0, -2 * off), glm::dvec2(0, 2 * off),
                                   glm::dvec2(2 * half.x, 0), glm::dvec2(-2 * half.x, 0)}) {
        found = found || fits(label.tip + by);
        if (found) break;
      }
    }
    if (found) placed.push_back(std::move(label));
  }
  return placed;
}

ArrowShape arrowOf(const PlacedLabel& label, double unit_px) {
  ArrowShape shape;
  const glm::dvec2 near = glm::clamp(label.tip, label.low, label.high), shaft = label.tip - near;
  const double length = glm::length(shaft), head = 11.0 * unit_px;
  if (!label.arrow || !(length > head)) return shape;
  const glm::dvec2 along = shaft / length, aside(-along.y, along.x);
  shape.drawn = true;
  shape.from = near;
  shape.neck = label.tip - along * head;
  shape.left = shape.neck + aside * (0.45 * head);
  shape.right = shape.neck - aside * (0.45 * head);
  return shape;
}

}  // namespace moltact
