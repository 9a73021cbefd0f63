// The loudspeaker: asks for samples on a thread of its own and plays them. OpenAL is loaded when the first sound is
// wanted and not before, so a silent program pays nothing, and a computer without OpenAL still starts. Where there is
// no sound card, no library, or the card disappears, `fault` says so and nothing else happens.
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
  /// Ends the thread and releases the card.
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
