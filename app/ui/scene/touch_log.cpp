#include "app/ui/scene/touch_log.h"

#include <algorithm>
#include <cmath>

#include "engine/core/saturated.h"

namespace moltact {
namespace {
constexpr double kMeasure_s = 0.5;
constexpr double kFigure_s = 0.2, kFigure_N = 0.1, kRounded_N = 0.0501;
constexpr std::size_t kPoints = std::size_t(TouchLog::kPlot_s / kTick_s) / TouchLog::kTicksAPoint;
}  // namespace

TouchLog::TouchLog() : force_(kPoints), work_(kPoints) {}

void TouchLog::add(const ServoSample& sample) {
  latest_ = sample;
  latest_force_N_ = glm::length(sample.force.N);
  if (sample.molecular_energy && sample.contact.fault == Fault::None)
    if (const double energy = sample.molecular_energy->total_kcal_mol(); std::isfinite(energy))
      lowest_kcal_mol_ = std::min(lowest_kcal_mol_, energy);
  force_peak_ = std::max(force_peak_, saturateToFloat(latest_force_N_));
  work_peak_ = std::max(work_peak_, sample.work_us);
  if (++in_point_ == kTicksAPoint) {
    force_.add(force_peak_);
    work_.add(work_peak_);
    if (const auto& energy = sample.molecular_energy) {
      energies_.resize(kEnergyParts, PlotBuffer(kPoints));
      for (std::size_t k = 0; k < kEnergyParts; ++k) energies_[k].add(saturateToFloat(energy->parts.values[k]));
    } else {
      energies_.clear();
    }
    force_peak_ = work_peak_ = 0.0f;
    in_point_ = 0;
  }
  late_us_.push_back(sample.late_us);
  work_sum_us_ += double(sample.work_us);
  work_max_us_ = std::max(work_max_us_, double(sample.work_us));
}

void TouchLog::figureForce(double now_s) {
  // The end and the beginning of a force are displayed at once.
  const bool ended = latest_force_N_ <= 0.0, begun = shown_N_ <= 0.0;
  if (std::abs(latest_force_N_ - shown_N_) > kRounded_N && (ended || begun || now_s - shown_since_s_ >= kFigure_s)) {
    shown_N_ = std::round(latest_force_N_ / kFigure_N) * kFigure_N;
    shown_since_s_ = now_s;
  } else if (ended) {
    shown_N_ = 0.0;
  }
}

void TouchLog::measure(double now_s) {
  if (measured_s_ < 0) measured_s_ = now_s;
  const double span_s = now_s - measured_s_;
  if (span_s < kMeasure_s || late_us_.empty()) return;
  const std::size_t p99 = std::min(late_us_.size() - 1, late_us_.size() * 99 / 100);
  std::nth_element(late_us_.begin(), late_us_.begin() + std::ptrdiff_t(p99), late_us_.end());
  health_ = {double(late_us_.size()) / span_s, double(late_us_[p99]), work_sum_us_ / double(late_us_.size()),
             work_max_us_};
  late_us_.clear();
  work_sum_us_ = work_max_us_ = 0;
  measured_s_ = now_s;
}

double TouchLog::greatest_N() const {
  float most = 0;
  for (std::size_t k = 0; k < force_.size(); ++k) most = std::max(most, force_.ago(k));
  return double(most);
}

void TouchLog::clear() {
  latest_ = ServoSample();
  latest_force_N_ = shown_N_ = 0;
  force_ = PlotBuffer(kPoints);
  energies_.clear();
  force_peak_ = 0;
  left_behind_s_ = 0;
  lowest_kcal_mol_ = 0;
}

}  // namespace moltact
