// Oracles: the pitch by counting zero crossings, single frequencies by correlation with sine and cosine, and bounds
// from amplitude and frequency. None shares code with the synthesizer.
#include "engine/sound/touch_synth.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstring>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>
#include <vector>

#include "engine/sound/wav_file.h"

using namespace moltact;

namespace {

constexpr double kTouchSynthRate = kSamples_per_s;

std::vector<float> sounding(TouchSynth& synth, double for_s) {
  std::vector<float> out(std::size_t(std::lround(for_s * kTouchSynthRate)));
  synth.render(out);
  return out;
}

TouchMoment on(Feature feature, double force_N, std::array<std::int32_t, 3> atoms = {0, -1, -1}) {
  return {feature, atoms, force_N, 0.0};
}

// Rising zero crossings, each placed between its two samples; the mean distance is the period.
double frequencyOf(const std::vector<float>& s) {
  double first = -1, last = -1;
  int periods = -1;
  for (std::size_t k = 1; k < s.size(); ++k) {
    if (!(s[k - 1] < 0 && s[k] >= 0)) continue;
    last = double(k - 1) + double(-s[k - 1]) / double(s[k] - s[k - 1]);
    if (first < 0) first = last;
    ++periods;
  }
  return periods > 0 ? kTouchSynthRate * periods / (last - first) : 0.0;
}

// The amplitude of one frequency: correlation under a Hann window, which keeps other notes out.
double amplitudeAt(const std::vector<float>& s, double hertz) {
  std::complex<double> sum = 0;
  double weight = 0;
  for (std::size_t k = 0; k < s.size(); ++k) {
    const double w = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * double(k) / double(s.size()));
    sum += w * double(s[k]) * std::polar(1.0, -2 * std::numbers::pi * hertz * double(k) / kTouchSynthRate);
    weight += w;
  }
  return 2 * std::abs(sum) / weight;
}

std::vector<float> steadyTone(Feature feature, double force_N) {
  TouchSynth synth;
  synth.take(on(feature, force_N));
  sounding(synth, 0.5);
  return sounding(synth, 1.0);
}

double peak(const std::vector<float>& s) {
  double most = 0;
  for (const float x : s) most = std::max(most, std::abs(double(x)));
  return most;
}

// The largest second difference: a sine of amplitude A and frequency f has A (2 pi f / rate)^2, a click far more.
double sharpest(const std::vector<float>& s) {
  double most = 0;
  for (std::size_t k = 2; k < s.size(); ++k)
    most = std::max(most, std::abs(double(s[k]) - 2.0 * double(s[k - 1]) + double(s[k - 2])));
  return most;
}

double bend(double amplitude, double hertz) {
  return amplitude * std::pow(2 * std::numbers::pi * hertz / kTouchSynthRate, 2);
}

}  // namespace

TEST_CASE("0, 1, 1.5 and 3 N on one atom sound at 330, 523.8, 660 and 1320 Hz, within 0.1 Hz by zero crossings") {
  CHECK(frequencyOf(steadyTone(Feature::Sphere, 0.0)) == doctest::Approx(330.0).epsilon(0.0002));
  CHECK(frequencyOf(steadyTone(Feature::Sphere, 1.0)) ==
        doctest::Approx(330.0 * std::pow(2.0, 8.0 / 12.0)).epsilon(0.0002));
  CHECK(frequencyOf(steadyTone(Feature::Sphere, 1.5)) == doctest::Approx(660.0).epsilon(0.0002));
  CHECK(frequencyOf(steadyTone(Feature::Sphere, 3.0)) == doctest::Approx(1320.0).epsilon(0.0001));
}

