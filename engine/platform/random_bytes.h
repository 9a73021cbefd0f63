// Secrets: random bytes from the operating system. Any thread but the haptic one; may block while the system starts.
#pragma once

#include <cstddef>
#include <string>

namespace moltact {

/// Returns `count` cryptographically secure random bytes.
std::string randomBytes(std::size_t count);

}  // namespace moltact
