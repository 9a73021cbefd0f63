#include <emscripten.h>

#include <string>

#include "engine/platform/hand_over.h"

EM_JS(void, giveFile, (const char* path, const char* name),
      { Module.page.give(UTF8ToString(path), UTF8ToString(name)); })
EM_JS(void, chooseFile, (void), { Module.page.choose(); })

namespace moltact {

bool filesAreHandedOver() noexcept { return true; }
void handOver(const std::filesystem::path& file) { giveFile(file.c_str(), file.filename().c_str()); }
bool askForFile() {
  chooseFile();
  return true;
}

}  // namespace moltact
