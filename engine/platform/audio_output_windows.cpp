// Not implemented: OpenAL's library would have to be built for Windows (docs/windows.md).
#include "engine/language/catalogue.h"
#include "engine/platform/audio_output.h"

namespace moltact {

struct AudioOutput::Impl {};

AudioOutput::AudioOutput(int, Fill) {}
AudioOutput::~AudioOutput() = default;
AudioOutput::State AudioOutput::state() const { return State::Silent; }
std::string AudioOutput::fault() const { return tr("There is no sound on Windows yet."); }

}  // namespace moltact
