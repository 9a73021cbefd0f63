#include "engine/molecule/text_source.h"

#include <zlib.h>

#include <algorithm>
#include <cstring>

#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/platform/read_file.h"

namespace moltact {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 18;

class Memory final : public ByteSource {
 public:
  explicit Memory(std::string_view bytes) : bytes_(bytes) {}
  std::size_t read(char* to, std::size_t max_bytes) override {
    const std::size_t n = bytes_.copy(to, max_bytes);
    bytes_.remove_prefix(n);
    return n;
  }

 private:
  std::string_view bytes_;
};

class File final : public ByteSource {
 public:
  File(std::ifstream in, std::size_t size, std::string name)
      : in_(std::move(in)), size_(size), name_(std::move(name)) {}
  std::size_t read(char* to, std::size_t max_bytes) override {
    max_bytes = std::min(max_bytes, size_ - taken_);  // data appended to the file meanwhile are ignored
    if (max_bytes == 0) return 0;
    in_.read(to, static_cast<std::streamsize>(max_bytes));
    const auto n = static_cast<std::size_t>(std::max<std::streamsize>(in_.gcount(), 0));
    taken_ += n;
    if (n == 0) problem_ = brokenOff(name_, taken_);
    return n;
  }

 private:
  std::ifstream in_;
  std::size_t size_, taken_ = 0;
  std::string name_;
};

class Gzip final : public ByteSource {
 public:
  Gzip(std::unique_ptr<ByteSource> packed, std::string name) : packed_(std::move(packed)), name_(std::move(name)) {
    constexpr int kGzipOnly = 16 + MAX_WBITS;
    if (inflateInit2(&stream_, kGzipOnly) != Z_OK) throw std::bad_alloc();
  }
  ~Gzip() override { inflateEnd(&stream_); }
  Gzip(const Gzip&) = delete;
  Gzip& operator=(const Gzip&) = delete;

  std::size_t read(char* to, std::size_t max_bytes) override {
    while (!ended_ && !problem_) {
      if (stream_.avail_in < 2) refill();
      stream_.next_out = reinterpret_cast<Bytef*>(to);
      stream_.avail_out = static_cast<uInt>(std::min(max_bytes, kPiece));
      const uInt room = stream_.avail_out;
      const int status = inflate(&stream_, Z_NO_FLUSH);
      const std::size_t n = room - stream_.avail_out;
      if (status == Z_STREAM_END) {
        if (stream_.avail_in < 2) refill();
        // Data after a member that are not another member are ignored, as in gzip.
        const bool more = stream_.avail_in >= 2 && stream_.next_in[0] == 0x1f && stream_.next_in[1] == 0x8b;
        if (more)
          inflateReset(&stream_);
        else
          ended_ = true;
      } else if (status == Z_BUF_ERROR || (status == Z_OK && n == 0 && stream_.avail_in == 0)) {
        if (packed_ended_) problem_ = broken(tr("the gzip file is cut short"));
      } else if (status != Z_OK) {
        problem_ = broken(tr("the gzip file is damaged"));
      }
      if (n > 0) return n;
    }
    return 0;
  }
  std::size_t packedBytesRead() const override { return taken_ - std::min<std::size_t>(stream_.avail_in, taken_); }

 private:
  Problem broken(const char* how) const { return {name_, 0, 0, how, tr("copy or download the file again")}; }

  // Reads the next compressed bytes; at most one is left over from before.
  void refill() {
    if (packed_ended_) return;
    const uInt left = stream_.avail_in;
    if (left) in_[0] = static_cast<char>(*stream_.next_in);
    const std::size_t n = packed_->read(in_ + left, sizeof in_ - left);
    packed_ended_ = n == 0;
    if (packed_->problem()) problem_ = packed_->problem();
    stream_.next_in = reinterpret_cast<Bytef*>(in_);
    stream_.avail_in = left + static_cast<uInt>(n);
    taken_ += n;
  }

  std::unique_ptr<ByteSource> packed_;
  std::string name_;
  z_stream stream_{};
  char in_[1 << 16] = {};
  std::size_t taken_ = 0;
  bool packed_ended_ = false, ended_ = false;
};

// A first piece that was read to detect the format, then the rest.
class Seen final : public ByteSource {
 public:
  Seen(std::string first, std::unique_ptr<ByteSource> rest) : first_(std::move(first)), rest_(std::move(rest)) {}
  std::size_t read(char* to, std::size_t max_bytes) override {
    if (at_ < first_.size()) {
      const std::size_t n = first_.copy(to, max_bytes, at_);
      at_ += n;
      return n;
    }
    const std::size_t n = rest_->read(to, max_bytes);
    problem_ = rest_->problem();
    return n;
  }

