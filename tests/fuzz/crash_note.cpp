#include "tests/fuzz/crash_note.h"

#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>

// Of the sanitizers' runtime, where there is one: they end a program without a signal.
extern "C" void __sanitizer_set_death_callback(void (*callback)()) __attribute__((weak));

namespace moltact::fuzz {
namespace {

char now[160];

void write(const char* what) {
  if (::write(2, now, std::strlen(now)) < 0 || ::write(2, what, std::strlen(what)) < 0) ::_exit(2);
}

extern "C" void tellSignal(int number) {
  write(number == SIGALRM ? " does not end\n" : " ended the program\n");
  ::signal(number, SIG_DFL);
  ::raise(number);
}

}  // namespace

void tellCrashes() {
  ::signal(SIGALRM, tellSignal);
  ::signal(SIGABRT, tellSignal);
  if (__sanitizer_set_death_callback) return __sanitizer_set_death_callback([] { write(" ended the program\n"); });
  for (const int s : {SIGSEGV, SIGFPE, SIGBUS, SIGILL}) ::signal(s, tellSignal);
}

void beginRun(const std::string& name, unsigned hang_s) {
  std::snprintf(now, sizeof now, "%s", name.c_str());
  ::alarm(hang_s);
}

void endRun() { ::alarm(0); }

}  // namespace moltact::fuzz
