// The bytes of a file at any place, for readers of frames. A gzipped file is unpacked into memory. One thread at a time,
// not the haptic one; the calls block on the disk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "engine/core/problem.h"

namespace moltact {

class RandomAccessFile {
 public:
  /// Limit on the unpacked size of a gzipped file (unit: byte).
  static constexpr std::size_t kMaxUnpacked_bytes = std::size_t{200} << 20;

  static Expected<RandomAccessFile> open(const std::filesystem::path& file);
  /// The same for bytes in memory, with this name in problems.
  RandomAccessFile(std::string bytes, std::string name)
      : name_(std::move(name)), size_(bytes.size()), bytes_(std::move(bytes)) {}

  const std::string& name() const { return name_; }
  /// At the time of opening.
  std::uint64_t size() const { return size_; }
  /// Copies `n` bytes from `at`. Returns false if the file has fewer or cannot be read.
  bool read(std::uint64_t at, void* to, std::size_t n);
  /// The same, up to `n` bytes; returns their number.
  std::size_t readSome(std::uint64_t at, void* to, std::size_t n);

 private:
  RandomAccessFile(std::ifstream in, std::uint64_t size, std::string name)
      : name_(std::move(name)), size_(size), in_(std::move(in)) {}

  std::string name_;
  std::uint64_t size_ = 0;
  std::string bytes_;  // in memory
  std::ifstream in_;   // or on the disk
};

/// The lines of a file from any place on.
class LinesFrom {
 public:
  explicit LinesFrom(RandomAccessFile& file) : file_(file) {}
  /// The next line begins here.
  void seek(std::uint64_t at);
  /// Reads a line without its line feed, valid until the next call. Returns false at the end of the file, and at a line
  /// longer than kMaxLine_bytes.
  bool next(std::string_view& line);
  static constexpr std::size_t kMaxLine_bytes = 1 << 16;
  /// Where the next line begins.
  std::uint64_t at() const { return begins_ + used_; }

 private:
  RandomAccessFile& file_;
  std::uint64_t begins_ = 0;  // of the buffer in the file
  std::size_t used_ = 0;
  std::string buffer_;
};

}  // namespace moltact
