// Default answers for a test's tracker or interaction without a probe, without state and without memory.
#pragma once

#include "engine/haptics/tracker.h"

namespace moltact::test {

template <class Base>
class WithoutMemory : public Base {
 public:
  void reset() noexcept override {}
  void setProbe(double) noexcept override {}
  double probe_A() const noexcept override { return kWaterProbe_A; }
  MemoryUsage memoryUsage() const noexcept override { return {}; }
};

}  // namespace moltact::test
