// The motions of LessonHand: visibility of a place, rotation of the molecule, a press slid over the surface.
#include <algorithm>
#include <cmath>

#include "engine/core/even_directions.h"
#include "engine/device/pointer_hand.h"
#include "tests/app/lesson_hand.h"

namespace moltact {
namespace {

constexpr double kOrbit_rad_per_px = 0.008, kOrbit_rad_per_s = 1.4;

}  // namespace

glm::dvec2 LessonHand::seen(const Vec3& place_A) const {
  const glm::dvec2 size = d_.app().layout().view.size();
  const Vec3 px = d_.app().scene.camera.project({place_A}, int(size.x), int(size.y));
  return glm::dvec2(px.x, px.y) / size;
}

Vec3 LessonHand::outward(const Vec3& place_A) const {
  Vec3 sum(0.0);
  const double probe_A = d_.app().scene.servo_settings.probe_A;
  d_.app().scene.stage().spheres->visitNear(place_A, probe_A + 0.3, [&](std::uint32_t, const Sphere& b) {
    const Vec3 way = place_A - b.centre_A;
    if (glm::length(way) < b.radius_A + probe_A + 0.3) sum += glm::normalize(way);
  });
  return glm::length(sum) > 1e-6 ? glm::normalize(sum) : d_.app().scene.camera.back();
}

Vec3 LessonHand::openFrom(const HandPlan& plan, std::size_t k) const {
  constexpr double kFar_A = 40.0, kStep_A = 0.5, kFront = 0.2;
  constexpr int kDirections = 300;
  constexpr std::size_t kAhead = 12;
  const double probe_A = d_.app().scene.servo_settings.probe_A;
  const auto open = [&](const Vec3& place_A, const Vec3& to) {
    bool is = true;
    for (double at_A = 1.0; at_A < kFar_A && is; at_A += kStep_A) {
      const Vec3 here = place_A + at_A * to;
      d_.app().scene.stage().spheres->visitNear(here, probe_A, [&](std::uint32_t, const Sphere& b) {
        is = is && glm::distance(here, b.centre_A) >= b.radius_A + probe_A;
      });
    }
    return is;
  };
  std::vector<Vec3> places, fronts;
  for (std::size_t n = k; n < plan.size() && n < k + kAhead && plan[n].to && !plan[n].placed; ++n) {
    places.push_back(plan[n].to->A);
    fronts.push_back(outward(plan[n].to->A));
  }
  Vec3 best = fronts.front();
  double best_score = 0.0;
  for (int d = 0; d < kDirections; ++d) {
    const Vec3 to = evenDirection(d, kDirections);
    std::size_t seen = 0;
    while (seen < places.size() && glm::dot(fronts[seen], to) > kFront && open(places[seen], to)) ++seen;
    const double score = double(seen) + glm::dot(fronts.front(), to);
    if (seen > 0 && score > best_score) best_score = score, best = to;
  }
  return best;
}

void LessonHand::face(Vec3 direction) {
  for (int turns = 0; turns < 12; ++turns) {
    const Vec3 v = glm::normalize(glm::conjugate(d_.app().scene.camera.orientation) * direction);
    if (v.z > 0.995) return;
    const double right = -std::atan2(v.x, v.z), down = std::asin(std::clamp(v.y, -1.0, 1.0));
    if (mouse()) {
      // Few people drag farther than a third of the view at once.
      const auto px = [](double rad) { return std::clamp(rad / kOrbit_rad_per_px, -200.0, 200.0); };
      d_.drag("view", px(right), px(down), 1);
      continue;
    }
    const auto turn = [&](double rad, const char* plus, const char* minus) {
      if (std::abs(rad) < 0.03) return;
      const char* keys = rad > 0.0 ? plus : minus;
      d_.hold(keys);
      d_.frames(std::max(1, int(std::abs(rad) / kOrbit_rad_per_s * 60.0)));
      d_.letGo(keys);
    };
    turn(right, "Ctrl+Right", "Ctrl+Left");
    turn(down, "Ctrl+Down", "Ctrl+Up");
  }
}

void LessonHand::pointAt(const Vec3& place_A) {
  if (!mouse()) return lead(place_A, session().currentTask());
  const glm::dvec2 at = seen(place_A);
  d_.point("view", at.x, at.y);
  d_.frames(20);
}

void LessonHand::press() {
  if (pressing_) return;
  if (mouse())
    d_.press();
  else
    d_.hold("Space");
  pressing_ = true;
  pushed_N_ = PointerHand::kRest_N;
  d_.frames(45);
}

void LessonHand::lift() {
  holdArrows({0, 0});
  if (!pressing_) return;
  if (mouse())
    d_.release();
  else
    d_.letGo("Space");
  pressing_ = false;
  d_.frames(15);
}

void LessonHand::push(double force_N) {
  for (; pushed_N_ < force_N && pushed_N_ < 10.0; pushed_N_ += PointerHand::kNotch_N) {
    if (mouse())
      d_.wheel(1);
    else
      d_.tap("plus");
    d_.frames(3);
  }
}

void LessonHand::lead(const Vec3& place_A, std::size_t task) {
  const glm::dvec2 size = d_.app().layout().view.size();
  constexpr double kNear_px = 2.0;
  for (int k = 0; k < 400 && isCurrent(task); ++k) {
    const glm::dvec2 way = (seen(place_A) - seen(d_.app().scene.controls.lead().A)) * size;
    if (glm::length(way) < kNear_px) break;
    if (mouse()) {
      const ImVec2 now = ImGui::GetIO().MousePos;
      const Rectangle& view = d_.app().layout().view;
      const glm::dvec2 step = way * std::min(1.0, 3.0 / glm::length(way)),
                       to = (glm::dvec2(now.x, now.y) + step - glm::dvec2(view.low)) / size;
      d_.point("view", to.x, to.y);
    } else {
      const auto sign = [](double v) { return v > 0.7 * kNear_px ? 1 : v < -0.7 * kNear_px ? -1 : 0; };
      holdArrows({sign(way.x), sign(-way.y)});
      d_.frames(1);
    }
    if (watch) watch();
  }
  holdArrows({0, 0});
}

void LessonHand::holdArrows(glm::ivec2 way) {
  const auto change = [&](int before, int after, const char* plus, const char* minus) {
    if (before == after) return;
    if (before) d_.letGo(before > 0 ? plus : minus);
    if (after) d_.hold(after > 0 ? plus : minus);
  };
  change(arrows_.x, way.x, "Right", "Left");
  change(arrows_.y, way.y, "Up", "Down");
  arrows_ = way;
}

}  // namespace moltact
