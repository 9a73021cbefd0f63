// Sonifies touch: the pitch of a tone is the force, the number of notes the number of atoms that block the probe.
// Sliding adds a scrape, a contact a knock, each newly reached atom a click, and a pit a thud. Pure computation without
// device, clock or allocation; the samples do not depend on the block size. One thread at a time. Units: newton, hertz,
// second,
// kcal/mol; samples from -1 to 1.
//
//   sound                       touch
//   pitch                       force: 330 Hz without force, 8 semitones higher per newton (3 N: two octaves)
//   one note                    a sphere: one atom blocks the probe; a held body at one contact
//   two notes, a fifth apart    a crease: two atoms block it; two contacts
//   three notes, a major chord  a pit: three atoms block it; three contacts
//   four, five, six notes       a held body at four, five, or six and more contacts: each adds a higher overtone
//   loudness                    increases slightly with the force, up to 2 N
//   knock                       contact begins; a lower one: contact ends
//   click                       a new atom blocks the probe: it has reached a crease
//   thud                        a third atom blocks the probe: it has reached a pit
//   scrape                      the contact point slides over the surface; louder and brighter at higher speed
//   one note without a knock    a field's force without contact
//   hum                         a negative energy between atoms: the lower the energy, the lower the hum, from 330 Hz
//                               at zero; -1 kcal/mol 295 Hz, -10 kcal/mol 193 Hz, -50 kcal/mol 134 Hz
//
// Every component has its own limit, and the sum of the limits is below 1, so the output never clips.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/haptics/tracker.h"

namespace moltact {

inline constexpr int kSamples_per_s = 48000;
inline constexpr double kMinPitch_Hz = 330.0;
inline constexpr double kSemitones_per_N = 8.0;
inline constexpr double kMaxHeard_N = 4.0;  ///< larger forces sound like this one
/// Just intonation: frequency ratios to the lowest note. Two notes are the first and the third. The
/// ratios are 4 : 5 : 6 : 7 : 8 : 9, overtones of one tone.
inline constexpr std::array<double, 6> kChord{1.0, 5.0 / 4.0, 3.0 / 2.0, 7.0 / 4.0, 2.0, 9.0 / 4.0};

inline constexpr double kClick_Hz = 2200.0, kKnock_Hz = 520.0, kRelease_Hz = 390.0, kThud_Hz = 110.0;
/// Peak levels of the components: a single note (three notes or more together reach 1.74 times this), the knock, the
/// click, the thud, the scrape, the hum.
inline constexpr double kNoteLevel = 0.22, kKnockLevel = 0.14, kClickLevel = 0.14, kThudLevel = 0.16,
                        kScrapeLevel = 0.07, kHumLevel = 0.09;
inline constexpr double kFullScrape_A_per_s = 20.0;  ///< speed from which the scrape has its full level

inline constexpr double kFullHum_kcal_mol = -0.5;  ///< energy from which the hum has its full level

/// The pitch of the hum of an energy; a positive or non-finite energy counts as zero.
double hum_Hz(double energy_kcal_mol);

/// The pitch of a force; a negative or non-finite force counts as zero.
double pitch_Hz(double force_N);

/// The part of a tick that is audible.
struct TouchMoment {
  Feature feature = Feature::Free;
  std::array<std::int32_t, 3> atoms{-1, -1, -1};
  double force_N = 0.0;
  double slide_A_per_s = 0.0;  ///< speed of the contact point over the surface
  bool field = false;          ///< a field's force is felt, in contact or without
  std::size_t contacts = 0;    ///< of a held body: the number of notes; 0: the feature decides

  double energy_kcal_mol = 0.0;  ///< between what is held and the molecule; hums if negative

  bool touches() const { return feature != Feature::Free; }
  bool sounds() const { return touches() || field; }
};

class TouchSynth {
 public:
  /// Sets the state to sonify from now on.
  void take(const TouchMoment& moment) noexcept;

  /// Fills `out` with the next samples at kSamples_per_s.
  void render(std::span<float> out) noexcept;

  /// True if there is no sound and will be none until the next touch.
  bool silent() const noexcept;

 private:
  /// A short note: an attack of 2 ms, then an exponential decay.
  struct Blip {
    double hertz = 0, phase = 0, level = 0, fade = 0;
    int rising = 0;  // remaining samples of the attack
    double rise = 0;
    void strike(double pitch, double peak, double decay_s) noexcept;
    double next() noexcept;
  };

  TouchMoment felt_;
  double semitones_ = 0, loudness_ = 0;                 // smoothed
  std::array<double, kChord.size()> phase_{}, note_{};  // of the chord; note_ contains the smoothed levels
  Blip knock_, click_, thud_;
  int since_click_ = kSamples_per_s, since_thud_ = kSamples_per_s;
  double hum_ = 0.0, hum_octaves_ = 0.0, hum_phase_ = 0.0;  // smoothed level and pitch, below kMinPitch_Hz
  double hum() noexcept;
  double scrape_ = 0.0, bright_ = 0.0, dull_ = 0.0;  // smoothed level; noise after two low-pass filters
  std::uint32_t noise_ = 0x9E3779B9u;                // state of a xorshift generator
  double scrape() noexcept;
};

}  // namespace moltact
