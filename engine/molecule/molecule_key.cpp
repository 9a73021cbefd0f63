#include "engine/molecule/molecule_key.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <type_traits>

#include "engine/language/catalogue.h"
#include "engine/molecule/molecule.h"
#include "engine/molecule/radius_tables.h"

namespace moltact {
namespace {

int modelsIn(const Molecule& molecule) { return std::max(1, int(molecule.models_in_file)); }

std::vector<OfferedWord> radiusWords() {
  std::vector<OfferedWord> out;
  for (const RadiusTable& table : radiusTables()) out.push_back(table.word);
  return out;
}

const std::array kOptions{
    ReadingOption{.name = "model",
                  .member = &ReadOptions::model,
                  .label_format = N_("model {0}"),
                  .fallback = "1",
                  .meaning = "The number of the model in the molecule's file, from 1.",
                  .option_help = "Which model of the file, from 1",
                  .label = N_("Model"),
                  .max = [](const Molecule& molecule) { return modelsIn(molecule); },
                  .note =
                      [](const Molecule& molecule) {
                        const int models = modelsIn(molecule);
                        return trnf("The file has {0} model.", "The file has {0} models.", models, models);
                      }},
    ReadingOption{.name = "waters",
                  .member = &ReadOptions::waters,
                  .label_format = N_("with waters"),
                  .fallback = "no",
                  .meaning = "Whether the water molecules of the file are kept.",
                  .option_help = "Keep the water molecules",
                  .label = N_("Water molecules of the file")},
    ReadingOption{.name = "assembly",
                  .member = &ReadOptions::assembly,
                  .label_format = N_("assembly {0}"),
                  .fallback = "none",
                  .meaning = "The name of a biological assembly in the molecule's file, for example '1'; 'none' keeps "
                             "the coordinates of the file.",
                  .option_help = "Build this biological assembly (1)",
                  .label = N_("Biological assembly"),
                  .hint = N_("none: the coordinates as they stand in the file"),
                  .note =
                      [](const Molecule&) {
                        return std::string(tr(
                            "Its name in the file, mostly 1. Copies of the chains are made as they are in the cell."));
                      }},
    ReadingOption{.name = "beside",
                  .member = &ReadOptions::beside,
                  .label_format = N_("beside {0}"),
                  .fallback = "none",
                  .meaning = "A second molecule, by its name, to the right of the first for comparison, rotated like "
                             "the first if both have equal residues; 'none' removes it. Both can be touched; its "
                             "chains have a 2 after their names: 'chain A2'.",
                  .option_help = "Put this molecule beside it, for comparison",
                  .label = N_("Molecule beside it"),
                  .hint = N_("none: the molecule alone"),
                  .note =
                      [](const Molecule&) {
                        return std::string(
                            tr("For comparison: one of the library by its name, or a file in the same folder."));
                      }},
    ReadingOption{.name = "radii",
                  .member = &ReadOptions::radii,
                  .label_format = N_("radii: {0}"),
                  .fallback = "bondi",
                  .meaning = "The table of van der Waals radii. A radius in the molecule's file takes precedence.",
                  .option_help = "The table of van der Waals radii",
                  .label = N_("Van der Waals radii"),
                  .words = &radiusWords,
                  .note = [](const Molecule&) { return std::string(tr("A radius in the file takes precedence.")); }},
};

}  // namespace

std::span<const ReadingOption> readingOptions() { return kOptions; }

std::string textOf(const ReadOptions& reading, const ReadingOption& option) {
  if (const auto* number = std::get_if<int ReadOptions::*>(&option.member)) return std::to_string(reading.**number);
  if (const auto* on = std::get_if<bool ReadOptions::*>(&option.member)) return reading.**on ? "yes" : "no";
  return reading.*std::get<std::string ReadOptions::*>(option.member);
}

bool readText(ReadOptions& reading, const ReadingOption& option, std::string_view text) {
  if (text == option.fallback) {
    std::visit([&](const auto member) { reading.*member = ReadOptions().*member; }, option.member);
  } else if (const auto* member = std::get_if<int ReadOptions::*>(&option.member)) {
    int number = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    if (read.ec != std::errc() || read.ptr != end || number < 1 || number > kMaxReadNumber) return false;
    reading.** member = number;
  } else if (const auto* on = std::get_if<bool ReadOptions::*>(&option.member)) {
    if (text != "yes" && text != "no") return false;
    reading.** on = text == "yes";
  } else {
    const std::vector<OfferedWord> words = option.words ? option.words() : std::vector<OfferedWord>();
    if (option.words && std::none_of(words.begin(), words.end(), [&](const OfferedWord& w) { return w.name == text; }))
      return false;
    reading.*std::get<std::string ReadOptions::*>(option.member) = text;
  }
  return true;
}

bool isDefault(const ReadOptions& reading, const ReadingOption& option) {
  return std::visit([&](const auto member) { return reading.*member == ReadOptions().*member; }, option.member);
}

std::string readingText(const ReadOptions& reading) {
  std::string out;
  for (const ReadingOption& option : kOptions)
    if (!isDefault(reading, option))
      out += (out.empty() ? "" : ", ") + trf(option.label_format, textOf(reading, option));
  return out;
}

std::map<std::string, std::string> moleculeLabels(const NamedMolecule& molecule) {
  std::map<std::string, std::string> out{{"molecule", molecule.name}};
  for (const ReadingOption& option : kOptions) out.emplace(option.name, textOf(molecule.reading, option));
  return out;
}

NamedMolecule labelledMolecule(const std::map<std::string, std::string>& labels) {
  NamedMolecule out;
  if (const auto name = labels.find("molecule"); name != labels.end()) out.name = name->second;
  for (const ReadingOption& option : kOptions)
    if (const auto label = labels.find(std::string(option.name)); label != labels.end())
      readText(out.reading, option, label->second);
  return out;
}

}  // namespace moltact

std::size_t std::hash<moltact::MoleculeKey>::operator()(const moltact::MoleculeKey& key) const noexcept {
  std::size_t out = std::filesystem::hash_value(key.file);
  for (const moltact::ReadingOption& option : moltact::readingOptions())
    std::visit(
        [&](const auto member) {
          const auto& value = key.reading.*member;
          out ^= std::hash<std::remove_cvref_t<decltype(value)>>()(value) + 0x9e3779b97f4a7c15ull + (out << 6) +
                 (out >> 2);
        },
        option.member);
  return out;
}
