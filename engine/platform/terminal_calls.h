// The system's calls for what a terminal or a pipe takes and gives: terminal.cpp makes of them what terminal.h promises.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "engine/platform/terminal.h"

namespace moltact::platform {

enum class Output { Standard, Error };

/// Before the first bytes: where the output is a terminal, what it is sent is UTF-8.
void prepare(Output to);
/// How many of the bytes were taken; 0: none will be.
std::size_t writeSome(Output to, std::string_view bytes);
bool isTerminal(Output to);

/// Waits for standard input, at most so long. Line: some bytes came and stand behind `typed`, a whole line or not.
Typed readSome(std::string& typed, int wait_ms);

}  // namespace moltact::platform
