#include "engine/platform/storage_web.h"

#include <emscripten.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {
std::string fault;
}

namespace platform {

Problem storageProblem(const std::filesystem::path& file, int error) {
  switch (error) {
    case ENOENT:
    case ENOTDIR:
      return {file.string(), 0, 0, tr("its folder is not there"), tr("make the folder")};
    case EEXIST:
      return {file.string(), 0, 0, tr("it is already there"), {}};
    case EISDIR:
      return {file.string(), 0, 0, tr("it is a folder"), tr("name a file")};
    default:
      return {file.string(), 0, 0, trf("it cannot be written ({0})", std::strerror(error)), {}};
  }
}

void storageChanged() {
  EM_ASM({ Module.keeper.changed(); });
}

}  // namespace platform

std::string takeStorageFault() { return std::exchange(fault, {}); }

}  // namespace moltact

// Called by page.js when the browser has refused to store a file.
extern "C" EMSCRIPTEN_KEEPALIVE void moltact_storage_fault(int full) {
  moltact::fault =
      full ? moltact::tr(
                 "The browser has no room left: what you do from now on is kept only until this page is closed. "
                 "Hand in your results before that.")
           : moltact::tr(
                 "This browser keeps nothing for this page (a private window?): what you do is there only until "
                 "it is closed. Hand in your results before that.");
}
