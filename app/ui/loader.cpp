#include "app/ui/loader.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <string>

#include "engine/molecule/reader.h"

namespace moltact {
namespace {

Loaded read(std::filesystem::path file) {
  Expected<Molecule> molecule = readMolecule(file);
  if (!molecule) return {std::move(file), molecule.problem()};
  Expected<Stage> stage = makeStage(*std::move(molecule), file);
  return {std::move(file), std::move(stage)};
}

bool ready(const std::future<Loaded>& f) { return f.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }

}  // namespace

void Loader::begin(std::filesystem::path file) {
  if (wanted_.valid()) unwanted_.push_back(std::move(wanted_));
  std::erase_if(unwanted_, [](const std::future<Loaded>& f) { return ready(f); });
  file_ = file;
  wanted_ = std::async(std::launch::async, read, std::move(file));
}

std::optional<Loaded> Loader::take() {
  if (!wanted_.valid() || !ready(wanted_)) return std::nullopt;
  return wanted_.get();
}

std::optional<Loaded> Loader::wait() {
  if (!wanted_.valid()) return std::nullopt;
  return wanted_.get();
}

bool looksLikeMolecule(const std::filesystem::path& file) {
  static constexpr std::array kEndings{".pdb", ".ent", ".cif", ".mmcif", ".xyzr"};
  std::string name = file.filename().string();
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  if (name.ends_with(".gz")) name.resize(name.size() - 3);
  return std::any_of(kEndings.begin(), kEndings.end(), [&](const char* e) { return name.ends_with(e); });
}

}  // namespace moltact
