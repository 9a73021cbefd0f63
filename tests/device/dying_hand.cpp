// Uses a device until it ends in the given way: dying_hand DEVICE WAY. It writes "pressing" when it applies a force.
// After a line on its standard input, it writes the monotonic time in ns and ends as WAY says; "wait" waits for an
// external signal. "close" and "leave" close the device, or end the force as the program's exit does, from full force.
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include "engine/device/driver.h"
#include "engine/device/mouse_device.h"
#include "engine/platform/force_inhibit.h"
#include "engine/platform/realtime.h"
#include "engine/servo/plain_trackers.h"
#include "engine/servo/servo_thread.h"
#include "tests/servo/newest_tick.h"

using namespace moltact;

// In a build with sanitizers the process is to end as others do.
extern "C" const char* __asan_default_options() {
  return "handle_segv=0:handle_sigbus=0:handle_sigfpe=0:handle_sigill=0:handle_abort=0:detect_leaks=0";
}
extern "C" const char* __tsan_default_options() {
  return "handle_segv=0:handle_sigbus=0:handle_sigfpe=0:handle_sigill=0:handle_abort=0";
}

namespace {

// What no process may write to.
volatile int& nowhere() {
  static volatile std::uintptr_t address = 16;
  return *reinterpret_cast<volatile int*>(address);
}

std::atomic<bool> tick_crashes{false};

// Pulls until it is set to crash in the middle of a tick.
class CrashingTracker final : public PlainTracker {
 public:
  Contact step(PointA hip) noexcept override {
    if (tick_crashes.load()) std::abort();
    return pull_.step(hip);
  }

 private:
  ConstantForceTracker pull_{40.0};
};

void tell(const std::string& line) { (void)!::write(STDOUT_FILENO, (line + '\n').c_str(), line.size() + 1); }

// Fills the stack: each call keeps its own page until the one below has come back.
[[gnu::noinline]] int deeper(volatile char* above, long calls) {
  if (calls == 0) return 0;
  volatile char page[4096];
  page[0] = *above;
  return deeper(page, calls - 1) + page[0];
}

void end(const std::string& way) {
  if (way == "wait") std::this_thread::sleep_for(std::chrono::seconds(30));
  std::string go;
  std::getline(std::cin, go);
  tell(std::to_string(monotonic_ns()));
  if (way == "segv") nowhere() = 1;
  if (way == "abort") std::abort();
  if (way == "terminate") std::terminate();
  if (volatile char first = 1; way == "stack") std::exit(deeper(&first, 1'000'000'000));
  if (way == "segv elsewhere") std::thread([] { nowhere() = 1; }).join();
  if (way == "throw elsewhere") std::thread([] { throw std::runtime_error("nobody takes it"); }).join();
  if (way == "tick") tick_crashes = true, std::this_thread::sleep_for(std::chrono::seconds(30));
  if (way == "exit") std::exit(7);
  if (way == "exit elsewhere") std::thread([] { std::exit(7); }).join();
  if (way == "throw") throw std::runtime_error("taken in main");
}

int run(const std::string& name, const std::string& way) {
  const CrashStack stack;
  rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  auto device = openDevice(name);
  if (!device) return std::cerr << device.problem().text() << '\n', 2;
  MouseDevice mouse;
  ServoThread servo(mouse);
  ServoSettings settings;
  settings.workspace.A_per_mm = 1.0;
  servo.loop().setSettings(settings);
  servo.setDevice(std::move(*device));
  servo.loop().setInteraction(std::make_unique<CrashingTracker>());
  test::NewestTick newest(servo.loop());
  for (int k = 0; k < 20'000; ++k) {
    if (servo.loop().device()->status().asks_calibrate) servo.loop().device()->calibrate();
    if (const ServoSample& now = newest(); !servo.loop().fallenBack() && glm::length(now.force.N) > 0.3) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      tell("pressing");
      if (way == "close" || way == "leave") {  // from full force
        for (int tries = 0; tries < 10'000 && glm::length(newest().force.N) < 2.2; ++tries)
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        tell(std::to_string(monotonic_ns()));
        way == "close" ? servo.setDevice(nullptr) : servo.endForce();
        return 0;
      }
      end(way);
      return 0;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return std::cerr << "it never pressed\n", 3;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    return run(argv[1], argv[2]);
  } catch (const std::exception&) {
    return 7;
  }
}
