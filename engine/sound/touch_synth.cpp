#include "engine/sound/touch_synth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/units.h"

namespace moltact {
namespace {

constexpr double kKnockDecay_s = 0.030, kClickDecay_s = 0.008, kThudDecay_s = 0.060;
constexpr int kRise_samples = kSamples_per_s * 2 / 1000;
// A higher rate would sound like a buzz.
constexpr int kClickEvery_samples = kSamples_per_s / 25, kThudEvery_samples = kSamples_per_s / 8;
constexpr double kInaudible = 1e-5;
constexpr double kQuietest = 0.35, kLoudFrom_N = 2.0;  // level of the tone without force; force of the full level

double heard_N(double force_N) { return std::isfinite(force_N) ? std::clamp(force_N, 0.0, kMaxHeard_N) : 0.0; }

// The smoothing factor per sample of a first-order filter with time constant `time_s`.
double pull(double time_s) { return 1.0 - std::exp(-1.0 / (time_s * kSamples_per_s)); }

const double kAttack = pull(0.008), kRelease = pull(0.030), kGlide = pull(0.025), kCross = pull(0.015);

// The smoothing factor per sample of a one-pole low-pass filter.
double lowPass(double hertz) { return 1.0 - std::exp(-kTwoPi * hertz / kSamples_per_s); }

const double kDull = lowPass(500.0), kBrightest = lowPass(3200.0), kMinBright = lowPass(1200.0);

double advance(double& phase, double hertz) {
  const double now = std::sin(kTwoPi * phase);
  phase += hertz / kSamples_per_s;
  phase -= std::floor(phase);
  return now;
}

// Octaves by which the hum is below its highest pitch: even steps of the ear at any depth of a well.
double humOctaves(double energy_kcal_mol) {
  constexpr double kEven_kcal_mol = 2.0, kOctaves = 1.0 / 3.0, kDeepest_kcal_mol = 500.0;
  return std::isfinite(energy_kcal_mol)
             ? kOctaves * std::asinh(std::clamp(-energy_kcal_mol, 0.0, kDeepest_kcal_mol) / kEven_kcal_mol)
             : 0.0;
}

double humShare(double energy_kcal_mol) {
  return std::isfinite(energy_kcal_mol) ? std::clamp(energy_kcal_mol / kFullHum_kcal_mol, 0.0, 1.0) : 0.0;
}

using Notes = std::array<double, kChord.size()>;

// The level of each note of the chord. One, two and three notes have equal power; of more, the sum of the levels stays
// that of three, so that the output never clips.
Notes notesOf(const TouchMoment& moment) {
  const std::size_t of_feature = moment.feature == Feature::Point ? 3 : moment.feature == Feature::Circle ? 2 : 1;
  const std::size_t count = moment.contacts > 0 ? std::min(moment.contacts, kChord.size()) : of_feature;
  if (count == 1) return {1.0};
  if (count == 2) return {std::numbers::sqrt2 / 2, 0.0, std::numbers::sqrt2 / 2};
  Notes out{};
  std::fill_n(out.begin(), count, std::numbers::sqrt3 / double(count));
  return out;
}

bool reachesNewAtom(const TouchMoment& before, const TouchMoment& now) {
  return std::any_of(now.atoms.begin(), now.atoms.end(), [&](std::int32_t atom) {
    return atom >= 0 && std::find(before.atoms.begin(), before.atoms.end(), atom) == before.atoms.end();
  });
}

}  // namespace

double hum_Hz(double energy_kcal_mol) { return kMinPitch_Hz * std::exp2(-humOctaves(energy_kcal_mol)); }

double pitch_Hz(double force_N) { return kMinPitch_Hz * std::exp2(kSemitones_per_N * heard_N(force_N) / 12.0); }

void TouchSynth::Blip::strike(double pitch, double peak, double decay_s) noexcept {
  hertz = pitch;
  if (level == 0.0) phase = 0.0;
  rising = kRise_samples;
  rise = (peak - level) / kRise_samples;
  fade = 1.0 - pull(decay_s);
}

double TouchSynth::Blip::next() noexcept {
  if (level == 0.0 && rising == 0) return 0.0;
  const double now = level * advance(phase, hertz);
  if (rising > 0) {
    level += rise;
    --rising;
  } else {
    level *= fade;
    if (level < kInaudible) level = 0.0;
  }
  return now;
}

void TouchSynth::take(const TouchMoment& moment) noexcept {
  const bool was = felt_.touches(), is = moment.touches();
  // A new tone starts at its own pitch instead of gliding from that of the last one.
  if (moment.sounds() && !felt_.sounds() && loudness_ == 0.0) {
    semitones_ = kSemitones_per_N * heard_N(moment.force_N);
    note_ = notesOf(moment);
  }
  if (is && !was) {
    knock_.strike(kKnock_Hz, kKnockLevel, kKnockDecay_s);
  } else if (was && !is) {
    knock_.strike(kRelease_Hz, 0.5 * kKnockLevel, kKnockDecay_s);
  } else if (is && reachesNewAtom(felt_, moment) && since_click_ >= kClickEvery_samples) {
    click_.strike(kClick_Hz, kClickLevel, kClickDecay_s);
    since_click_ = 0;
  }
  if (moment.feature == Feature::Point && felt_.feature != Feature::Point && since_thud_ >= kThudEvery_samples) {
    thud_.strike(kThud_Hz, kThudLevel, kThudDecay_s);
    since_thud_ = 0;
  }
  felt_ = moment;
}

// A tone with two overtones, by which small loudspeakers that lack its lowest pitch carry it.
double TouchSynth::hum() noexcept {
  const double wanted = humShare(felt_.energy_kcal_mol);
  if (wanted == 0.0 && hum_ == 0.0) return 0.0;
  if (hum_ == 0.0) hum_octaves_ = humOctaves(felt_.energy_kcal_mol);
  if (wanted > 0.0) hum_octaves_ += (humOctaves(felt_.energy_kcal_mol) - hum_octaves_) * kGlide;
  hum_ += (wanted - hum_) * (wanted > hum_ ? kAttack : kRelease);
  if (wanted == 0.0 && hum_ < kInaudible) hum_ = 0.0;
  const double turn = kTwoPi * hum_phase_;
  advance(hum_phase_, kMinPitch_Hz * std::exp2(-hum_octaves_));
  constexpr double kSecond = 0.6, kThird = 0.3;
  return kHumLevel * hum_ / (1.0 + kSecond + kThird) *
         (std::sin(turn) + kSecond * std::sin(2.0 * turn) + kThird * std::sin(3.0 * turn));
}

// Noise between two low-pass filters; the cutoff of the upper one increases with the speed.
double TouchSynth::scrape() noexcept {
  const double speed = !felt_.touches() || !std::isfinite(felt_.slide_A_per_s)
                           ? 0.0
                           : std::clamp(felt_.slide_A_per_s / kFullScrape_A_per_s, 0.0, 1.0);
  if (speed == 0.0 && scrape_ == 0.0) return 0.0;
  noise_ ^= noise_ << 13;
  noise_ ^= noise_ >> 17;
  noise_ ^= noise_ << 5;
  const double white = double(noise_) / 2147483648.0 - 1.0;
  bright_ += (white - bright_) * (kMinBright + (kBrightest - kMinBright) * scrape_);
  dull_ += (white - dull_) * kDull;
  scrape_ += (speed - scrape_) * (speed > scrape_ ? kAttack : kRelease);
  if (speed == 0.0 && scrape_ < kInaudible) scrape_ = 0.0;
  return kScrapeLevel * scrape_ * std::clamp(2.0 * (bright_ - dull_), -1.0, 1.0);
}

void TouchSynth::render(std::span<float> out) noexcept {
  const double force = heard_N(felt_.force_N);
  const bool on = felt_.sounds();
  const double loudness = on ? kQuietest + (1 - kQuietest) * std::min(1.0, force / kLoudFrom_N) : 0.0;
  const double semitones = on ? kSemitones_per_N * force : semitones_;
  const Notes notes = on ? notesOf(felt_) : note_;
  for (float& sample : out) {
    double sum = knock_.next() + click_.next() + thud_.next() + scrape() + hum();
    since_click_ = std::min(since_click_ + 1, kSamples_per_s);
    since_thud_ = std::min(since_thud_ + 1, kSamples_per_s);
    if (loudness_ > 0.0 || loudness > 0.0) {
      const double pitch = kMinPitch_Hz * std::exp2(semitones_ / 12.0);
      for (std::size_t k = 0; k < kChord.size(); ++k) {
        sum += kNoteLevel * loudness_ * note_[k] * advance(phase_[k], pitch * kChord[k]);
        note_[k] += (notes[k] - note_[k]) * kCross;
      }
      semitones_ += (semitones - semitones_) * kGlide;
      loudness_ += (loudness - loudness_) * (loudness > loudness_ ? kAttack : kRelease);
      if (loudness == 0.0 && loudness_ < kInaudible) {
        loudness_ = 0.0;
        phase_ = {};
      }
    }
    sample = float(sum);
  }
}

bool TouchSynth::silent() const noexcept {
  const auto quiet = [](const Blip& blip) { return blip.level == 0.0 && blip.rising == 0; };
  return !felt_.sounds() && loudness_ == 0.0 && scrape_ == 0.0 && hum_ == 0.0 &&
         humShare(felt_.energy_kcal_mol) == 0.0 && quiet(knock_) && quiet(click_) && quiet(thud_);
}

}  // namespace moltact
