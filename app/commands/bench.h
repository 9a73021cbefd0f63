// `moltact bench`. Its measuring code is in a program of its own, moltact-bench, which is the same program with a
// BenchRunner; nobody else compiles, loads or starts it.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

namespace moltact {

struct BenchArguments {
  std::string part = "all", json, csv, svg, docs, markdown, page_ticks;
  std::vector<std::string> methods;
  std::vector<std::string> recordings;
  std::string recording_molecule;
  bool quick = false;
  std::uint64_t seed = 1;
};

/// Measures. Throws a CommandError.
using BenchRunner = void (*)(const BenchArguments& arguments);

void addBench(CLI::App& app);

/// How the command runs: by `runner`, or without one by starting moltact-bench with the words of this command line. To be
/// called before the command line is parsed.
void setBench(BenchRunner runner, std::vector<std::string> words);

}  // namespace moltact
