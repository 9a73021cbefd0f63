#include "app/ui/extensions/touch_sound.h"

#include "app/ui/application/application.h"
#include "engine/core/sample_ring.h"
#include "engine/platform/audio_output.h"

namespace moltact {
namespace {

// What is held for longer than this without news is let go: the window is busy with something else.
constexpr int kStale_samples = kSamples_per_s / 2;

}  // namespace

// The window's thread writes the moments; the loudspeaker's thread owns the synthesis.
struct TouchSound::Playing {
  SampleRing<TouchMoment, 4096> moments;
  TouchSynth synth;
  int stale = 0;
  AudioOutput output{kSamples_per_s, [this](std::span<float> out) {
                       stale += int(out.size());
                       for (TouchMoment moment; moments.pop(moment); stale = 0) synth.take(moment);
                       if (stale > kStale_samples) synth.take({});
                       synth.render(out);
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

void TouchSound::ticks(Application&, const FeltTicks& felt) {
  if (!on_) return;
  for (const FeltTick& tick : felt.ticks) {
    const ServoSample& s = tick.sample;
    take({s.contact.feature, s.contact.atoms, glm::length(s.force.N)});
    if (playing_) continue;
    constexpr std::size_t kATick = kSamples_per_s / 1000;
    heard_.resize(heard_.size() + kATick);
    synth_.render(std::span(heard_).last(kATick));
  }
}

void TouchSound::sceneChanged(Application&) {
  if (on_) take({});
}

void TouchSound::afterPanels(Application& app) {
  if (app.settings.sound && !on_) {
    on_ = true;
    told_ = false;
    heard_.clear();
    synth_ = {};
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
