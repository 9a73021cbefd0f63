#include "app/ui/scene/servo_link.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace moltact {

namespace {
constexpr std::uint32_t kNoScene = 0xFFFFFFFF;
}

ServoLink::ServoLink(ServoClock clock) : clock_(clock) {
  ticks_.reserve(4096);
  every_.reserve(4096);
  if (clock == ServoClock::RealThread)
    thread_ = std::make_unique<ServoThread>(mouse_);
  else
    frames_.emplace(mouse_).begin(now_ns_);
  loop().expectSettings();
}

ServoLink::~ServoLink() {
  if (thread_) return;
  release();
  frames_->end();
}

// Executes one tick of the frames' clock.
void ServoLink::tickOfFrame() {
  now_ns_ += ServoLoop::kPeriod_ns + std::llround(1e9 * std::exchange(stall_s_, 0.0));
  frames_->tick(now_ns_, now_ns_, nullptr);
}

void ServoLink::release() {
  frames_->release([this] { tickOfFrame(); });
  frames_->drain([](const ServoSample&) {});
}

void ServoLink::endForce() {
  if (thread_) return thread_->endForce();
  frames_->endForce();
  release();
}

void ServoLink::setDevice(std::unique_ptr<Device> device) {
  if (thread_) return thread_->setDevice(std::move(device));
  release();
  frames_->end();
  frames_->setDevice(std::move(device));
  frames_->begin(now_ns_);
}

void ServoLink::record(bool on) {
  records_ = on;
  if (thread_) return thread_->record(on);
  release();
  frames_->end();
  frames_->record(on);
  frames_->begin(now_ns_);
}

void ServoLink::tryInteraction(std::unique_ptr<Interaction> felt) {
  trying_ = true;
  handOver(std::move(felt), kNoScene);
}

void ServoLink::setInteraction(std::unique_ptr<Interaction> felt) {
  trying_ = false;
  handOver(std::move(felt), scene_);
}

void ServoLink::handOver(std::unique_ptr<Interaction> felt, std::uint32_t scene) {
  ++handed_over_;
  loop().setInteraction(std::move(felt), scene);
}

bool ServoLink::setMotion(std::shared_ptr<const SphereMotion> motion) {
  if (!loop().setMotion(motion, scene_)) return false;
  motions_.push_back(std::move(motion));
  return true;
}

std::shared_ptr<const SphereMotion> ServoLink::motionOf(std::uint64_t serial) const {
  for (const auto& motion : motions_)
    if (motion->serial() == serial) return motion;
  return nullptr;
}

void ServoLink::begin(const ServoSettings& settings, std::unique_ptr<Interaction> felt) {
  ++scene_;
  motions_.clear();
  // This order ensures that the new interaction never receives the old settings.
  beginAgain(settings);
  setInteraction(std::move(felt));
}

void ServoLink::beginAgain(const ServoSettings& settings) {
  first_placement_ = settings.discontinuities;
  loop().setSettings(settings);
}

bool ServoLink::ofThisScene(const ServoSample& sample) const {
  return sample.scene == scene_ && std::int32_t(sample.discontinuities - first_placement_) >= 0;
}

void ServoLink::take(const ServoSample& sample) {
  newest_ = sample;
  every_.push_back(sample);
  if (ofThisScene(sample)) ticks_.push_back(sample);
}

const std::vector<ServoSample>& ServoLink::advance(double dt_s) {
  ticks_.clear();
  every_.clear();
  // Motions are consecutive: none before the newest tick's is needed any more.
  if (motionOf(newest_))
    while (motions_.front()->serial() != newest_.motion) motions_.pop_front();
  if (thread_) {
    loop().drain([this](const ServoSample& sample) { take(sample); });
    return ticks_;
  }
  // A page in a background tab returns with a frame as long as its absence.
  for (owed_s_ += std::clamp(dt_s, 0.0, clock_ == ServoClock::Page ? 0.1 : 0.5); owed_s_ >= kTick_s;
       owed_s_ -= kTick_s) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point began = timed_ ? Clock::now() : Clock::time_point();
    tickOfFrame();
    // The duration is only displayed; the ticks depend on the frames' clock alone.
    const float work_us = timed_ ? std::chrono::duration<float, std::micro>(Clock::now() - began).count() : 0.0f;
    loop().drain([&](ServoSample sample) {
      sample.work_us = work_us;
      take(sample);
    });
  }
  return ticks_;
}

}  // namespace moltact
