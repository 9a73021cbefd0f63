#include <windows.h>

#include "engine/platform/terminal_calls.h"

void moltact::hideOwnTerminal() {
  DWORD processes[2];
  if (GetConsoleProcessList(processes, 2) == 1) ShowWindow(GetConsoleWindow(), SW_HIDE);
}

namespace moltact::platform {
namespace {

HANDLE handleOf(Output to) { return GetStdHandle(to == Output::Standard ? STD_OUTPUT_HANDLE : STD_ERROR_HANDLE); }

}  // namespace

void prepare(Output to) {
  if (isTerminal(to)) SetConsoleOutputCP(CP_UTF8);
}

std::size_t writeSome(Output to, std::string_view bytes) {
  DWORD written = 0;
  return WriteFile(handleOf(to), bytes.data(), DWORD(bytes.size()), &written, nullptr) ? written : 0;
}

bool isTerminal(Output to) {
  DWORD mode = 0;
  return GetConsoleMode(handleOf(to), &mode) != 0;
}

Typed readSome(std::string& typed, int wait_ms) {
  HANDLE const input = GetStdHandle(STD_INPUT_HANDLE);
  if (WaitForSingleObject(input, DWORD(wait_ms)) != WAIT_OBJECT_0) return Typed::Nothing;
  char some[256];
  DWORD size = 0;
  if (!ReadFile(input, some, sizeof some, &size, nullptr) || size == 0) return Typed::End;
  for (const char c : std::string_view(some, size))
    if (c != '\r') typed += c;
  return Typed::Line;
}

}  // namespace moltact::platform
