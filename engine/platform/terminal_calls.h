// System calls for terminals and pipes, on which terminal.cpp is built.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "engine/platform/terminal.h"

namespace moltact::platform {

enum class Output { Standard, Error };

/// Prepares an output for its first bytes: a terminal is set to UTF-8.
void prepare(Output to);
/// Writes some of the bytes and returns their number; 0: no more can be written.
std::size_t writeSome(Output to, std::string_view bytes);
bool isTerminal(Output to);

/// Waits up to `wait_ms` for standard input. Returns Line if bytes arrived, which are appended to `typed`; they need
/// not form a whole line.
Typed readSome(std::string& typed, int wait_ms);

}  // namespace moltact::platform
