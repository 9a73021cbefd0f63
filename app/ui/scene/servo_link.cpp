#include "app/ui/scene/servo_link.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace moltact {

namespace {
constexpr std::uint32_t kNoScene = 0xFFFFFFFF;
}

ServoLink::ServoLink(ServoClock clock) {
  ticks_.reserve(4096);
  every_.reserve(4096);
  switch_.emplace(mouse_, nullptr);
  if (clock != ServoClock::RealThread) return;
  thread_ = std::make_unique<ServoThread>(mouse_);
  thread_->expectSettings();
}

ServoLink::~ServoLink() {
  if (!thread_) release();
}

// On the frames' clock: ticks without a wish for force until there is none.
void ServoLink::release() {
  constexpr int kMost_ticks = 50;
  ServoSettings off = settings_;
  off.force_on = false;
  for (int k = 0; chosen_ && k < kMost_ticks; ++k) {
    const DevicePose pose = switch_->read(kTick_s, step_);
    const ServoSample sample = step_.tick(off, tracker_.get(), pose, {});
    switch_->write(sample.force);
    if (sample.force.N == Vec3(0.0)) break;
  }
  switch_->write(ForceN{});
}

void ServoLink::endForce() {
  if (thread_) return thread_->endForce();
  release();
  ended_ = true;
}

void ServoLink::setSettings(const ServoSettings& settings) {
  if (thread_)
    thread_->setSettings(settings);
  else
    settings_ = settings;
}

void ServoLink::setDevice(std::unique_ptr<Device> device) {
  if (thread_) {
    thread_->setDevice(std::move(device));
    return;
  }
  release();
  switch_.reset();
  chosen_ = std::move(device);
  switch_.emplace(mouse_, chosen_.get());
}

void ServoLink::tryTracker(std::unique_ptr<Tracker> tracker) {
  trying_ = true;
  handOver(std::move(tracker), kNoScene);
}

void ServoLink::setTracker(std::unique_ptr<Tracker> tracker) {
  trying_ = false;
  handOver(std::move(tracker), scene_);
}

void ServoLink::handOver(std::unique_ptr<Tracker> tracker, std::uint32_t scene) {
  ++trackers_;
  if (thread_)
    thread_->setTracker(std::move(tracker), scene);
  else
    tracker_ = std::move(tracker);
}

void ServoLink::record(bool on) {
  if (thread_) return thread_->record(on);
  records_ = on;
  recorded_.clear();
  if (!on) return;
  // The first tick says which device leads, as on the thread.
  switch_.emplace(mouse_, chosen_.get());
  step_.forgetTracker();
  record_start_ = step_;
}

void ServoLink::begin(const ServoSettings& settings, std::unique_ptr<Tracker> tracker) {
  ++scene_;
  // In this order: the new tracker is never stepped with the old settings.
  beginAgain(settings);
  setTracker(std::move(tracker));
}

void ServoLink::beginAgain(const ServoSettings& settings) {
  first_placement_ = settings.discontinuities;
  setSettings(settings);
}

bool ServoLink::ofThisScene(const ServoSample& sample) const {
  return sample.scene == scene_ && std::int32_t(sample.discontinuities - first_placement_) >= 0;
}

const std::vector<ServoSample>& ServoLink::advance(double dt_s) {
  ticks_.clear();
  every_.clear();
  if (thread_) {
    thread_->drain([this](const ServoSample& sample) {
      newest_ = sample;
      every_.push_back(sample);
      if (ofThisScene(sample)) ticks_.push_back(sample);
    });
    return ticks_;
  }
  owed_s_ += std::clamp(dt_s, 0.0, 0.5);
  for (; owed_s_ >= kTick_s; owed_s_ -= kTick_s) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point began = timed_ ? Clock::now() : Clock::time_point();
    const TickTime time{.dt_s = kTick_s + std::exchange(stands_s_, 0.0)};
    if (ended_) settings_.force_on = false;
    const DevicePose pose = switch_->read(kTick_s, step_);
    ServoSample sample = step_.tick(settings_, tracker_.get(), pose, time);
    sample.scene = trying_ ? kNoScene : scene_;
    switch_->write(sample.force);
    if (records_)
      recorded_.push_back({settings_, pose, time, switch_->info(), switch_->other(), sample.force,
                           switch_->fallenBack(), sample.contact.touching(), sample.limits});
    newest_ = sample;
    if (timed_) sample.work_us = std::chrono::duration<float, std::micro>(Clock::now() - began).count();
    every_.push_back(sample);
    if (ofThisScene(sample)) ticks_.push_back(sample);
  }
  return ticks_;
}

RealtimeStatus ServoLink::realtime() const { return thread_ ? thread_->realtime() : RealtimeStatus::Ordinary; }

}  // namespace moltact
