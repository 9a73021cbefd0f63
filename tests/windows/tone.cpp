// Plays 440 Hz for two seconds and prints what the output says of itself: the sound of the build for Windows without its
// window (tests/windows/run.py).
#include <atomic>
#include <chrono>
#include <cmath>
#include <iostream>
#include <numbers>
#include <thread>

#include "engine/platform/audio_output.h"

int main() {
  constexpr int kRate = 48000;
  std::atomic<int> asked{0};
  moltact::AudioOutput output(kRate, [&, sample = 0](std::span<float> out) mutable {
    for (float& s : out) s = 0.5f * float(std::sin(2 * std::numbers::pi * 440.0 * sample++ / kRate));
    asked += int(out.size());
  });
  const auto nap = std::chrono::milliseconds(10);
  for (int k = 0; k < 1000 && output.state() == moltact::AudioOutput::State::Opening; ++k)
    std::this_thread::sleep_for(nap);
  for (int k = 0; k < 200 && output.state() == moltact::AudioOutput::State::Playing; ++k)
    std::this_thread::sleep_for(nap);
  std::cout << (output.state() == moltact::AudioOutput::State::Playing ? "playing" : "silent") << ' ' << asked << ' '
            << output.fault() << '\n';
}
