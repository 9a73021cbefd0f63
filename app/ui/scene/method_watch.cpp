#include "app/ui/scene/method_watch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/saturated.h"
#include "engine/haptics/sweep.h"
#include "engine/servo/reference_interaction.h"
#include "engine/structure/interaction_input.h"

namespace moltact {
namespace {

constexpr double kFading = 4000.0;  // number of ticks; at twice this number, all counts are halved
// The exact tracker is reset after it alone has been in contact, with a free HIP, for this many ticks.
constexpr std::size_t kLeftBehind_ticks = 400;
constexpr double kPull_A = 0.02;  // the direction of a shorter spring is undefined

}  // namespace

void TickHistogram::add(double time_us) {
  if (!(time_us > 0.0)) return;
  const int bin =
      std::clamp(saturateToInteger<int>(std::floor(std::log10(time_us / kMin_us) * kBinsADecade)), 0, kBins - 1);
  counts_[std::size_t(bin)] += 1.0;
  total_ += 1.0;
  if (total_ < 2.0 * kFading) return;
  for (double& c : counts_) c *= 0.5;
  total_ *= 0.5;
}

double TickHistogram::quantile_us(double share) const {
  if (empty()) return 0.0;
  double wanted = std::clamp(share, 0.0, 1.0) * total_;
  int bin = 0;
  while (bin < kBins - 1 && (counts_[std::size_t(bin)] < wanted || counts_[std::size_t(bin)] == 0.0))
    wanted -= counts_[std::size_t(bin++)];
  const double within =
      counts_[std::size_t(bin)] > 0.0 ? std::clamp(wanted / counts_[std::size_t(bin)], 0.0, 1.0) : 0.0;
  return kMin_us * std::pow(10.0, (bin + within) / kBinsADecade);
}

double clearanceAt(const SphereGrid& resting, const ServoSample& s, const SphereMotion* motion) {
  return clearance(motion ? motion->sweptSpheres() : resting, s.probe_A, s.hip.A, motion, s.fraction);
}

MethodWatch::MethodWatch() : turns_(std::size_t(TouchLog::kPlot_s / kTick_s) / TouchLog::kTicksAPoint) {}

std::unique_ptr<Interaction> MethodWatch::makeReference(const TouchSetup& reference) const {
  return makeInteraction(interactionInput(reference, *molecule_, spheres_));
}

void MethodWatch::begin(const TouchableModel& stage, const TouchSetup& felt) {
  molecule_ = stage.molecule;
  spheres_ = stage.spheres;
  reference_ = referenceOf(felt);
  judges_ = stage && !stage.body;  // methods are compared with a probe only
  exact_ = judges_ && !sameConstruction(felt, reference_) ? makeReference(reference_) : nullptr;
  latest_ = {};
  hand_ = {};
  fraction_ = 0.0;
  motion_ = nullptr;
  latest_exact_ = {};
  left_behind_ticks_ = 0;
  tried_.clear();
  turns_ = PlotBuffer(turns_.capacity());
  displacement_before_ = Vec3(0.0);
  turn_peak_deg_ = 0;
}

void MethodWatch::feelWith(const TouchSetup& felt) {
  const TouchSetup reference = referenceOf(felt);
  const bool other = !exact_ || !sameConstruction(reference, reference_);
  if (!judges_ || sameConstruction(felt, reference)) {
    exact_ = nullptr;
  } else if (other) {
    exact_ = makeReference(reference);
    if (motion_ && exact_->setMotion(motion_.get())) exact_->advanceTo(fraction_);
    if (latest_.molecular_energy)  // what hangs in a field goes on from its place
      leadFrom(*exact_, latest_);
    else
      leadToContact(*exact_, latest_exact_, hand_);
  }
  reference_ = reference;
}

const MethodRecord* MethodWatch::find(std::string_view method) const {
  const auto it = std::find_if(tried_.begin(), tried_.end(), [&](const MethodRecord& r) { return r.method == method; });
  return it == tried_.end() ? nullptr : &*it;
}

MethodRecord& MethodWatch::record(std::string_view method) {
  if (const MethodRecord* found = find(method)) return tried_[std::size_t(found - tried_.data())];
  tried_.push_back({std::string(method), {}, 0, 0});
  return tried_.back();
}

void MethodWatch::noteTurn(const ServoSample& s) {
  const Vec3& displacement = s.contact.displacement_A;
  const double length = glm::length(displacement), before = glm::length(displacement_before_);
  if (length > kPull_A && before > kPull_A) {
    const double turn = std::atan2(glm::length(glm::cross(displacement, displacement_before_)),
                                   glm::dot(displacement, displacement_before_));
    turn_peak_deg_ = std::max(turn_peak_deg_, float(turn * 180.0 / std::numbers::pi));
  }
  displacement_before_ = displacement;
  if (++in_point_ < TouchLog::kTicksAPoint) return;
  turns_.add(turn_peak_deg_);
  turn_peak_deg_ = 0;
  in_point_ = 0;
}

double MethodWatch::greatestTurn_deg() const {
  float most = 0;
  for (std::size_t k = 0; k < turns_.size(); ++k) most = std::max(most, turns_.ago(k));
  return double(most);
}

Contact MethodWatch::add(const ServoSample& s, const Method& method,
                         const std::shared_ptr<const SphereMotion>& motion) {
  noteTurn(s);
  if (!judges_ || !s.has_interaction) return {.scp = s.hip};
  latest_ = s;
  motion_ = exact_ ? motion_ : motion;
  const Contact exact = exact_ ? exactContact(s, motion) : s.contact;
  hand_ = {s.hip, s.orientation};
  fraction_ = s.fraction;
  latest_exact_ = exact;
  if (!exact.touching() || s.contact.fault != Fault::None) return exact;
  MethodRecord& r = record(method.name);
  r.times.add(double(s.work_us));
  const double error_A = glm::distance(s.contact.scp.A, exact.scp.A);
  r.error_A += (error_A - r.error_A) / double(std::min(++r.ticks, kMemory_ticks));
  return exact;
}

Contact MethodWatch::exactContact(const ServoSample& s, const std::shared_ptr<const SphereMotion>& motion) {
  followTick(*exact_, s, motion.get());
  motion_ = motion;  // in use until another is set
  const PoseA hand{s.hip, s.orientation};
  Contact exact = exact_->respond(hand).contact;
  // A method that loses the surface lets the hand out on the far side. The exact SCP would then stay behind for ever.
  const bool alone = exact.touching() && !s.contact.touching() && clearanceAt(*spheres_, s, motion_.get()) > 0.0;
  left_behind_ticks_ = alone ? left_behind_ticks_ + 1 : 0;
  if (left_behind_ticks_ > kLeftBehind_ticks) {
    exact_->reset();
    exact = exact_->respond(hand).contact;
    left_behind_ticks_ = 0;
  }
  return exact;
}

}  // namespace moltact
