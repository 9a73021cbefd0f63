// A pack: one file, NAME.moltact, that contains a lesson with its translations, the lessons to which it links, and its
// molecules and pictures, for distribution to students. It is a zip file (PKWARE APPNOTE 6.3) with names relative to
// the lesson's folder, plus "pack.json": {"format": 1, "lesson": "haem.md"}. libzip reads it from memory. Any thread
// except the haptic one; a PackFile is used by one thread at a time.
//
// A pack is untrusted. Opening checks the directory of the zip file before anything is unpacked, and rejects a pack
// beyond a limit below. Reading an entry enforces the size stated in the directory.
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
inline constexpr int kPackFormat = 1;  ///< newer formats are rejected

inline constexpr std::size_t kMaxPackBytes = std::size_t{256} << 20;  ///< unit: byte
inline constexpr std::size_t kMaxUnpacked = std::size_t{1} << 30;     ///< all files together (unit: byte)
inline constexpr std::size_t kMaxPackEntries = 1000;                  ///< files and folders
inline constexpr std::size_t kMaxPackRatio = 200;                     ///< limit on a file's unpacked to packed size …
inline constexpr std::size_t kSmallUnpacked = std::size_t{1} << 20;   ///< … for files above this size (unit: byte)
inline constexpr std::size_t kMaxPackManifestBytes = std::size_t{4096};  ///< unit: byte

/// True if the file's name is that of a pack.
bool hasPackName(const std::filesystem::path& file);

struct PackEntry {
  std::string name;       ///< "pictures/ring.png"; valid by packNameFault()
  std::size_t bytes = 0;  ///< unpacked size
};

class PackFile {
 public:
  /// Opens a pack. Returns a Problem that names the entry if the file is unreadable, not a pack, or rejected.
  static Expected<PackFile> open(const std::filesystem::path& file);
  /// The same for bytes in memory; `name` is used in problems.
  static Expected<PackFile> ofBytes(std::string name, std::string bytes);

  PackFile(PackFile&&) noexcept;
  PackFile& operator=(PackFile&&) noexcept;
  ~PackFile();

  const std::string& name() const;
  /// contentHash() of the file.
  const std::string& hash() const;
  /// The first lesson: one of the entries, at the top level of the pack.
  const std::string& lesson() const;
  /// The files by name, without the manifest.
  const std::vector<PackEntry>& entries() const;

  /// Passes an entry's bytes to `take` in pieces. A Problem from `take` ends the reading and is returned. Also returns
  /// a Problem if the entry is damaged or its size differs from the stated one.
  using Take = std::function<std::optional<Problem>(std::string_view bytes)>;
  std::optional<Problem> read(const PackEntry& entry, const Take& take) const;
  Expected<std::string> read(const PackEntry& entry) const;

 private:
  struct Impl;
  explicit PackFile(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace moltact
