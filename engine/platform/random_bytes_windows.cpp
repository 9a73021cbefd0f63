#include <windows.h>
// clang-format off: needs the header above
#include <bcrypt.h>
// clang-format on

#include <algorithm>
#include <array>
#include <cstdlib>

#include "engine/platform/random_bytes.h"

namespace moltact {

std::string randomBytes(std::size_t count) {
  std::string out;
  while (out.size() < count) {
    std::array<UCHAR, 256> some{};
    // Windows documents no failure of the system's generator; a secret must never be guessable.
    if (BCryptGenRandom(nullptr, some.data(), ULONG(some.size()), BCRYPT_USE_SYSTEM_PREFERRED_RNG) != 0) std::abort();
    out.append(some.begin(), some.begin() + std::ptrdiff_t(std::min(some.size(), count - out.size())));
  }
  return out;
}

}  // namespace moltact
