#include "app/ui/scene/loader.h"

#include <chrono>
#include <exception>
#include <new>
#include <string>

#include "engine/language/catalogue.h"
#include "engine/molecule/reader.h"
#include "engine/platform/background.h"
#include "engine/platform/force_inhibit.h"

namespace moltact {
namespace {

// What the thread runs: nothing that goes wrong in it ends the program.
Loaded guarded(const Loader::Read& read, const MoleculeKey& key) {
  const std::string file = key.file.string();
  const CrashStack crash_stack;  // a force ends even then
  try {
    return read(key);
  } catch (const std::bad_alloc&) {
    return {key, Problem{file, 0, 0, tr("there is not enough memory to open it"),
                         tr("close other programs, or open a smaller structure")}};
  } catch (const std::exception& e) {
    return {key, Problem{file, 0, 0, trf("it cannot be opened: {0}", e.what()), tr("check the file")}};
  }
}

bool ready(const std::future<Loaded>& f) { return f.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }

}  // namespace

Loaded readStage(const MoleculeKey& key) {
  Expected<Molecule> molecule = readMolecule(key);
  if (!molecule) return {key, molecule.problem()};
  return {key, makeStage(*std::move(molecule), key.file)};
}

Loader::Loader(Read read) : read_(read ? std::move(read) : Read(readStage)) {}

void Loader::begin(const MoleculeKey& key) {
  if (wanted_.valid()) unwanted_.push_back(std::move(wanted_));
  std::erase_if(unwanted_, [](const std::future<Loaded>& f) { return ready(f); });
  wanted_ = inBackground(guarded, read_, key);
}

std::optional<Loaded> Loader::take() {
  if (!wanted_.valid() || !ready(wanted_)) return std::nullopt;
  return wanted_.get();
}

std::optional<Loaded> Loader::wait() {
  if (!wanted_.valid()) return std::nullopt;
  return wanted_.get();
}

}  // namespace moltact
