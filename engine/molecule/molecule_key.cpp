#include "engine/molecule/molecule_key.h"

#include <charconv>

#include "engine/language/catalogue.h"

namespace moltact {

std::string readingText(const ReadOptions& reading) {
  std::string out;
  const auto add = [&](const std::string& part) { out += (out.empty() ? "" : ", ") + part; };
  if (reading.model != 1) add(trf("model {0}", reading.model));
  if (reading.waters) add(tr("with waters"));
  if (!reading.assembly.empty()) add(trf("assembly {0}", reading.assembly));
  return out;
}

std::map<std::string, std::string> moleculeLabels(const NamedMolecule& molecule) {
  const ReadOptions& reading = molecule.reading;
  return {{"molecule", molecule.name},
          {"model", std::to_string(reading.model)},
          {"waters", reading.waters ? "yes" : "no"},
          {"assembly", reading.assembly}};
}

NamedMolecule labelledMolecule(const std::map<std::string, std::string>& labels) {
  const auto label = [&](const char* key) {
    const auto found = labels.find(key);
    return found == labels.end() ? std::string() : found->second;
  };
  NamedMolecule out(label("molecule"));
  const std::string model = label("model");
  int number = 0;
  if (std::from_chars(model.data(), model.data() + model.size(), number).ec == std::errc() && number > 0)
    out.reading.model = number;
  out.reading.waters = label("waters") == "yes";
  out.reading.assembly = label("assembly");
  return out;
}

}  // namespace moltact

std::size_t std::hash<moltact::MoleculeKey>::operator()(const moltact::MoleculeKey& key) const noexcept {
  std::size_t out = std::filesystem::hash_value(key.file);
  const auto mix = [&](std::size_t value) { out ^= value + 0x9e3779b97f4a7c15ull + (out << 6) + (out >> 2); };
  mix(std::hash<int>()(key.reading.model));
  mix(std::hash<bool>()(key.reading.waters));
  mix(std::hash<std::string>()(key.reading.assembly));
  return out;
}
