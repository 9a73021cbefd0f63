#include <windows.h>

#include <system_error>

#include "engine/platform/removed_at_signal.h"

namespace moltact {
namespace {

std::filesystem::path removed_at_signal;

// On a thread of the system, which ends the program afterwards.
BOOL WINAPI removeFolder(DWORD) {
  std::error_code ignored;
  std::filesystem::remove_all(removed_at_signal, ignored);
  return FALSE;
}

}  // namespace

struct RemovedAtSignal::Impl {};

RemovedAtSignal::RemovedAtSignal(const std::filesystem::path& folder) {
  removed_at_signal = folder;
  SetConsoleCtrlHandler(removeFolder, TRUE);
}

RemovedAtSignal::~RemovedAtSignal() { SetConsoleCtrlHandler(removeFolder, FALSE); }

}  // namespace moltact
