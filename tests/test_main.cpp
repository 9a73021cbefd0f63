#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <cstdlib>

// The tests, and the programs that they run, speak English whatever the system's language is.
int main(int argc, char** argv) {
  ::setenv("MOLTACT_LANGUAGE", "en", 1);
  return doctest::Context(argc, argv).run();
}
