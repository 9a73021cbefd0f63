// The identity of a molecule: a file and how it is read. Two readings of a file, say with and without its waters, are
// two molecules. Plain data; any thread.
#pragma once

#include <compare>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "engine/core/offered_word.h"

namespace moltact {

struct Molecule;

/// How a molecule's file is read. A choice that is added here (a table of radii, say) gets a row in readingOptions(),
/// from which keys of scenes, labels, attempts, hashes, the page of readings and the options of commands are made. What
/// reads so is a reader, or the builder that all readers feed (parsed_structure.h).
struct ReadOptions {
  int model = 1;           ///< which model, counted from 1 in the order of the file (default: the first)
  bool waters = false;     ///< keep the water molecules (default: leave them out)
  std::string assembly{};  ///< name of a biological assembly to build ("1"); empty: the coordinates as they
                           ///< stand (default)
  std::string beside{};    ///< name or file of a second molecule that stands beside it (side_by_side.h); empty: none

  friend auto operator<=>(const ReadOptions&, const ReadOptions&) = default;
};

struct ReadingOption {
  std::string_view name;  ///< in labels, attempts, scenes and options of commands: "model"
  std::variant<int ReadOptions::*, bool ReadOptions::*, std::string ReadOptions::*> member;
  const char* told;              ///< how a person is told a value other than the default (N_): "model {0}"
  std::string_view fallback;     ///< the default as an author writes it: "1", "no", "none"
  std::string_view meaning;      ///< one sentence for authors
  std::string_view option_help;  ///< of the commands' option
  const char* label;             ///< on the page of readings, N_
  /// Of a text: what it may be, the default among them; null: any, as a name in the file is.
  std::vector<OfferedWord> (*words)() = nullptr;
  const char* hint = "";  ///< of a text that may be any, where it is empty, N_
  /// Of a number: the greatest that this molecule's file has.
  int (*most)(const Molecule& molecule) = nullptr;
  /// A sentence below it on the page, in the language in use; null: none.
  std::string (*note)(const Molecule& molecule) = nullptr;
};

/// A number is from 1 to this.
inline constexpr int kMaxReadNumber = 100'000;

/// All, in the order in which they are told.
std::span<const ReadingOption> readingOptions();

/// As text: "3"; "yes" or "no"; a text, which is one of its words where it has some.
std::string textOf(const ReadOptions& reading, const ReadingOption& option);
/// The same back, and the default from the option's `fallback`; false, and nothing changed, where the text is not
/// sound.
bool readText(ReadOptions& reading, const ReadingOption& option, std::string_view text);
bool isDefault(const ReadOptions& reading, const ReadingOption& option);

/// A molecule whose file has been found.
struct MoleculeKey {
  std::filesystem::path file;
  ReadOptions reading{};

  bool empty() const { return file.empty(); }
  friend auto operator<=>(const MoleculeKey&, const MoleculeKey&) = default;
};

/// A molecule as a person names it: a file, an id of the library or of a fetched entry (findMoleculeKey in catalogue.h
/// finds its file). A name alone means: as it is read by default.
struct NamedMolecule {
  std::string name;
  ReadOptions reading{};

  NamedMolecule() = default;
  NamedMolecule(const char* plain_name) : name(plain_name) {}
  NamedMolecule(std::string its_name, ReadOptions how = {}) : name(std::move(its_name)), reading(std::move(how)) {}

  friend auto operator<=>(const NamedMolecule&, const NamedMolecule&) = default;
};

/// The options that differ from the default, as "model 2, with waters, assembly 1"; empty where nothing is.
std::string readingText(const ReadOptions& reading);

/// The labels that a recording carries, "molecule" and one for each option, and back. A label that is missing or not
/// sound gives the default.
std::map<std::string, std::string> moleculeLabels(const NamedMolecule& molecule);
NamedMolecule labelledMolecule(const std::map<std::string, std::string>& labels);

}  // namespace moltact

template <>
struct std::hash<moltact::MoleculeKey> {
  std::size_t operator()(const moltact::MoleculeKey& key) const noexcept;
};
