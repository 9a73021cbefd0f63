#include "engine/language/catalogue.h"
#include "engine/platform/run_program.h"

namespace moltact {

Expected<ProgramRun> runProgram(const std::vector<std::string>& words, bool) {
  return Problem{words.empty() ? "" : words[0], 0, 0, tr("no other program can be started here"), {}};
}

#ifndef _WIN32
Expected<int> becomeProgram(const std::vector<std::string>& words) {
  return Problem{words.empty() ? "" : words[0], 0, 0, tr("no other program can be started here"), {}};
}
#endif

}  // namespace moltact
