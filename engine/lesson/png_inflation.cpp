#include "engine/lesson/png_inflation.h"

#include <zlib.h>

#include <array>
#include <cstdint>
#include <optional>

namespace moltact {
namespace {

// Some programs write a few bytes too many, which decoders ignore.
constexpr std::uint64_t kSlack_bytes = 65536;

std::uint64_t bigEndian(std::string_view bytes, std::size_t at) {
  std::uint64_t out = 0;
  for (std::size_t k = 0; k < 4; ++k) out = out << 8 | std::uint8_t(bytes[at + k]);
  return out;
}

struct Chunk {
  std::string_view kind, data;
};

// The chunk at `at`, which is moved behind it. A truncated last chunk gives its existing part.
std::optional<Chunk> chunkAt(std::string_view png, std::size_t& at) {
  if (png.size() < at || png.size() - at < 8) return std::nullopt;
  const std::uint64_t length = bigEndian(png, at);
  const Chunk out{png.substr(at + 4, 4), png.substr(at + 8, length)};
  at = length > png.size() ? png.size() : at + 12 + std::size_t(length);
  return out;
}

// The size of all rows; each begins with its filter byte. Interlaced rows (Adam7) are in seven passes.
std::optional<std::uint64_t> bytesOfRows(std::string_view header) {
  if (header.size() < 13) return std::nullopt;
  const std::uint64_t width = bigEndian(header, 0), height = bigEndian(header, 4);
  constexpr std::array<std::uint64_t, 7> kChannels{1, 0, 3, 1, 2, 0, 4};  // by colour type
  const auto type = std::uint8_t(header[9]);
  const std::uint64_t bits = std::uint8_t(header[8]) * (type < kChannels.size() ? kChannels[type] : 0);
  if (bits == 0) return std::nullopt;
  const auto pass = [&](std::uint64_t columns, std::uint64_t rows) {
    return columns == 0 ? 0 : rows * (1 + (columns * bits + 7) / 8);
  };
  if (header[12] == 0) return pass(width, height);
  struct Pass {
    std::uint64_t x, y, dx, dy;
  };
  constexpr Pass kPasses[] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                              {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
  std::uint64_t out = 0;
  for (const Pass& p : kPasses) out += pass((width + p.dx - 1 - p.x) / p.dx, (height + p.dy - 1 - p.y) / p.dy);
  return out;
}

class Inflater {
 public:
  // Raw deflate without the zlib header and checksum, which the PNG decoder does not verify either.
  Inflater() : ready_(inflateInit2(&stream_, -MAX_WBITS) == Z_OK) {}
  ~Inflater() {
    if (ready_) inflateEnd(&stream_);
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// Returns false if the bytes are not deflate data, or inflate to more than `max`.
  bool take(std::string_view bytes, std::uint64_t max) {
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream_.avail_in = uInt(bytes.size());
    int status = Z_OK;
    while (ready_ && status == Z_OK && count_ <= max) {
      std::array<Bytef, 32768> buffer;
      stream_.next_out = buffer.data();
      stream_.avail_out = uInt(buffer.size());
      status = inflate(&stream_, Z_NO_FLUSH);
      count_ += buffer.size() - stream_.avail_out;
      if (status == Z_OK && stream_.avail_in == 0 && stream_.avail_out > 0) return true;  // needs more input
    }
    ended_ = status == Z_STREAM_END;
    return ended_ || status == Z_BUF_ERROR;
  }
  bool ended() const { return ended_; }
  std::uint64_t count() const { return count_; }

 private:
  z_stream stream_{};
  std::uint64_t count_ = 0;
  bool ready_ = false, ended_ = false;
};

}  // namespace

PngRows inflatedRows(std::string_view png) {
  constexpr std::size_t kSignature = 8;
  std::optional<std::uint64_t> need;
  std::size_t frame = 2;  // zlib header bytes before the data; Apple's variant omits them
  Inflater inflater;
  for (std::size_t at = kSignature; const auto chunk = chunkAt(png, at);) {
    if (chunk->kind == "CgBI") frame = 0;
    if (chunk->kind == "IHDR" && !need) {
      need = bytesOfRows(chunk->data);
      if (!need) return PngRows::Damaged;
    }
    if (chunk->kind == "IEND" || inflater.ended()) break;
    if (chunk->kind != "IDAT") continue;
    if (!need) return PngRows::Damaged;
    const std::size_t skipped = chunk->data.size() < frame ? chunk->data.size() : frame;
    frame -= skipped;
    const std::uint64_t max = *need + kSlack_bytes;
    const bool taken = inflater.take(chunk->data.substr(skipped), max);
    if (inflater.count() > max) return PngRows::TooMany;
    if (!taken) return PngRows::Damaged;
  }
  return need ? PngRows::Fit : PngRows::Damaged;
}

}  // namespace moltact
