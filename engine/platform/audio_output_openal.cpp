#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/language/catalogue.h"
#include "engine/platform/audio_output.h"

#define AL_NO_PROTOTYPES
#define ALC_NO_PROTOTYPES
#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>

namespace moltact {
namespace {

// Four blocks of 10 ms: a latency of at most 40 ms; a thread that sleeps 30 ms too long is inaudible.
constexpr int kBlocks = 4, kBlocks_per_s = 100;
constexpr std::chrono::milliseconds kNap{4};

struct OpenAl {
  LPALCOPENDEVICE openDevice = nullptr;
  LPALCCLOSEDEVICE closeDevice = nullptr;
  LPALCCREATECONTEXT createContext = nullptr;
  LPALCDESTROYCONTEXT destroyContext = nullptr;
  LPALCMAKECONTEXTCURRENT makeContextCurrent = nullptr;
  LPALCGETINTEGERV getDeviceInteger = nullptr;
  LPALCISEXTENSIONPRESENT isExtensionPresent = nullptr;
  LPALGENSOURCES genSources = nullptr;
  LPALGENBUFFERS genBuffers = nullptr;
  LPALDELETESOURCES deleteSources = nullptr;
  LPALDELETEBUFFERS deleteBuffers = nullptr;
  LPALBUFFERDATA bufferData = nullptr;
  LPALSOURCEQUEUEBUFFERS queueBuffers = nullptr;
  LPALSOURCEUNQUEUEBUFFERS unqueueBuffers = nullptr;
  LPALGETSOURCEI getSource = nullptr;
  LPALSOURCEPLAY play = nullptr;
  LPALSOURCESTOP stop = nullptr;
  LPALGETERROR error = nullptr;

  // Stays loaded to the end of the process, because its threads do not tolerate unloading.
  bool load() {
    void* library = dlopen("libopenal.so.1", RTLD_NOW | RTLD_LOCAL);
    if (!library) return false;
    const auto get = [&](const char* name, auto& to) {
      to = reinterpret_cast<std::remove_reference_t<decltype(to)>>(dlsym(library, name));
      return to != nullptr;
    };
    return get("alcOpenDevice", openDevice) && get("alcCloseDevice", closeDevice) &&
           get("alcCreateContext", createContext) && get("alcDestroyContext", destroyContext) &&
           get("alcMakeContextCurrent", makeContextCurrent) && get("alcGetIntegerv", getDeviceInteger) &&
           get("alcIsExtensionPresent", isExtensionPresent) && get("alGenSources", genSources) &&
           get("alGenBuffers", genBuffers) && get("alDeleteSources", deleteSources) &&
           get("alDeleteBuffers", deleteBuffers) && get("alBufferData", bufferData) &&
           get("alSourceQueueBuffers", queueBuffers) && get("alSourceUnqueueBuffers", unqueueBuffers) &&
           get("alGetSourcei", getSource) && get("alSourcePlay", play) && get("alSourceStop", stop) &&
           get("alGetError", error);
  }
};

void noMessage(const char*, int, const char*, int, const char*, ...) {}

// ALSA and OpenAL report a missing card in a dozen lines on stderr; the user gets one sentence from this program.
void hushLibraries() {
  setenv("ALSOFT_LOGLEVEL", "0", 0);
  void* alsa = dlopen("libasound.so.2", RTLD_NOW | RTLD_LOCAL);
  if (!alsa) return;
  using Handler = void (*)(const char*, int, const char*, int, const char*, ...);
  if (const auto set = reinterpret_cast<int (*)(Handler)>(dlsym(alsa, "snd_lib_error_set_handler"))) set(&noMessage);
}

}  // namespace

struct AudioOutput::Impl {
  int samples_per_s;
  Fill fill;
  std::atomic<State> state{State::Opening};
  std::string fault;  // written before `state` becomes Silent, then immutable
  std::mutex mutex;
  std::condition_variable wake;
  bool end = false;
  std::thread thread;

  void fail(const char* why) {
    fault = why;
    state = State::Silent;
  }

  bool napOrEnd() {
    std::unique_lock lock(mutex);
    return wake.wait_for(lock, kNap, [this] { return end; });
  }

  void run() {
    OpenAl al;
    if (!al.load())
      return fail(tr("There is no sound: OpenAL is not installed on this computer (package libopenal1)."));
    ALCdevice* device = al.openDevice(nullptr);
    if (!device) return fail(tr("There is no sound: this computer has no sound card that can be opened now."));
    ALCcontext* context = al.createContext(device, nullptr);
    if (context && al.makeContextCurrent(context))
      stream(al, device);
    else
      fail(tr("There is no sound: the sound card refuses to play."));
    al.makeContextCurrent(nullptr);
    if (context) al.destroyContext(context);
    al.closeDevice(device);
  }

  void stream(const OpenAl& al, ALCdevice* device) {
    ALuint source = 0;
    std::array<ALuint, kBlocks> buffers{};
    al.genSources(1, &source);
    al.genBuffers(kBlocks, buffers.data());
    std::vector<float> samples(std::size_t(samples_per_s / kBlocks_per_s));
    std::vector<std::int16_t> words(samples.size());
    const auto queue = [&](ALuint buffer) {
      fill(samples);
      std::transform(samples.begin(), samples.end(), words.begin(),
                     [](float s) { return std::int16_t(std::lround(32767.0f * std::clamp(s, -1.0f, 1.0f))); });
      al.bufferData(buffer, AL_FORMAT_MONO16, words.data(), ALsizei(words.size() * sizeof(std::int16_t)),
                    samples_per_s);
      al.queueBuffers(source, 1, &buffer);
    };
    for (const ALuint b : buffers) queue(b);
    al.play(source);
    if (al.error() != AL_NO_ERROR)
      fail(tr("There is no sound: the sound card refuses to play."));
    else
      state = State::Playing;
    const bool tells_loss = al.isExtensionPresent(device, "ALC_EXT_disconnect");
    while (state == State::Playing && !napOrEnd()) {
      ALCint connected = 1;
      if (tells_loss) al.getDeviceInteger(device, ALC_CONNECTED, 1, &connected);
      if (!connected) fail(tr("The sound has ended: the sound card is gone."));
      ALint done = 0, playing = 0;
      al.getSource(source, AL_BUFFERS_PROCESSED, &done);
      for (; done > 0; --done) {
        ALuint buffer = 0;
        al.unqueueBuffers(source, 1, &buffer);
        queue(buffer);
      }
      // The queue is empty if the computer was too busy.
      al.getSource(source, AL_SOURCE_STATE, &playing);
      if (playing != AL_PLAYING) al.play(source);
    }
    al.stop(source);
    al.deleteSources(1, &source);
    al.deleteBuffers(kBlocks, buffers.data());
  }
};

AudioOutput::AudioOutput(int samples_per_s, Fill fill) : impl_(std::make_unique<Impl>()) {
  hushLibraries();
  impl_->samples_per_s = samples_per_s;
  impl_->fill = std::move(fill);
  impl_->thread = std::thread([p = impl_.get()] { p->run(); });
}

AudioOutput::~AudioOutput() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->end = true;
  }
  impl_->wake.notify_one();
  impl_->thread.join();
}

AudioOutput::State AudioOutput::state() const { return impl_->state; }

std::string AudioOutput::fault() const { return state() == State::Silent ? impl_->fault : std::string(); }

}  // namespace moltact
