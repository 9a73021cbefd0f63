#include <sys/random.h>

#include <cerrno>
#include <cstdlib>

#include "engine/platform/random_bytes.h"

namespace moltact {

std::string randomBytes(std::size_t count) {
  std::string out(count, '\0');
  for (std::size_t done = 0; done < count;) {
    const ssize_t got = ::getrandom(out.data() + done, count - done, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) std::abort();  // Linux has had the call since 3.17; a secret must never be guessable
    done += std::size_t(got);
  }
  return out;
}

}  // namespace moltact
