#include "engine/platform/interrupt.h"

namespace moltact {

struct InterruptWatch::Before {};
InterruptWatch::InterruptWatch() = default;
InterruptWatch::~InterruptWatch() = default;
bool InterruptWatch::seen() const noexcept { return false; }

}  // namespace moltact