TEST_CASE("a sphere is one note, a crease a fifth, a pit a major chord, each of the same power") {
  const double f = 660.0;
  const auto sphere = steadyTone(Feature::Sphere, 1.5), crease = steadyTone(Feature::Circle, 1.5),
             pit = steadyTone(Feature::Point, 1.5);
  CHECK(amplitudeAt(sphere, f) > 0.1);
  CHECK(amplitudeAt(sphere, f * 1.25) < 1e-4);
  CHECK(amplitudeAt(sphere, f * 1.5) < 1e-4);
  CHECK(amplitudeAt(crease, f) == doctest::Approx(amplitudeAt(crease, f * 1.5)).epsilon(0.001));
  CHECK(amplitudeAt(crease, f * 1.25) < 1e-4);
  CHECK(amplitudeAt(pit, f) == doctest::Approx(amplitudeAt(pit, f * 1.25)).epsilon(0.001));
  CHECK(amplitudeAt(pit, f) == doctest::Approx(amplitudeAt(pit, f * 1.5)).epsilon(0.001));
  const auto power = [](const std::vector<float>& s) {
    double sum = 0;
    for (const float x : s) sum += double(x) * double(x);
    return sum / double(s.size());
  };
  CHECK(power(crease) == doctest::Approx(power(sphere)).epsilon(0.01));
  CHECK(power(pit) == doctest::Approx(power(sphere)).epsilon(0.01));
}

TEST_CASE(
    "3, 4, 5 and 6 contacts of a held body are as many notes, at 1, 5/4, 3/2, 7/4, 2 and 9/4 of the lowest, also where "
    "one atom stops them all; 40 contacts sound as 6, one and two as a sphere and a crease") {
  const double f = 660.0;
  const std::array<double, 6> ratios{1.0, 1.25, 1.5, 1.75, 2.0, 2.25};
  const auto toneOf = [](Feature feature, std::size_t contacts) {
    TouchMoment moment = on(feature, 1.5);
    moment.contacts = contacts;
    TouchSynth synth;
    synth.take(moment);
    sounding(synth, 0.5);
    return sounding(synth, 1.0);
  };
  const double alone = amplitudeAt(toneOf(Feature::Sphere, 0), f);
  for (const std::size_t contacts : {3u, 4u, 5u, 6u, 40u}) {
    CAPTURE(contacts);
    const auto tone = toneOf(Feature::Point, contacts);
    CHECK(amplitudeAt(toneOf(Feature::Sphere, contacts), 1.75 * f) == doctest::Approx(amplitudeAt(tone, 1.75 * f)));
    const std::size_t notes = std::min<std::size_t>(contacts, 6);
    for (std::size_t k = 0; k < ratios.size(); ++k) {
      CAPTURE(k);
      if (k < notes)
        CHECK(amplitudeAt(tone, f * ratios[k]) ==
              doctest::Approx(alone * std::sqrt(3.0) / double(notes)).epsilon(0.001));
      else
        CHECK(amplitudeAt(tone, f * ratios[k]) < 1e-4);
    }
    CHECK(peak(tone) <= 0.22 * std::sqrt(3.0) + 1e-3);
  }
  // The thud of a pit has nearly ended, so the tones are compared and not the samples.
  for (const double ratio : ratios) {
    CHECK(std::abs(amplitudeAt(toneOf(Feature::Point, 1), f * ratio) -
                   amplitudeAt(toneOf(Feature::Sphere, 0), f * ratio)) < 1e-4);
    CHECK(std::abs(amplitudeAt(toneOf(Feature::Point, 2), f * ratio) -
                   amplitudeAt(toneOf(Feature::Circle, 0), f * ratio)) < 1e-4);
  }
}

TEST_CASE("without touch there is exact silence, and again 1 s after the touch has ended") {
  TouchSynth synth;
  CHECK(peak(sounding(synth, 0.1)) == 0.0);
  CHECK(synth.silent());
  synth.take(on(Feature::Sphere, 1.0));
  CHECK(peak(sounding(synth, 0.2)) > 0.05);
  CHECK_FALSE(synth.silent());
  synth.take({});
  sounding(synth, 1.0);
  CHECK(peak(sounding(synth, 0.1)) == 0.0);
  CHECK(synth.silent());
}

