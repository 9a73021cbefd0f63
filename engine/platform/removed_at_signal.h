// Removes a folder when a signal ends the program. Command's thread.
#pragma once

#include <filesystem>
#include <memory>

namespace moltact {

/// While it exists, a signal that ends the program (SIGINT, SIGTERM, SIGHUP) first removes the folder. The program then
/// ends by that signal. One instance at a time, created before other threads. For commands without a device.
class RemovedAtSignal {
 public:
  explicit RemovedAtSignal(const std::filesystem::path& folder);
  ~RemovedAtSignal();
  RemovedAtSignal(const RemovedAtSignal&) = delete;
  RemovedAtSignal& operator=(const RemovedAtSignal&) = delete;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace moltact
