// The loudspeaker: asks for samples on a thread of its own and plays them. OpenAL is loaded when the first sound is
// wanted and not before, so a program that stays silent pays nothing, and a computer without it still starts. Where
// there is no sound card, no library or the card goes away, `fault` says so and nothing else happens.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>

namespace moltact {

class AudioOutput {
 public:
  /// Fills the samples (-1 to 1, one channel); called on the output's thread, every 10 ms.
  using Fill = std::function<void(std::span<float>)>;

  enum class State { Opening, Playing, Silent };

  /// Returns at once: the sound card is opened on the output's thread.
  AudioOutput(int samples_per_s, Fill fill);
  /// Ends the thread and lets the card go.
  ~AudioOutput();
  AudioOutput(const AudioOutput&) = delete;
  AudioOutput& operator=(const AudioOutput&) = delete;

  State state() const;
  /// Why nothing is played, in one sentence; empty unless state() is Silent.
  std::string fault() const;

 struct Impl;  // the platform's

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace moltact
