// A pack: one file, NAME.moltact, that holds a lesson with its translations, the lessons that it leads to, its
// molecules and pictures, to be handed to students. It is a zip (PKWARE APPNOTE 6.3) of files by their names from the
// lesson's folder, and of "pack.json": {"format": 1, "lesson": "haem.md"}. Read by libzip, whole in memory. Any thread
// but the haptic one; one PackFile on one thread at a time.
//
// A pack may come from anybody: opening judges all that is told of its files, before one of them is unpacked, and
// refuses what breaks a limit below. Reading a file of it holds what comes to what was told.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"

namespace moltact {

inline constexpr const char* kPackEnding = ".moltact";
inline constexpr const char* kPackManifest = "pack.json";
inline constexpr int kPackFormat = 1;  ///< a reader refuses newer ones

inline constexpr std::size_t kLargestPack = std::size_t{256} << 20;  ///< unit: byte
inline constexpr std::size_t kMaxUnpacked = std::size_t{1} << 30;    ///< all files together (unit: byte)
inline constexpr std::size_t kMaxPackEntries = 1000;                 ///< files and folders
inline constexpr std::size_t kMaxPackRatio = 200;                    ///< a file's bytes, unpacked to packed …
inline constexpr std::size_t kSmallUnpacked = std::size_t{1} << 20;  ///< … which small ones may exceed (unit: byte)
inline constexpr std::size_t kLargestPackManifest = std::size_t{4096};  ///< unit: byte

/// By the name alone.
bool hasPackName(const std::filesystem::path& file);

struct PackEntry {
  std::string name;       ///< "pictures/ring.png"; packNameFault() is empty
  std::size_t bytes = 0;  ///< unpacked
};

class PackFile {
 public:
  /// A Problem, naming the entry at fault, where the file cannot be read, is no pack, or is one that is refused.
  static Expected<PackFile> open(const std::filesystem::path& file);
  /// The same of bytes in memory; `name` stands in problems.
  static Expected<PackFile> ofBytes(std::string name, std::string bytes);

  PackFile(PackFile&&) noexcept;
  PackFile& operator=(PackFile&&) noexcept;
  ~PackFile();

  const std::string& name() const;
  /// contentHash() of the file.
  const std::string& hash() const;
  /// The lesson that is shown first: one of the entries, at the pack's top.
  const std::string& lesson() const;
  /// The files, by name; without the manifest.
  const std::vector<PackEntry>& entries() const;

  /// Hands over an entry's bytes, piece by piece, until `take` gives a Problem, which then comes back. A Problem where
  /// the entry is damaged, or longer or shorter than was told.
  using Take = std::function<std::optional<Problem>(std::string_view bytes)>;
  std::optional<Problem> read(const PackEntry& entry, const Take& take) const;
  Expected<std::string> read(const PackEntry& entry) const;

 private:
  struct Impl;
  explicit PackFile(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace moltact
