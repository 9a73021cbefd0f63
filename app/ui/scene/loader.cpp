#include "app/ui/scene/loader.h"

#include <exception>
#include <new>
#include <string>

#include "engine/language/catalogue.h"
#include "engine/molecule/reader.h"

namespace moltact {
namespace {

// The function of the thread. Any exception becomes a problem.
Loaded guarded(const Loader::Read& read, const MoleculeKey& key) {
  const std::string file = key.file.string();
  try {
    return read(key);
  } catch (const std::bad_alloc&) {
    return {key, Problem{file, 0, 0, tr("there is not enough memory to open it"),
                         tr("close other programs, or open a smaller structure")}};
  } catch (const std::exception& e) {
    return {key, Problem{file, 0, 0, trf("it cannot be opened: {0}", e.what()), tr("check the file")}};
  }
}

}  // namespace

Loaded readStage(const MoleculeKey& key) {
  Expected<Molecule> molecule = readMolecule(key);
  if (!molecule) return {key, molecule.problem()};
  return {key, makeTouchableModel(*std::move(molecule), key.file)};
}

Loader::Loader(Read read) : read_(read ? std::move(read) : Read(readStage)) {}

void Loader::begin(const MoleculeKey& key) { newest_.begin(inBackground(guarded, read_, key)); }

}  // namespace moltact
