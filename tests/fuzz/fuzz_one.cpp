// libFuzzer's program for one target, the function MOLTACT_FUZZ_TARGET.
#include <cstdint>

#include "tests/fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  moltact::fuzz::MOLTACT_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}
