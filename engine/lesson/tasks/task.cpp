#include "engine/lesson/tasks/task.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace moltact {

void Task::feed(const TouchSample& sample) {
  const double force_squared = glm::dot(sample.force.N, sample.force.N);
  if (done_ || !std::isfinite(sample.time_s) || !std::isfinite(force_squared)) return;
  double dt = 0.0;
  if (started_) {
    dt = sample.time_s - last_time_s_;
    if (!(dt > 0.0)) return;
    if (dt > kLongestGap_s) dt = 0.0;
  }
  started_ = true;
  last_time_s_ = sample.time_s;
  inside_ = sample.contact.fault == Fault::StartedInside;
  take(sample, dt);
}

std::string Task::sentence() const {
  if (done_) return praise_;
  if (inside_) return "The probe began inside the molecule. Draw it back until it is outside, then touch again.";
  return guidance();
}

void Task::reset() {
  progress_ = 0.0;
  done_ = started_ = inside_ = false;
}

void Task::setProgress(double progress) { progress_ = std::clamp(progress, 0.0, 1.0); }

AtomSet::AtomSet(const Selection& selection, const Molecule& molecule) : all_(!selection.given()) {
  if (all_) {
    count_ = molecule.atoms.size();
    return;
  }
  in_.assign(molecule.atoms.size(), 0);
  for (const std::uint32_t i : selection.select(molecule)) {
    in_[i] = 1;
    ++count_;
  }
}

bool AtomSet::touchedBy(const Contact& contact) const {
  return contact.touching() && std::any_of(contact.atoms.begin(), contact.atoms.end(), [&](std::int32_t a) { return has(a); });
}

bool AtomSet::holds(const Contact& contact) const {
  return touchedBy(contact) &&
         std::all_of(contact.atoms.begin(), contact.atoms.end(), [&](std::int32_t a) { return a < 0 || has(a); });
}

bool Stopwatch::tick(bool lasting, double dt_s, double slip_s) {
  if (lasting) {
    elapsed_s_ += dt_s;
    away_s_ = 0.0;
    return false;
  }
  away_s_ += dt_s;
  if (away_s_ <= slip_s || elapsed_s_ == 0.0) return false;
  restart();
  return true;
}

std::string targetName(const TaskSpec& spec, std::string_view key) {
  if (spec.values.has("called")) return spec.values["called"].text;
  const Value& target = spec.values[key];
  if (target.selection.given()) return target.selection.noun();
  const std::string_view word = target.words.empty() ? std::string_view() : std::string_view(target.words[0]);
  if (word == "sphere") return "the round face of one atom";
  if (word == "crease") return "a crease between two atoms";
  if (word == "pit") return "a pit between three atoms";
  return "the surface";
}

bool isFeature(std::string_view word, Feature feature) {
  switch (feature) {
    case Feature::Sphere: return word == "sphere";
    case Feature::Circle: return word == "crease";
    case Feature::Point: return word == "pit";
    case Feature::Free: break;
  }
  return false;
}

std::string forceText(double force_N) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f N", std::clamp(force_N, 0.0, 9999.0));
  return text;
}

std::string timeText(double time_s) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f s", std::clamp(time_s, 0.0, 9999.0));
  return text;
}

}  // namespace moltact
