// moltact-bench: the command `moltact bench` with the code that measures. `moltact bench` starts it with its own command
// line.
#include "app/bench/run_bench.h"
#include "app/commands/program.h"

int main(int argc, char** argv) {
  using namespace moltact;
  return runMain([&] {
    CLI::App app{"Measures Moltact's haptic methods; start it by 'moltact bench'", "moltact"};
    app.require_subcommand(1);
    setBench(&runBench, {});
    addBench(app);
    completeCommand(*app.get_subcommand("bench"));
    return parsed(app, argc, argv).value_or(0);
  });
}
