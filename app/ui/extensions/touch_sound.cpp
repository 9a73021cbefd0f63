#include "app/ui/extensions/touch_sound.h"

#include <atomic>

#include "app/ui/application/application.h"
#include "engine/core/sample_ring.h"
#include "engine/language/catalogue.h"
#include "engine/platform/audio_output.h"

namespace moltact {
namespace {

// What is held for longer than this without news is let go: the window is busy with something else.
constexpr int kStale_samples = kSamples_per_s / 2;
constexpr double kFelt_s = 0.6;  // after so much of a first touch the person is asked

}  // namespace

// The window's thread writes the moments; the loudspeaker's thread owns the synthesis.
struct TouchSound::Playing {
  SampleRing<TouchMoment, 4096> moments;
  TouchSynth synth;
  std::atomic<float> volume{0.0f};
  float played = 0.0f;  // goes evenly to the volume
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

TouchSound::TouchSound() = default;
TouchSound::~TouchSound() = default;

void TouchSound::take(const TouchMoment& moment) {
  if (playing_)
    playing_->moments.push(moment);
  else
    synth_.take(moment);
}

void TouchSound::ticks(Application& app, const FeltTicks& felt) {
  for (const FeltTick& tick : felt.ticks) {
    const ServoSample& s = tick.sample;
    if (s.contact.touching()) felt_s_ += kTick_s;
    if (!on_) continue;
    const bool slides = last_A_ && s.contact.touching() && !s.placed;
    const double slide_A_per_s = slides ? glm::distance(*last_A_, s.contact.scp.A) / kTick_s : 0.0;
    last_A_ = s.contact.touching() ? std::optional(s.contact.scp.A) : std::nullopt;
    take({s.contact.feature, s.contact.atoms, glm::length(s.force.N), slide_A_per_s});
    if (playing_) continue;
    constexpr std::size_t kATick = kSamples_per_s / 1000;
    heard_.resize(heard_.size() + kATick);
    const std::span<float> fresh = std::span(heard_).last(kATick);
    synth_.render(fresh);
    for (float& sample : fresh) sample *= float(app.settings.sound_volume);
  }
}

// Where no settings are kept nobody could be asked only once.
void TouchSound::ask(Application& app) {
  Settings& s = app.settings;
  if (s.sound) s.sound_asked = true;
  if (question_ != 0 && (s.sound_asked || !app.messages.tells(question_))) {
    app.messages.takeBack(question_);
    s.sound_asked = true;
  }
  if (s.sound_asked || question_ != 0 || felt_s_ < kFelt_s || app.options().settings_file.empty() ||
      app.panels.welcome || app.scene.servo().device().gives_force)
    return;
  question_ = app.messages.ask(
      MessageKind::Notice,
      tr("Do you want to hear what you touch? The harder you push, the higher the tone; sliding scrapes, a crease "
         "clicks, a pit thuds. It is quiet."),
      {"sound-yes", "sound-no"});
}

void TouchSound::answer(Application& app, bool on) {
  app.settings.sound = on;
  app.settings.sound_asked = true;
  app.messages.takeBack(question_);
}

void TouchSound::sceneChanged(Application&) {
  last_A_.reset();
  if (on_) take({});
}

void TouchSound::afterPanels(Application& app) {
  ask(app);
  switchOnOff(app);
  if (playing_) playing_->volume.store(float(app.settings.sound_volume), std::memory_order_relaxed);
}

void TouchSound::switchOnOff(Application& app) {
  if (app.settings.sound && !on_) {
    on_ = true;
    told_ = false;
    heard_.clear();
    synth_ = {};
    last_A_.reset();
    // A card that was not there may have been plugged in since.
    const bool play = app.options().clock != ServoClock::Frames;
    if (play && (!playing_ || playing_->output.state() == AudioOutput::State::Silent))
      playing_ = std::make_unique<Playing>();
  } else if (!app.settings.sound && on_) {
    take({});
    on_ = false;
  }
  if (!on_ || told_ || !playing_ || playing_->output.state() != AudioOutput::State::Silent) return;
  told_ = true;
  app.messages.warning(playing_->output.fault());
}

}  // namespace moltact
