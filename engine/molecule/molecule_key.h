// The identity of a molecule: its file and its reading options. A file read with and without its waters gives two
// different molecules. Plain data; any thread.
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

/// The options for reading a molecule's file. A new option needs a row in readingOptions(), which generates keys of
/// scenes, labels, attempts, hashes, the page of reading options and the commands' options. A reader, or the builder
/// that all readers use (parsed_structure.h), applies it.
struct ReadOptions {
  int model = 1;        ///< number of the model, from 1 in file order (default: the first)
  bool waters = false;  ///< keep the water molecules (default: omit them)
  std::string
      assembly{};  ///< name of the biological assembly to build ("1"); empty: the coordinates of the file (default)
  std::string beside{};  ///< name or file of a second molecule beside this one (side_by_side.h); empty: none

  std::string radii = "bondi";  ///< name of the table of van der Waals radii (radius_tables.h)

  friend auto operator<=>(const ReadOptions&, const ReadOptions&) = default;
};

/// One row of the table of options.
struct ReadingOption {
  std::string_view name;  ///< in labels, attempts, scenes and the commands' options: "model"
  std::variant<int ReadOptions::*, bool ReadOptions::*, std::string ReadOptions::*> member;
  const char* label_format;      ///< format of a value that is not the default, untranslated (N_): "model {0}"
  std::string_view fallback;     ///< the default as written in a lesson: "1", "no", "none"
  std::string_view meaning;      ///< one sentence for authors
  std::string_view option_help;  ///< help text of the commands' option
  const char* label;             ///< on the page of reading options, untranslated (N_)
  /// The possible words of a text, including the default; null: any text, such as a name from the file.
  std::vector<OfferedWord> (*words)() = nullptr;
  const char* hint = "";  ///< shown in an empty text field that accepts any text, untranslated (N_)
  /// The largest valid number for this molecule's file; null for an option that is not a number.
  int (*max)(const Molecule& molecule) = nullptr;
  /// A translated note below the option on the page; null: none.
  std::string (*note)(const Molecule& molecule) = nullptr;
};

/// Numbers range from 1 to this value.
inline constexpr int kMaxReadNumber = 100'000;

/// All options, in display order.
std::span<const ReadingOption> readingOptions();

/// Converts an option's value to text: "3"; "yes" or "no"; the text itself.
std::string textOf(const ReadOptions& reading, const ReadingOption& option);
/// Parses an option's value; the option's `fallback` gives the default. Returns false and changes nothing if the text
/// is invalid.
bool readText(ReadOptions& reading, const ReadingOption& option, std::string_view text);
bool isDefault(const ReadOptions& reading, const ReadingOption& option);

/// A molecule whose file is known.
struct MoleculeKey {
  std::filesystem::path file;
  ReadOptions reading{};

  bool empty() const { return file.empty(); }
  friend auto operator<=>(const MoleculeKey&, const MoleculeKey&) = default;
};

/// A molecule as a user names it: a file, or the id of a library or fetched entry. findMoleculeKey in catalogue.h finds
/// its file. A name without options means the default options.
struct NamedMolecule {
  std::string name;
  ReadOptions reading{};

  NamedMolecule() = default;
  NamedMolecule(const char* plain_name) : name(plain_name) {}
  NamedMolecule(std::string its_name, ReadOptions how = {}) : name(std::move(its_name)), reading(std::move(how)) {}

  friend auto operator<=>(const NamedMolecule&, const NamedMolecule&) = default;
};

/// The options that differ from the default, as "model 2, with waters, assembly 1"; empty if none does.
std::string readingText(const ReadOptions& reading);

/// Converts between a molecule and the labels of a recording: "molecule" and one label per option. A missing or invalid
/// label gives the default.
std::map<std::string, std::string> moleculeLabels(const NamedMolecule& molecule);
NamedMolecule labelledMolecule(const std::map<std::string, std::string>& labels);

}  // namespace moltact

template <>
struct std::hash<moltact::MoleculeKey> {
  std::size_t operator()(const moltact::MoleculeKey& key) const noexcept;
};
