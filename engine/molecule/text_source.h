// The text of a molecule's file, line by line: from memory, from a file or unpacked from gzip on the way, so that no
// more than a piece of it is held. Inside engine/molecule only.
#pragma once

#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/problem.h"

namespace moltact {

/// Bytes, piece by piece.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  /// Up to `most` bytes, at least one; 0 at the end, or where problem() says what is wrong.
  virtual std::size_t read(char* to, std::size_t most) = 0;
  /// How many packed bytes have been consumed for the bytes read so far; 0 for a source that is not packed.
  virtual std::size_t packedBytesRead() const { return 0; }
  const std::optional<Problem>& problem() const { return problem_; }

 protected:
  std::optional<Problem> problem_;
};

/// `bytes` must outlive it.
std::unique_ptr<ByteSource> memorySource(std::string_view bytes);
/// The bytes of a file of `size` bytes; `name` is its name in problems.
std::unique_ptr<ByteSource> fileSource(std::ifstream in, std::size_t size, const std::string& name);
/// The bytes that `packed` unpacks to, all members of the file one after another; a Problem where it is cut or damaged.
std::unique_ptr<ByteSource> gzipSource(std::unique_ptr<ByteSource> packed, const std::string& name);

/// True where the bytes begin as gzip does.
bool isGzip(std::string_view bytes);

/// A line longer than this is refused (unit: byte).
inline constexpr std::size_t kLongestMoleculeLine = std::size_t{16} << 20;

class TextSource {
 public:
  /// The text of at most `most` bytes, unpacked from gzip where the bytes begin so. `expected` bytes are in the source,
  /// before unpacking.
  TextSource(std::unique_ptr<ByteSource> bytes, std::size_t expected, std::size_t most, std::string file);

  /// The next line without its line feed, valid until the next call; false at the end, and where there is a problem.
  bool next(std::string_view& line);
  std::size_t number() const { return number_; }  ///< of the line that was last given, from 1
  /// The text that follows, up to 64 KiB of it, without taking it.
  std::string_view ahead();
  const std::optional<Problem>& problem() const { return problem_; }
  bool blank() const { return blank_; }  ///< no line so far held anything
  /// How many bytes of text the whole is, as a guess that gets better the more of it was read; at most `most`.
  std::size_t expectedBytes() const;
  std::size_t givenBytes() const { return given_; }  ///< of the lines so far
  const std::string& file() const { return file_; }

 private:
  bool fill();

  std::unique_ptr<ByteSource> bytes_;
  std::size_t expected_, most_, taken_ = 0, given_ = 0;
  std::size_t packed_bytes_ = 0;  // of a packed source
  std::string file_;
  std::string buffer_;
  std::size_t at_ = 0, end_ = 0;  // what is in the buffer and not given yet
  std::size_t number_ = 0;
  bool packed_ = false, ended_ = false, blank_ = true;
  std::optional<Problem> problem_;
};

}  // namespace moltact
