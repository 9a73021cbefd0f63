// Reads a molecule's file line by line or as bytes, from memory or from a file, decompressing gzip on the fly. Only a
// small part is held in memory. Internal to engine/molecule.
#pragma once

#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/problem.h"

namespace moltact {

/// A stream of bytes.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  /// Reads up to `max_bytes` bytes, at least one. Returns 0 at the end or on an error, see problem().
  virtual std::size_t read(char* to, std::size_t max_bytes) = 0;
  /// Number of compressed bytes consumed so far; 0 for an uncompressed source.
  virtual std::size_t packedBytesRead() const { return 0; }
  const std::optional<Problem>& problem() const { return problem_; }

 protected:
  std::optional<Problem> problem_;
};

/// Reads from memory; `bytes` must outlive the source.
std::unique_ptr<ByteSource> memorySource(std::string_view bytes);
/// Reads a file of `size` bytes; `name` is its name in problems.
std::unique_ptr<ByteSource> fileSource(std::ifstream in, std::size_t size, const std::string& name);
/// Decompresses all members of a gzip file in sequence; truncated or damaged data give a Problem.
std::unique_ptr<ByteSource> gzipSource(std::unique_ptr<ByteSource> packed, const std::string& name);

/// True if the bytes start with the signature of gzip.
bool isGzip(std::string_view bytes);

/// Limit on the length of a line (unit: byte).
inline constexpr std::size_t kMaxMoleculeLineBytes = std::size_t{16} << 20;

class TextSource {
 public:
  /// Reads text of at most `max_bytes` bytes; gzip is detected and decompressed. `expected` is the size of the source
  /// before decompression.
  TextSource(std::unique_ptr<ByteSource> bytes, std::size_t expected, std::size_t max_bytes, std::string file);

  /// Reads the next line, without its line feed, valid until the next call. Returns false at the end or on an error,
  /// see problem().
  bool next(std::string_view& line);
  /// Reads up to `most` bytes as they are, for a binary format, and appends them to `out`. Returns false at the end or on
  /// an error. Lines and bytes may alternate.
  bool bytes(std::size_t most, std::string& out);
  std::size_t number() const { return number_; }  ///< number of the last line, from 1
  /// Up to 64 KiB of the following text, without consuming it.
  std::string_view ahead();
  const std::optional<Problem>& problem() const { return problem_; }
  bool blank() const { return blank_; }  ///< all lines so far were blank
  /// An estimate of the total size of the text, which improves while reading; at most `max_bytes`.
  std::size_t expectedBytes() const;
  std::size_t givenBytes() const { return given_; }  ///< size of the lines read so far
  const std::string& file() const { return file_; }

 private:
  bool fill();

  std::unique_ptr<ByteSource> bytes_;
  std::size_t expected_, max_bytes_, taken_ = 0, given_ = 0;
  std::size_t packed_bytes_ = 0;  // size of a compressed source
  std::string file_;
  std::string buffer_;
  std::size_t at_ = 0, end_ = 0;  // the unread part of the buffer
  std::size_t number_ = 0;
  bool packed_ = false, ended_ = false, blank_ = true;
  std::optional<Problem> problem_;
};

}  // namespace moltact
