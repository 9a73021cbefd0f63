// libFuzzer's program for one target (MOLTACT_FUZZ_TARGET).
#include <cstdint>
#include <cstring>

#include "tests/fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const moltact::fuzz::Target* const target = [] {
    for (const auto& t : moltact::fuzz::targets())
      if (std::strcmp(t.name, MOLTACT_FUZZ_TARGET) == 0) return &t;
    std::abort();
  }();
  target->run({reinterpret_cast<const char*>(data), size});
  return 0;
}