TEST_CASE("a field of 1.5 N without contact is one note of 660 Hz, without knock or scrape, and ends in silence") {
  // The knock of a sphere has ended after half a second; then its tone has the same samples.
  TouchSynth of_field, of_sphere;
  of_field.take({.force_N = 1.5, .slide_A_per_s = 20.0, .field = true});
  of_sphere.take(on(Feature::Sphere, 1.5));
  std::vector<float> field = sounding(of_field, 0.5), sphere = sounding(of_sphere, 0.5);
  double apart = 0.0;
  for (std::size_t k = 0; k < field.size(); ++k) apart = std::max(apart, std::abs(double(field[k] - sphere[k])));
  CHECK(apart > 0.05);
  field = sounding(of_field, 1.0), sphere = sounding(of_sphere, 1.0);
  apart = 0.0;
  for (std::size_t k = 0; k < field.size(); ++k) apart = std::max(apart, std::abs(double(field[k] - sphere[k])));
  CHECK(apart < 1e-4);
  CHECK(frequencyOf(field) == doctest::Approx(660.0).epsilon(0.1 / 660.0));
  CHECK_FALSE(of_field.silent());
  of_field.take({});
  sounding(of_field, 1.0);
  CHECK(of_field.silent());
}

TEST_CASE("contact knocks at 520 Hz and its end at 390 Hz") {
  TouchSynth synth;
  synth.take(on(Feature::Sphere, 0.0));
  CHECK(amplitudeAt(sounding(synth, 0.1), kKnock_Hz) > 0.01);
  CHECK(amplitudeAt(sounding(synth, 0.5), kKnock_Hz) < 0.003);
  synth.take({});
  CHECK(amplitudeAt(sounding(synth, 0.1), kRelease_Hz) > 0.01);
}

TEST_CASE("reaching a second atom clicks at 2200 Hz, letting the first go does not") {
  TouchSynth synth;
  synth.take(on(Feature::Sphere, 0.5, {7, -1, -1}));
  sounding(synth, 1.0);
  CHECK(amplitudeAt(sounding(synth, 0.05), kClick_Hz) < 1e-4);
  synth.take(on(Feature::Circle, 0.5, {7, 9, -1}));
  CHECK(amplitudeAt(sounding(synth, 0.05), kClick_Hz) > 0.01);
  sounding(synth, 1.0);
  synth.take(on(Feature::Sphere, 0.5, {9, -1, -1}));
  CHECK(amplitudeAt(sounding(synth, 0.05), kClick_Hz) < 5e-4);
  sounding(synth, 1.0);
  synth.take(on(Feature::Sphere, 0.5, {3, -1, -1}));
  CHECK(amplitudeAt(sounding(synth, 0.05), kClick_Hz) > 0.01);
}

TEST_CASE("a pit thuds at 110 Hz when the probe falls into it, and not while it lies there; a crease does not") {
  TouchSynth synth;
  synth.take(on(Feature::Sphere, 0.5, {1, -1, -1}));
  sounding(synth, 1.0);
  synth.take(on(Feature::Circle, 0.5, {1, 2, -1}));
  CHECK(amplitudeAt(sounding(synth, 0.1), kThud_Hz) < 1e-3);
  sounding(synth, 1.0);
  synth.take(on(Feature::Point, 0.5, {1, 2, 3}));
  CHECK(amplitudeAt(sounding(synth, 0.1), kThud_Hz) > 0.02);
  sounding(synth, 1.0);
  synth.take(on(Feature::Point, 0.6, {1, 2, 3}));
  CHECK(amplitudeAt(sounding(synth, 0.1), kThud_Hz) < 1e-3);
}

