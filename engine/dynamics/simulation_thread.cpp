#include "engine/dynamics/simulation_thread.h"

#include <chrono>

#include "engine/platform/force_inhibit.h"

namespace moltact {

SimulationThread::SimulationThread(std::unique_ptr<MdEngine> engine)
    : slices_(std::move(engine)), facts_(factsOf(slices_.engine())) {
  thread_ = std::thread([this] { run(); });
}

SimulationThread::~SimulationThread() {
  ends_.store(true, std::memory_order_relaxed);
  thread_.join();
}

void SimulationThread::command(const SimulationCommand& wanted) {
  commands_.back() = wanted;
  commands_.publish();
}

void SimulationThread::run() {
  const CrashStack crash_stack;
  using Clock = std::chrono::steady_clock;
  auto last = Clock::now();
  while (!ends_.load(std::memory_order_relaxed)) {
    const auto now = Clock::now();
    const double elapsed_s = std::chrono::duration<double>(now - last).count();
    last = now;
    frames_.back() = slices_.advance(commands_.read(), elapsed_s);
    frames_.publish();
    if (slices_.relaxing()) continue;
    std::this_thread::sleep_until(now +
                                  std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(kSlice_s)));
  }
}

}  // namespace moltact
