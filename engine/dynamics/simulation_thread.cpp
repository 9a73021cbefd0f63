#include "engine/dynamics/simulation_thread.h"

#include <algorithm>
#include <chrono>

#include "engine/platform/force_inhibit.h"

namespace moltact {

SimulationThread::SimulationThread(std::unique_ptr<MdEngine> engine) : run_(std::move(engine)) {
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
  const auto seconds = [](Clock::duration d) { return std::chrono::duration<double>(d).count(); };
  auto last = Clock::now();
  double rate = 1000.0;  // steps per second, measured below
  while (!ends_.load(std::memory_order_relaxed)) {
    const auto now = Clock::now();
    const double elapsed_s = std::min(seconds(now - last), 0.1);
    last = now;
    const SimulationFrame& frame =
        run_.advance(commands_.read(), elapsed_s, std::max(1, int(rate * std::max(kMaxStep_s, elapsed_s))));
    const double took_s = seconds(Clock::now() - now);
    const double steps = frame.ps_per_s * elapsed_s / run_.engine().step_ps();
    if (steps >= 5.0 && took_s > 1e-5) rate += 0.2 * (steps / took_s - rate);
    frames_.back() = frame;
    frames_.publish();
    std::this_thread::sleep_until(now +
                                  std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(kSlice_s)));
  }
}

}  // namespace moltact