TEST_CASE("a probe that slides scrapes: noise within its limit, louder the faster, none at rest, none in the open") {
  // What is left of the sound when the tone, whose frequency is known, is taken out of it.
  const auto scrapeOf = [](double slide_A_per_s, Feature feature) {
    TouchSynth synth;
    TouchMoment moment = on(feature, 0.0);
    moment.slide_A_per_s = slide_A_per_s;
    synth.take(moment);
    sounding(synth, 0.5);
    const std::vector<float> s = sounding(synth, 1.0);
    double sine = 0, cosine = 0;
    const auto turn = [](std::size_t k) { return 2 * std::numbers::pi * kMinPitch_Hz * double(k) / kTouchSynthRate; };
    for (std::size_t k = 0; k < s.size(); ++k) {
      sine += 2.0 * double(s[k]) * std::sin(turn(k)) / double(s.size());
      cosine += 2.0 * double(s[k]) * std::cos(turn(k)) / double(s.size());
    }
    double power = 0, most = 0;
    for (std::size_t k = 0; k < s.size(); ++k) {
      const double rest = double(s[k]) - sine * std::sin(turn(k)) - cosine * std::cos(turn(k));
      power += rest * rest / double(s.size());
      most = std::max(most, std::abs(rest));
    }
    CHECK(most <= kScrapeLevel + 1e-3);
    return std::sqrt(power);
  };
  CHECK(scrapeOf(0.0, Feature::Sphere) < 1e-4);
  const double slow = scrapeOf(3.0, Feature::Sphere), fast = scrapeOf(15.0, Feature::Sphere);
  CHECK(slow > 0.001);
  CHECK(fast > 3.0 * slow);
  CHECK(scrapeOf(1e9, Feature::Sphere) ==
        doctest::Approx(scrapeOf(kFullScrape_A_per_s, Feature::Sphere)).epsilon(0.01));
  CHECK(scrapeOf(std::nan(""), Feature::Sphere) < 1e-4);
  CHECK(scrapeOf(15.0, Feature::Free) == 0.0);
}

TEST_CASE(
    "a negative energy hums at 295 Hz for -1 kcal/mol, 193 Hz for -10 and 134 Hz for -50, found in the samples' "
    "spectrum; the hum is quiet at zero and above, and for numbers that are none") {
  const auto levelAt = [](const std::vector<float>& s, double hertz) {
    double sine = 0, cosine = 0;
    for (std::size_t k = 0; k < s.size(); ++k) {
      const double turn = 2 * std::numbers::pi * hertz * double(k) / kTouchSynthRate;
      sine += 2.0 * double(s[k]) * std::sin(turn) / double(s.size());
      cosine += 2.0 * double(s[k]) * std::cos(turn) / double(s.size());
    }
    return std::hypot(sine, cosine);
  };
  const auto heard = [](double energy) {
    TouchSynth synth;
    synth.take({.energy_kcal_mol = energy});
    sounding(synth, 0.5);
    return sounding(synth, 1.0);
  };
  for (const auto& [energy, hertz] : {std::pair{-1.0, 295.0}, std::pair{-10.0, 193.0}, std::pair{-50.0, 134.0}}) {
    CAPTURE(energy);
    CHECK(hum_Hz(energy) == doctest::Approx(hertz).epsilon(0.003));
    const std::vector<float> s = heard(energy);
    CHECK(levelAt(s, hum_Hz(energy)) > 0.4 * kHumLevel);
    CHECK(levelAt(s, 1.06 * hum_Hz(energy)) < 0.05 * kHumLevel);
    CHECK(peak(s) <= kHumLevel);
  }
  for (const double energy : {0.0, 5.0, 1e9, double(std::nan("")), double(INFINITY), -double(INFINITY)})
    CHECK(peak(heard(energy)) == 0.0f);
  TouchSynth synth;
  synth.take({.energy_kcal_mol = -3.0});
  sounding(synth, 0.2);
  CHECK_FALSE(synth.silent());
  synth.take({});
  sounding(synth, 1.0);
  CHECK(synth.silent());
}

TEST_CASE(
    "contact, a change from sphere to crease and the end have no click: the curve bends no more than its parts may") {
  TouchSynth synth;
  std::vector<float> all;
  const auto play = [&](const TouchMoment& m, double for_s) {
    synth.take(m);
    const auto part = sounding(synth, for_s);
    all.insert(all.end(), part.begin(), part.end());
  };
  play({}, 0.05);
  play(on(Feature::Sphere, 0.2, {1, -1, -1}), 0.3);
  play(on(Feature::Circle, 0.2, {1, 2, -1}), 0.3);
  play({}, 0.3);
  const double tone = pitch_Hz(0.2);
  // A note rises no faster than its limit in the attack time; a blip in 2 ms: that is the most that a slope can change
  // by.
  const double slopes =
      kNoteLevel / (0.008 * kTouchSynthRate) + (kKnockLevel + kClickLevel) / (0.002 * kTouchSynthRate);
  const double bound = bend(kNoteLevel, tone) + bend(kNoteLevel, 1.5 * tone) + bend(kKnockLevel, kKnock_Hz) +
                       bend(kClickLevel, kClick_Hz) + slopes;
  CHECK(bound < 0.03);
  CHECK(sharpest(all) < bound);
}

