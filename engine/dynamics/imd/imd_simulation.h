// A simulation in another program, on this computer or another, over IMD (imd_session.h). A thread of its own reads
// everything that the server sends, so that the server never waits. It keeps the newest positions and sends the forces. Neither thread
// waits for the other: each passes the newest value by a TripleBuffer. Functions: the window's thread, unless stated.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

#include "engine/core/triple_buffer.h"
#include "engine/dynamics/imd/imd_session.h"
#include "engine/platform/tcp.h"

namespace moltact {

class ImdSimulation final : public LiveSimulation {
 public:
  /// Larger molecules are refused: their atoms could not follow the hand.
  static constexpr std::size_t kMaxAtoms = 20'000;

  /// Connects and waits for the first positions: up to kConnect_ms and ImdSession::kFirst_s, or until `cancelled`. Any
  /// thread but the haptic one. A Problem names the address.
  static Expected<std::unique_ptr<LiveSimulation>> connect(const TcpAddress& address, std::vector<Vec3> start_A,
                                                           std::shared_ptr<const std::atomic<bool>> cancelled);
  static constexpr int kConnect_ms = 2000;

  /// The same for a connection that exists.
  static Expected<std::unique_ptr<LiveSimulation>> over(std::unique_ptr<TcpConnection> connection,
                                                        std::vector<Vec3> start_A,
                                                        std::shared_ptr<const std::atomic<bool>> cancelled);

  /// Ends all forces and the session; waits up to kFarewell_ms for the server to close the connection.
  ~ImdSimulation() override;
  static constexpr int kFarewell_ms = 300;

  const SimulationFrame& newest() override { return frames_.read(); }
  void command(const SimulationCommand& wanted) override;
  bool obeysAll() const override { return false; }

 private:
  ImdSimulation(std::unique_ptr<TcpConnection> connection, std::vector<Vec3> start_A);
  double now_s() const;
  void step();
  void run();
  void farewell();

  std::unique_ptr<TcpConnection> connection_;
  const std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  ImdSession session_;
  std::vector<std::uint8_t> buffer_;
  std::uint64_t published_ = 0, obeyed_ = 0;
  bool remembers_last_words_ = false;
  TripleBuffer<SimulationCommand> commands_;
  std::atomic<std::uint64_t> commanded_{0};
  TripleBuffer<SimulationFrame> frames_;
  std::atomic<bool> ends_{false};
  std::thread thread_;  // last: it uses the others
};

}  // namespace moltact
