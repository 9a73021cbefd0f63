// Audio output: requests samples on a thread of its own and plays them. OpenAL is loaded with the first sound. A silent
// program therefore costs nothing, and a computer without OpenAL still starts it. Without sound card or library, or
// after the card has disappeared, `fault` returns the reason and nothing is played.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>

namespace moltact {

class AudioOutput {
 public:
  /// Fills the samples (-1 to 1, one channel). Called on the output's thread every 10 ms.
  using Fill = std::function<void(std::span<float>)>;

  enum class State { Opening, Playing, Silent };

  /// Returns immediately; the output's thread opens the sound card.
  AudioOutput(int samples_per_s, Fill fill);
  /// Ends the thread and releases the sound card.
  ~AudioOutput();
  AudioOutput(const AudioOutput&) = delete;
  AudioOutput& operator=(const AudioOutput&) = delete;

  State state() const;
  /// The reason for silence in one sentence; empty unless state() is Silent.
  std::string fault() const;

  struct Impl;  // defined by the platform

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace moltact
