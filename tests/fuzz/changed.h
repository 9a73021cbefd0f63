// The seeds of a target, and random mutations of them.
#pragma once

#include <random>
#include <string>
#include <vector>

namespace moltact::fuzz {

/// The contents of the files in tests/fuzz/seeds/NAME, ordered by name.
std::vector<std::string> seedsOf(const std::string& name);

/// One of the seeds (at least one is required) with 1 to 8 mutations: bits, bytes, characters, and ranges that are
/// deleted, duplicated or copied from another seed.
std::string changed(const std::vector<std::string>& seeds, std::mt19937_64& random, std::size_t longest = 4096);

/// A number from an environment variable, or `otherwise`.
unsigned long fromEnvironment(const char* name, unsigned long otherwise);

}  // namespace moltact::fuzz