TEST_CASE("a second at random with 1000 changes stays below 0.99 and jumps by less than 0.35 a sample; 5 seeds") {
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u}) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    TouchSynth synth;
    std::vector<float> all;
    for (int tick = 0; tick < 1000; ++tick) {
      const auto feature = Feature(random() % 4);
      const double force = std::array{0.0, 3.3, 1e9, -1.0, std::nan(""), double(INFINITY)}[random() % 6];
      const double slide = std::array{0.0, 8.0, 1e9, -1.0, std::nan(""), double(INFINITY)}[random() % 6];
      synth.take({.feature = feature,
                  .atoms = {std::int32_t(random() % 5), std::int32_t(random() % 5), -1},
                  .force_N = force,
                  .slide_A_per_s = slide,
                  .contacts = random() % 9,
                  .energy_kcal_mol = std::array{0.0, -40.0, -1e9, 3.0, std::nan(""), double(INFINITY)}[random() % 6]});
      const auto part = sounding(synth, 0.001);
      all.insert(all.end(), part.begin(), part.end());
    }
    CHECK(std::all_of(all.begin(), all.end(), [](float x) { return std::isfinite(x); }));
    CHECK(peak(all) < 0.99);
    // Six notes of 0.0635 at up to 4714 Hz, the knock, the click, the thud and the scrape: 0.30 in all.
    double jump = 0;
    for (std::size_t k = 1; k < all.size(); ++k) jump = std::max(jump, std::abs(double(all[k]) - double(all[k - 1])));
    CHECK(jump < 0.35);
  }
}

TEST_CASE("blocks of 1, 37 and 480 samples give the same samples as one block of 4800") {
  const auto run = [](std::size_t block) {
    TouchSynth synth;
    std::vector<float> out(4800);
    TouchMoment slides = on(Feature::Point, 1.1, {1, 2, 3});
    slides.slide_A_per_s = 12.0;
    synth.take(slides);
    for (std::size_t at = 0; at < out.size(); at += block)
      synth.render(std::span(out).subspan(at, std::min(block, out.size() - at)));
    return out;
  };
  const auto whole = run(4800);
  for (const std::size_t block : {std::size_t(1), std::size_t(37), std::size_t(480)}) CHECK(run(block) == whole);
}

TEST_CASE(
    "a WAV file holds its 44 bytes of header and 16-bit samples: 0, 1, -1 and 2 become 0, 32767, -32767 and 32767") {
  const auto file = std::filesystem::temp_directory_path() / "moltact_wav_test.wav";
  const std::vector<float> samples{0.0f, 1.0f, -1.0f, 2.0f};
  REQUIRE_FALSE(writeWav(file, samples, 48000));
  std::ifstream in(file, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  const std::string bytes = text.str();
  std::filesystem::remove(file);
  REQUIRE(bytes.size() == 52);
  CHECK(bytes.substr(0, 4) == "RIFF");
  CHECK(bytes.substr(8, 8) == "WAVEfmt ");
  std::uint32_t rate = 0, data = 0;
  std::memcpy(&rate, bytes.data() + 24, 4);
  std::memcpy(&data, bytes.data() + 40, 4);
  CHECK(rate == 48000);
  CHECK(data == 8);
  std::array<std::int16_t, 4> values{};
  std::memcpy(values.data(), bytes.data() + 44, 8);
  CHECK(values == std::array<std::int16_t, 4>{0, 32767, -32767, 32767});
  CHECK(writeWav("/nonexistent/folder/x.wav", samples, 48000).value().text().find("its folder is not there") !=
        std::string::npos);
}
