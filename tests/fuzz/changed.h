// The seeds of a target, and seeds that were changed at random.
#pragma once

#include <random>
#include <string>
#include <vector>

namespace moltact::fuzz {

/// What the files of tests/fuzz/seeds/NAME hold, in their names' order.
std::vector<std::string> seedsOf(const std::string& name);

/// One of the seeds (there must be one) with 1 to 8 changes: bits, bytes, signs, ranges that go, come twice or come
/// from another seed.
std::string changed(const std::vector<std::string>& seeds, std::mt19937_64& random, std::size_t longest = 4096);

/// A number that the environment gives under a name, else `otherwise`.
unsigned long fromEnvironment(const char* name, unsigned long otherwise);

}  // namespace moltact::fuzz
