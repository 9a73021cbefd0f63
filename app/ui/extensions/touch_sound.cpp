#include "app/ui/extensions/touch_sound.h"

#include <atomic>
#include <utility>

#include "app/ui/application/application_options.h"
#include "app/ui/application/panel_state.h"
#include "app/ui/extensions/playback.h"
#include "app/ui/extensions/reveal_policy.h"
#include "app/ui/files/settings.h"
#include "engine/core/sample_ring.h"
#include "engine/language/catalogue.h"
#include "engine/platform/audio_output.h"

namespace moltact {
namespace {

// A contact without news for longer than this is ended: the window is blocked.
constexpr int kStale_samples = kSamples_per_s / 2;
constexpr double kFelt_s = 0.6;  // the user is asked after this time of the first touch

}  // namespace

// The window's thread writes the moments; the audio thread owns the synthesizer.
struct TouchSound::Playing {
  SampleRing<TouchMoment, 4096> moments;
  TouchSynth synth;
  std::atomic<float> volume{0.0f};
  float played = 0.0f;  // ramps to the volume
  int stale = 0;
  AudioOutput output{kSamples_per_s, [this](std::span<float> out) {
                       stale += int(out.size());
                       for (TouchMoment moment; moments.pop(moment); stale = 0) synth.take(moment);
                       if (stale > kStale_samples) synth.take({});
                       synth.render(out);
                       const float step = (volume.load(std::memory_order_relaxed) - played) / float(out.size());
                       for (float& sample : out) sample *= played += step;
                     }};
};

TouchSound::TouchSound(const RevealPolicy& policy, const Playback& playback, const HapticSession& scene,
                       Settings& settings, Messages& messages, const PanelState& panels,
                       const ApplicationOptions& options, const FrameTime& time)
    : policy_(policy),
      playback_(playback),
      scene_(scene),
      settings_(settings),
      messages_(messages),
      panels_(panels),
      options_(options),
      time_(time) {}
TouchSound::~TouchSound() = default;

void TouchSound::take(const TouchMoment& moment) {
  if (playing_)
    playing_->moments.push(moment);
  else
    synth_.take(moment);
}

void TouchSound::ticks(const FeltTicks& felt) {
  for (const FeltTick& tick : felt.ticks) {
    const ServoSample& s = tick.sample;
    if (s.felt()) felt_s_ += kTick_s;
    if (!on_) continue;
    const bool slides = last_A_ && s.contact.touching() && !s.contact_reset;
    const double slide_A_per_s = slides ? glm::distance(*last_A_, s.contact.scp.A) / kTick_s : 0.0;
    last_A_ = s.contact.touching() ? std::optional(s.contact.scp.A) : std::nullopt;
    take(policy_.heard(s, slide_A_per_s));
    hear(kTick_s);
  }
}

// On the frames' clock, stores the samples of this time.
void TouchSound::hear(double for_s) {
  if (playing_) return;
  owed_samples_ += for_s * kSamples_per_s;
  const auto count = std::size_t(owed_samples_);
  owed_samples_ -= double(count);
  heard_.resize(heard_.size() + count);
  const std::span<float> fresh = std::span(heard_).last(count);
  synth_.render(fresh);
  for (float& sample : fresh) sample *= float(settings_.sound_volume);
}

// An attempt has a sample in 1/60 s at most. The contact point's speed is its way between two samples by their time.
void TouchSound::hearPlayback() {
  constexpr double kStands_s = 0.1;  // without another contact point for this time, it does not slide
  const bool plays = scene_.playedHand().on() && playback_.running();
  if (!plays && std::exchange(hears_playback_, false)) {
    last_A_.reset();
    if (on_) take({});
  }
  if (!on_ || !scene_.playedHand().on()) return;
  if (plays) {
    const ServoSample& s = scene_.log().latest();
    const bool touches = s.contact.touching(), began = !std::exchange(hears_playback_, true) || !last_A_;
    const double since_s = s.time_s - last_s_;
    if (!touches || began || since_s < 0.0 || since_s > kStands_s) slide_A_per_s_ = 0.0;
    if (touches && (began || *last_A_ != s.contact.scp.A || since_s < 0.0)) {
      if (!began && since_s > 0.0) slide_A_per_s_ = glm::distance(*last_A_, s.contact.scp.A) / since_s;
      last_A_ = s.contact.scp.A;
      last_s_ = s.time_s;
    }
    if (!touches) last_A_.reset();
    take(policy_.heard(s, slide_A_per_s_));
  }
  hear(std::min(time_.dt_s, 0.5));
}

// Without stored settings, the question would be asked at every start.
void TouchSound::ask() {
  Settings& s = settings_;
  if (s.sound) s.sound_asked = true;
  if (question_ != 0 && (s.sound_asked || !messages_.shows(question_))) {
    messages_.takeBack(question_);
    s.sound_asked = true;
  }
  if (s.sound_asked || question_ != 0 || felt_s_ < kFelt_s || options_.settings_file.empty() || panels_.pages.welcome ||
      scene_.servo().device().gives_force)
    return;
  question_ = messages_.ask(
      MessageKind::Notice,
      tr("Do you want to hear what you touch? The harder you push, the higher the tone; sliding scrapes, a crease "
         "clicks, a pit thuds. It is quiet."),
      {"sound-yes", "sound-no"});
}

void TouchSound::answer(bool on) {
  settings_.sound = on;
  settings_.sound_asked = true;
  messages_.takeBack(question_);
}

void TouchSound::sceneChanged() {
  last_A_.reset();
  if (on_) take({});
}

void TouchSound::afterPanels() {
  hearPlayback();
  ask();
  switchOnOff();
  if (playing_) playing_->volume.store(float(settings_.sound_volume), std::memory_order_relaxed);
}

void TouchSound::switchOnOff() {
  if (settings_.sound && !on_) {
    on_ = true;
    reported_ = false;
    heard_.clear();
    synth_ = {};
    last_A_.reset();
    // A sound card may have been connected since.
    const bool play = options_.clock != ServoClock::Frames;
    if (play && (!playing_ || playing_->output.state() == AudioOutput::State::Silent))
      playing_ = std::make_unique<Playing>();
  } else if (!settings_.sound && on_) {
    take({});
    on_ = false;
  }
  if (!on_ || reported_ || !playing_ || playing_->output.state() != AudioOutput::State::Silent) return;
  reported_ = true;
  messages_.warning(playing_->output.fault());
}

}  // namespace moltact
