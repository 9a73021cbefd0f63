#include "engine/results/turns.h"

#include <algorithm>

#include "engine/core/text.h"

namespace moltact {
namespace {
const std::string kNobody;
}

std::vector<std::string> Turns::namesIn(std::string_view lines) {
  std::vector<std::string> out;
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    std::string name(trimmed(lines.substr(0, end)));
    lines.remove_prefix(std::min(end + 1, lines.size()));
    if (!name.empty() && std::find(out.begin(), out.end(), name) == out.end()) out.push_back(std::move(name));
  }
  return out;
}

void Turns::begin(std::vector<std::string> names, double turn_s) {
  if (names.empty()) return;
  names_ = std::move(names);
  turn_s_ = turn_s >= kShortest_s ? std::min(turn_s, kLongest_s) : kShortest_s;
  at_ = begun_ = 0;
  left_s_ = turn_s_;
  state_ = State::HandOver;
}

const std::string& Turns::current() const { return on() ? names_[at_] : kNobody; }

const std::string& Turns::next() const { return on() ? names_[(at_ + 1) % names_.size()] : kNobody; }

std::vector<std::string> Turns::waiting() const {
  std::vector<std::string> out;
  if (on())
    for (std::size_t k = 1; k < names_.size(); ++k) out.push_back(names_[(at_ + k) % names_.size()]);
  return out;
}

void Turns::start() {
  if (state_ != State::HandOver) return;
  state_ = State::Running;
  left_s_ = turn_s_;
  ++begun_;
}

void Turns::pause() {
  if (state_ == State::Running) state_ = State::Paused;
}

void Turns::resume() {
  if (state_ == State::Paused) state_ = State::Running;
}

void Turns::passOn() {
  if (!on()) return;
  at_ = (at_ + 1) % names_.size();
  left_s_ = turn_s_;
  state_ = State::HandOver;
}

void Turns::call(std::string_view name) {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (!on() || found == names_.end()) return;
  at_ = std::size_t(found - names_.begin());
  left_s_ = turn_s_;
  state_ = State::HandOver;
}

void Turns::extend(double by_s) {
  if (on()) left_s_ = std::clamp(left_s_ + by_s, 0.0, kLongest_s);
}

void Turns::leave(std::string_view name) {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (!on() || found == names_.end()) return;
  const std::size_t index = std::size_t(found - names_.begin());
  names_.erase(found);
  if (names_.empty()) return end();
  if (index < at_)
    --at_;
  else if (index == at_) {
    at_ %= names_.size();
    left_s_ = turn_s_;
    state_ = State::HandOver;
  }
}

bool Turns::tick(double dt_s) {
  if (state_ != State::Running || !(dt_s > 0.0)) return false;
  left_s_ -= dt_s;
  if (left_s_ > 0.0) return false;
  passOn();
  return true;
}

}  // namespace moltact
