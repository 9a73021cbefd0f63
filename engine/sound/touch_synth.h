// Touch as sound: a tone whose pitch is the force, as many notes as atoms hold the probe, a scrape while the probe slides,
// a knock at contact, a click for each new atom that is reached, a thud in a pit. Arithmetic only: no device, no clock, no allocation; the same
// samples whatever the size of the blocks. One thread at a time. Units: newton, hertz, second; samples from -1 to 1.
//
//   heard                       felt
//   pitch                       force: 330 Hz without force, 8 semitones higher for each newton (3 N: two octaves)
//   one note                    a sphere: one atom holds the probe
//   two notes, a fifth apart    a crease: two atoms hold it
//   three notes, a major chord  a pit: three atoms hold it
//   loudness                    grows a little with the force, up to 2 N
//   knock                       contact begins; a lower one: contact ends
//   click                       an atom is reached that was not held before: the probe falls into a crease
//   thud                        a third atom holds the probe: it has fallen into a pit
//   scrape                      the contact point slides over the surface; louder and brighter the faster it goes
//
// Every part has its own limit, and their sum stays below 1: nothing clips, however the parts fall together.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/haptics/tracker.h"

namespace moltact {

inline constexpr int kSamples_per_s = 48000;
inline constexpr double kLowestPitch_Hz = 330.0;
inline constexpr double kSemitones_per_N = 8.0;
inline constexpr double kMaxHeard_N = 4.0;  ///< a greater force sounds like this one
/// Just intonation: the notes' frequencies over the lowest. A crease takes the first and the last, a pit all three.
inline constexpr std::array<double, 3> kChord{1.0, 5.0 / 4.0, 3.0 / 2.0};

inline constexpr double kClick_Hz = 2200.0, kKnock_Hz = 520.0, kRelease_Hz = 390.0, kThud_Hz = 110.0;
/// The limits of the parts: of one note alone (three notes together reach 1.74 of it), of the knock, of the click, of
/// the thud, of the scrape.
inline constexpr double kNoteLevel = 0.22, kKnockLevel = 0.16, kClickLevel = 0.16, kThudLevel = 0.18,
                        kScrapeLevel = 0.08;
inline constexpr double kFullScrape_A_per_s = 20.0;  ///< from this speed on the scrape is loudest

/// The pitch of a force; what is negative or not finite counts as none.
double pitch_Hz(double force_N);

/// The audible state of one tick of the servo loop.
struct TouchMoment {
  Feature feature = Feature::Free;
  std::array<std::int32_t, 3> atoms{-1, -1, -1};
  double force_N = 0.0;
  double slide_A_per_s = 0.0;  ///< of the contact point over the surface
};

class TouchSynth {
 public:
  /// Sets the state that is heard from now on.
  void take(const TouchMoment& moment) noexcept;

  /// Fills `out` with the next samples at kSamples_per_s.
  void render(std::span<float> out) noexcept;

  /// Nothing is sounding and nothing will until something is touched.
  bool silent() const noexcept;

 private:
  /// A short note: rises in 2 ms, then dies away.
  struct Blip {
    double hertz = 0, phase = 0, level = 0, fade = 0;
    int rising = 0;  // samples
    double rise = 0;
    void strike(double pitch, double peak, double decay_s) noexcept;
    double next() noexcept;
  };

  TouchMoment felt_;
  double semitones_ = 0, loudness_ = 0;     // smoothed
  std::array<double, 3> phase_{}, note_{};  // of the chord; note_ is each one's smoothed level
  Blip knock_, click_, thud_;
  int since_click_ = kSamples_per_s, since_thud_ = kSamples_per_s;
  double scrape_ = 0.0, bright_ = 0.0, dull_ = 0.0;  // its smoothed level; the noise that passed two low-passes
  std::uint32_t noise_ = 0x9E3779B9u;                // of a xorshift
  double scrape() noexcept;
};

}  // namespace moltact
