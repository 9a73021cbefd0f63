// waveOut, Windows' own: the system signals an event when it has played a block, and the output's thread fills the block
// again.
#include <windows.h>
// clang-format off: needs the header above
#include <mmsystem.h>
// clang-format on

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <thread>
#include <vector>

#include "engine/language/catalogue.h"
#include "engine/platform/audio_output.h"

namespace moltact {
namespace {

// Six blocks of 10 ms: a latency of at most 60 ms. Windows mixes in periods of 10 ms and needs two blocks at hand.
constexpr int kBlocks = 6, kBlocks_per_s = 100;
// A card that has played no block for this time has been removed; some drivers report nothing.
constexpr std::chrono::seconds kMaxPause{2};
constexpr DWORD kNap_ms = 100;

}  // namespace

struct AudioOutput::Impl {
  struct Block {
    std::vector<std::int16_t> words;
    WAVEHDR header{};
  };

  int samples_per_s;
  Fill fill;
  std::atomic<State> state{State::Opening};
  std::string fault;  // written before `state` becomes Silent, then immutable
  std::atomic<bool> end{false};
  HANDLE wake = CreateEventW(nullptr, FALSE, FALSE, nullptr);  // a block was played, or `end`
  std::thread thread;

  ~Impl() {
    if (wake) CloseHandle(wake);
  }

  void fail(const char* why) {
    fault = why;
    state = State::Silent;
  }

  void run() {
    WAVEFORMATEX format{};
    format.wFormatTag = WAVE_FORMAT_PCM;
    format.nChannels = 1;
    format.wBitsPerSample = 16;
    format.nSamplesPerSec = DWORD(samples_per_s);
    format.nBlockAlign = sizeof(std::int16_t);
    format.nAvgBytesPerSec = format.nSamplesPerSec * format.nBlockAlign;
    HWAVEOUT card = nullptr;
    if (!wake || waveOutOpen(&card, WAVE_MAPPER, &format, DWORD_PTR(wake), 0, CALLBACK_EVENT) != MMSYSERR_NOERROR)
      return fail(tr("There is no sound: this computer has no sound card that can be opened now."));
    std::array<Block, kBlocks> blocks;
    stream(card, blocks);
    waveOutReset(card);  // returns all blocks
    for (Block& block : blocks) waveOutUnprepareHeader(card, &block.header, sizeof block.header);
    waveOutClose(card);
  }

  bool queue(HWAVEOUT card, Block& block, std::vector<float>& samples) const {
    fill(samples);
    std::transform(samples.begin(), samples.end(), block.words.begin(),
                   [](float s) { return std::int16_t(std::lround(32767.0f * std::clamp(s, -1.0f, 1.0f))); });
    return waveOutWrite(card, &block.header, sizeof block.header) == MMSYSERR_NOERROR;
  }

  void stream(HWAVEOUT card, std::array<Block, kBlocks>& blocks) {
    std::vector<float> samples(std::size_t(samples_per_s / kBlocks_per_s));
    for (Block& block : blocks) {
      block.words.resize(samples.size());
      block.header.lpData = reinterpret_cast<char*>(block.words.data());
      block.header.dwBufferLength = DWORD(block.words.size() * sizeof(std::int16_t));
      if (waveOutPrepareHeader(card, &block.header, sizeof block.header) != MMSYSERR_NOERROR ||
          !queue(card, block, samples))
        return fail(tr("There is no sound: the sound card refuses to play."));
    }
    state = State::Playing;
    auto played = std::chrono::steady_clock::now();
    while (!end) {
      const auto now = std::chrono::steady_clock::now();
      for (Block& block : blocks) {
        if (!(block.header.dwFlags & WHDR_DONE)) continue;
        played = now;
        if (!queue(card, block, samples)) return fail(tr("The sound has ended: the sound card is gone."));
      }
      if (now - played > kMaxPause) return fail(tr("The sound has ended: the sound card is gone."));
      WaitForSingleObject(wake, kNap_ms);
    }
  }
};

AudioOutput::AudioOutput(int samples_per_s, Fill fill) : impl_(std::make_unique<Impl>()) {
  impl_->samples_per_s = samples_per_s;
  impl_->fill = std::move(fill);
  impl_->thread = std::thread([p = impl_.get()] { p->run(); });
}

AudioOutput::~AudioOutput() {
  impl_->end = true;
  if (impl_->wake) SetEvent(impl_->wake);
  impl_->thread.join();
}

AudioOutput::State AudioOutput::state() const { return impl_->state; }

std::string AudioOutput::fault() const { return state() == State::Silent ? impl_->fault : std::string(); }

}  // namespace moltact
