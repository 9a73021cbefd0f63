#include "engine/platform/removed_at_signal.h"

namespace moltact {

struct RemovedAtSignal::Impl {};
RemovedAtSignal::RemovedAtSignal(const std::filesystem::path&) {}
RemovedAtSignal::~RemovedAtSignal() = default;

}  // namespace moltact
