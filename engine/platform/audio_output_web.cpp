// Web Audio: a node on the page's own thread requests samples. Browsers allow sound only after a click or a key press,
// such as that on the switch for sound.
#include <emscripten.h>

#include <vector>

#include "engine/language/catalogue.h"
#include "engine/platform/audio_output.h"

namespace moltact {

struct AudioOutput::Impl {
  Fill fill;
  std::vector<float> samples;
  bool open = false;
};

}  // namespace moltact

// The following functions are JavaScript.
// clang-format off
// Blocks of 1024 samples: a latency of about 40 ms, because the page also draws. Returns 0 if the browser has no Web
// Audio.
EM_JS(int, openSound, (void* output, int samples_per_s), {
  try {
    const context = new AudioContext({sampleRate: samples_per_s});
    const node = context.createScriptProcessor(1024, 0, 1);
    node.onaudioprocess = (event) => {
      const out = event.outputBuffer.getChannelData(0);
      const at = _moltact_samples(output, out.length) >> 2;
      out.set(HEAPF32.subarray(at, at + out.length));
    };
    node.connect(context.destination);
    const wake = () => { if (context.state === "suspended") context.resume(); };
    for (const event of ["pointerdown", "keydown"]) addEventListener(event, wake);
    (Module.sounds = Module.sounds || new Map()).set(output, {context, node, wake});
    wake();
    return 1;
  } catch (error) {
    return 0;
  }
})

EM_JS(void, closeSound, (void* output), {
  const sound = Module.sounds.get(output);
  Module.sounds.delete(output);
  sound.node.onaudioprocess = null;
  for (const event of ["pointerdown", "keydown"]) removeEventListener(event, sound.wake);
  sound.context.close();
})
// clang-format on

// Fills `count` samples and returns their address.
extern "C" EMSCRIPTEN_KEEPALIVE float* moltact_samples(moltact::AudioOutput::Impl* output, int count) {
  output->samples.resize(std::size_t(count));
  output->fill(output->samples);
  return output->samples.data();
}

namespace moltact {

AudioOutput::AudioOutput(int samples_per_s, Fill fill) : impl_(std::make_unique<Impl>()) {
  impl_->fill = std::move(fill);
  impl_->open = openSound(impl_.get(), samples_per_s) != 0;
}

AudioOutput::~AudioOutput() {
  if (impl_->open) closeSound(impl_.get());
}

AudioOutput::State AudioOutput::state() const { return impl_->open ? State::Playing : State::Silent; }

std::string AudioOutput::fault() const {
  return impl_->open ? std::string() : tr("There is no sound: this browser plays none (Web Audio).");
}

}  // namespace moltact
