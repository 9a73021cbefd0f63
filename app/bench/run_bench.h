// What moltact-bench adds to moltact: `moltact bench` measures speed, accuracy, feel and stability of every method.
#pragma once

#include "app/commands/bench.h"

namespace moltact {

/// The BenchRunner.
void runBench(const BenchArguments& arguments);

}  // namespace moltact
