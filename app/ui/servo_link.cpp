#include "app/ui/servo_link.h"

#include <algorithm>
#include <chrono>

namespace moltact {

ServoLink::ServoLink(ServoClock clock) {
  ticks_.reserve(4096);
  if (clock == ServoClock::RealThread) thread_ = std::make_unique<ServoThread>(mouse_);
}

void ServoLink::setSettings(const ServoSettings& settings) {
  if (thread_) thread_->setSettings(settings);
  else settings_ = settings;
}

void ServoLink::setTracker(std::unique_ptr<Tracker> tracker) {
  if (thread_) thread_->setTracker(std::move(tracker));
  else tracker_ = std::move(tracker);
}

const std::vector<ServoSample>& ServoLink::advance(double dt_s) {
  ticks_.clear();
  if (thread_) {
    thread_->drain([this](const ServoSample& sample) { ticks_.push_back(sample); });
    return ticks_;
  }
  owed_s_ += std::clamp(dt_s, 0.0, 0.5);
  for (; owed_s_ >= kTick_s; owed_s_ -= kTick_s) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point began = timed_ ? Clock::now() : Clock::time_point();
    ServoSample sample = step_.tick(settings_, tracker_.get(), mouse_.read(kTick_s));
    mouse_.write(sample.force);
    if (timed_) sample.work_us = std::chrono::duration<float, std::micro>(Clock::now() - began).count();
    ticks_.push_back(sample);
  }
  return ticks_;
}

RealtimeStatus ServoLink::realtime() const { return thread_ ? thread_->realtime() : RealtimeStatus::Ordinary; }

}  // namespace moltact
