#include "app/ui/extensions/touch_sound.h"

#include <atomic>

#include "app/ui/application/application_options.h"
#include "app/ui/application/panel_state.h"
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

TouchSound::TouchSound(const RevealPolicy& policy, const HapticSession& scene, Settings& settings, Messages& messages,
                       const PanelState& panels, const ApplicationOptions& options)
    : policy_(policy), scene_(scene), settings_(settings), messages_(messages), panels_(panels), options_(options) {}
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
    if (playing_) continue;
    constexpr std::size_t kATick = kSamples_per_s / 1000;
    heard_.resize(heard_.size() + kATick);
    const std::span<float> fresh = std::span(heard_).last(kATick);
    synth_.render(fresh);
    for (float& sample : fresh) sample *= float(settings_.sound_volume);
  }
}

// Without stored settings, the question would be asked at every start.
void TouchSound::ask() {
  Settings& s = settings_;
  if (s.sound) s.sound_asked = true;
  if (question_ != 0 && (s.sound_asked || !messages_.tells(question_))) {
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
