// A simulation on a thread of its own. Neither thread waits for the other: each passes the newest value by a
// TripleBuffer. A push is a spring whose end stands where the hand stands (AtomPush), and a request is a counter, so a
// skipped command loses nothing. Functions: the window's thread.
#pragma once

#include <atomic>
#include <thread>

#include "engine/core/triple_buffer.h"
#include "engine/dynamics/simulation_slices.h"

namespace moltact {

class SimulationThread final : public LiveSimulation {
 public:
  /// Throws std::system_error if the system refuses another thread.
  explicit SimulationThread(std::unique_ptr<MdEngine> engine);
  /// Waits for the present slice: SimulationSlices::kMaxStep_s, or SimulationRun::kRelaxSlice iterations of a relaxation.
  ~SimulationThread() override;

  const SimulationFrame& newest() override { return frames_.read(); }
  void command(const SimulationCommand& wanted) override;

  EngineFacts engine() const override { return facts_; }

  /// The shortest time between two frames (unit: second).
  static constexpr double kSlice_s = 0.005;

 private:
  void run();

  SimulationSlices slices_;
  const EngineFacts facts_;
  TripleBuffer<SimulationCommand> commands_;
  TripleBuffer<SimulationFrame> frames_;
  std::atomic<bool> ends_{false};
  std::thread thread_;  // last: it uses the others
};

}  // namespace moltact
