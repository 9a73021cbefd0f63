#include "engine/dynamics/openmm_engine.h"

#include <vector>

#include "engine/language/catalogue.h"
#include "engine/platform/folders.h"
#include "engine/platform/shared_library.h"

namespace moltact {
namespace {

Expected<MakeMdEngine> loaded() {
  static const Expected<MakeMdEngine> maker = []() -> Expected<MakeMdEngine> {
    std::vector<std::string> names;
    for (const std::filesystem::path& file : moduleFiles("moltact_openmm")) names.push_back(file.string());
    const Expected<SharedLibrary> module = SharedLibrary::open(names);
    if (!module) return module.problem();
    if (void* made = module->symbol(kMakeMdEngine)) return reinterpret_cast<MakeMdEngine>(made);
    return Problem{{}, 0, 0, trf("it has no function {0}", kMakeMdEngine), {}};
  }();
  return maker;
}

}  // namespace

Expected<std::unique_ptr<MdEngine>> openMMEngine(const MdStart& start, const std::string& file) {
  const Expected<MakeMdEngine> make = loaded();
  if (!make)
    return Problem{file, 0, 0, trf("simulations need OpenMM, which cannot be loaded ({0})", make.problem().message),
                   tr("install the package moltact-openmm; a build from the sources needs libopenmm-dev and "
                      "libopenmm-plugins. On Windows there are no simulations")};
  std::string why;
  std::unique_ptr<MdEngine> engine((*make)(start, why));
  if (!engine) return openMMRefusal(file, why);
  return engine;
}

Problem openMMRefusal(const std::string& file, const std::string& why) {
  return {file, 0, 0, trf("OpenMM cannot simulate this system: {0}", why),
          tr("make both files again with 'moltact simulate prepare'")};
}

}  // namespace moltact