 private:
  std::string first_;
  std::size_t at_ = 0;
  std::unique_ptr<ByteSource> rest_;
};

}  // namespace

std::unique_ptr<ByteSource> memorySource(std::string_view bytes) { return std::make_unique<Memory>(bytes); }
std::unique_ptr<ByteSource> fileSource(std::ifstream in, std::size_t size, const std::string& name) {
  return std::make_unique<File>(std::move(in), size, name);
}
std::unique_ptr<ByteSource> gzipSource(std::unique_ptr<ByteSource> packed, const std::string& name) {
  return std::make_unique<Gzip>(std::move(packed), name);
}

bool isGzip(std::string_view bytes) { return bytes.size() >= 2 && bytes[0] == '\x1f' && bytes[1] == '\x8b'; }

TextSource::TextSource(std::unique_ptr<ByteSource> bytes, std::size_t expected, std::size_t max_bytes, std::string file)
    : expected_(std::min(expected, max_bytes)), max_bytes_(max_bytes), file_(std::move(file)) {
  std::string first(2, '\0');
  std::size_t n = bytes->read(first.data(), 2);
  if (n == 1) n += bytes->read(first.data() + 1, 1);
  first.resize(n);
  problem_ = bytes->problem();
  packed_ = isGzip(first);
  bytes_ = std::make_unique<Seen>(std::move(first), std::move(bytes));
  if (!packed_) return;
  packed_bytes_ = expected_;
  constexpr std::size_t kUsual = 4;  // atom records compress to about a fourth
  expected_ = expected_ < max_bytes_ / kUsual ? expected_ * kUsual : max_bytes_;
  bytes_ = gzipSource(std::move(bytes_), file_);
}

std::size_t TextSource::expectedBytes() const {
  const std::size_t packed_read = bytes_->packedBytesRead();
  if (packed_read == 0) return expected_;
  const double likely = double(packed_bytes_) * (double(taken_) / double(packed_read));
  return static_cast<std::size_t>(std::clamp(likely, double(std::min(taken_, max_bytes_)), double(max_bytes_)));
}

bool TextSource::fill() {
  if (ended_ || problem_) return false;
  if (at_ > 0 && (at_ == end_ || at_ >= kPiece)) {
    std::memmove(buffer_.data(), buffer_.data() + at_, end_ - at_);
    end_ -= at_;
    at_ = 0;
  }
  // Small files need no large buffer.
  const std::size_t piece = std::clamp(expected_, std::size_t{4096}, kPiece);
  if (buffer_.size() - end_ < piece) buffer_.resize(std::max(buffer_.size() + buffer_.size() / 2, end_ + piece));
  const std::size_t n = bytes_->read(buffer_.data() + end_, piece);
  if (bytes_->problem()) problem_ = bytes_->problem();
  ended_ = n == 0;
  end_ += n;
  taken_ += n;
  if (taken_ > max_bytes_)
    problem_ = Problem{file_, 0, 0,
                       packed_ ? trf("it unpacks to more than {0} MiB", max_bytes_ >> 20)
                               : trf("it is larger than {0} MiB", max_bytes_ >> 20),
                       tr("split it, or keep one model")};
  return n > 0 && !problem_;
}

bool TextSource::next(std::string_view& line) {
  std::size_t workCount = 0;
  for (;;) {
    const std::string_view there(buffer_.data() + at_, end_ - at_);
    const std::size_t newline = there.find('\n', workCount);
    if (newline != std::string_view::npos) {
      line = there.substr(0, newline);
      at_ += newline + 1;
      break;
    }
    workCount = there.size();
    if (workCount > kMaxMoleculeLineBytes) {
      problem_ = Problem{file_, number_ + 1, 0, tr("the line is longer than 16 MiB"), tr("is this a molecule's file?")};
      return false;
    }
    if (fill()) continue;
    if (problem_ || at_ == end_) return false;
    line = {buffer_.data() + at_, end_ - at_};
    at_ = end_;
    break;
  }
  ++number_;
  given_ += line.size() + 1;
  blank_ = blank_ && trimmed(line).empty();
  return true;
}

bool TextSource::bytes(std::size_t most, std::string& out) {
  if (at_ == end_ && !fill()) return false;
  const std::size_t count = std::min(most, end_ - at_);
  out.append(buffer_, at_, count);
  at_ += count;
  given_ += count;
  blank_ = false;
  return true;
}

std::string_view TextSource::ahead() {
  constexpr std::size_t kLook = 1 << 16;
  while (end_ - at_ < kLook && fill()) {
  }
  return std::string_view(buffer_.data() + at_, end_ - at_).substr(0, kLook);
}

}  // namespace moltact
