// A program that pulls an atom of an IMD server until it moves, and ends in the requested way:
//   dying_client PORT ATOMS segv|abort|term|exit|return
#include <signal.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "engine/dynamics/imd/imd_simulation.h"

// In a build with sanitizers the process is to end as others do.
extern "C" const char* __asan_default_options() { return "handle_segv=0:handle_abort=0:detect_leaks=0"; }
extern "C" const char* __tsan_default_options() { return "handle_segv=0:handle_abort=0"; }

int main(int count, char** words) {
  using namespace moltact;
  if (count != 4) return 2;
  auto live = ImdSimulation::connect({"127.0.0.1", std::uint16_t(std::atoi(words[1]))},
                                     std::vector<Vec3>(std::size_t(std::atoi(words[2]))), nullptr);
  if (!live) {
    std::fprintf(stderr, "%s\n", live.problem().text().c_str());
    return 1;
  }
  SimulationCommand wanted;
  wanted.pushes.push_back({0, Vec3(1e3, 0, 0), Vec3(0.0), 2.0});
  const std::string way = words[3];
  // The atom moves, so the force is on.
  const double x_A = (*live)->newest().positions_A[0].x;
  for (int k = 0; k < 60'000 && (*live)->newest().positions_A[0].x < x_A + 1.0; ++k) {
    (*live)->command(wanted);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  if (way == "segv") ::raise(SIGSEGV);
  if (way == "abort") std::abort();
  if (way == "term") ::raise(SIGTERM);
  if (way == "exit") std::exit(0);
  return 0;
}
