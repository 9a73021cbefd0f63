// Removes a folder where a signal ends the program. Command's thread.
#pragma once

#include <filesystem>
#include <memory>

namespace moltact {

/// While one exists, a signal that ends the program (SIGINT, SIGTERM, SIGHUP) first removes the folder. The program then
/// ends by that signal. One at a time, made before other threads. For commands that hold no device.
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
