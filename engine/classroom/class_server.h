// The network's end of a live class, by cpp-httplib: takes connections, limits what they may bring, and passes each request
// to ClassRequests. Its threads are those of the library: one accepts, others answer. Linux.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "engine/classroom/class_requests.h"
#include "engine/core/problem.h"

namespace moltact {

class ClassServer {
 public:
  ClassServer();
  ~ClassServer();

  /// Takes a port of the loopback, or with `share` of all network interfaces; 0: any free one. Returns the port.
  Expected<int> bind(bool share, int port);
  /// When the clock of all requests (ClassRequest::now_s) was 0.
  std::chrono::steady_clock::time_point clockBegan() const;
  /// Answers until `stop` returns true, which is asked ten times a second. If the system stops to accept connections, it
  /// binds again, for about 12 s. Returns false if it gave up.
  bool serve(ClassRequests& requests, const std::function<bool()>& stop);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace moltact
