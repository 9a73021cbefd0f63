#include "engine/trajectory/random_access_file.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/molecule/text_source.h"
#include "engine/platform/read_file.h"

namespace moltact {
namespace {

constexpr std::size_t kPiece_bytes = std::size_t{1} << 18;

Expected<std::string> unpacked(std::ifstream in, std::size_t size, const std::string& name) {
  const auto gzip = gzipSource(fileSource(std::move(in), size, name), name);
  std::string out;
  for (;;) {
    const std::size_t had = out.size();
    if (had > RandomAccessFile::kMaxUnpacked_bytes)
      return Problem{name, 0, 0,
                     trf("unpacked, the file is larger than {0} MB", RandomAccessFile::kMaxUnpacked_bytes >> 20),
                     tr("unpack it with gunzip")};
    out.resize(had + kPiece_bytes);
    const std::size_t n = gzip->read(out.data() + had, kPiece_bytes);
    out.resize(had + n);
    if (gzip->problem()) return *gzip->problem();
    if (n == 0) return out;
  }
}

}  // namespace

Expected<RandomAccessFile> RandomAccessFile::open(const std::filesystem::path& path) {
  Expected<OpenFile> file = openFile(path, std::numeric_limits<std::ptrdiff_t>::max(), {});
  if (!file) return file.problem();
  const std::string name = path.string();
  char first[2] = {};
  file->in.read(first, 2);
  const auto got = static_cast<std::size_t>(std::max<std::streamsize>(file->in.gcount(), 0));
  file->in.clear();
  file->in.seekg(0);
  if (!isGzip({first, got})) return RandomAccessFile(std::move(file->in), file->size, name);
  Expected<std::string> bytes = unpacked(std::move(file->in), file->size, name);
  if (!bytes) return bytes.problem();
  return RandomAccessFile(*std::move(bytes), name);
}

std::size_t RandomAccessFile::readSome(std::uint64_t at, void* to, std::size_t n) {
  if (at >= size_) return 0;
  n = static_cast<std::size_t>(std::min<std::uint64_t>(n, size_ - at));
  if (!in_.is_open()) {
    bytes_.copy(static_cast<char*>(to), n, static_cast<std::size_t>(at));
    return n;
  }
  in_.clear();
  in_.seekg(static_cast<std::streamoff>(at));
  in_.read(static_cast<char*>(to), static_cast<std::streamsize>(n));
  return static_cast<std::size_t>(std::max<std::streamsize>(in_.gcount(), 0));
}

bool RandomAccessFile::read(std::uint64_t at, void* to, std::size_t n) { return readSome(at, to, n) == n; }

void LinesFrom::seek(std::uint64_t at) {
  if (at >= begins_ && at <= begins_ + buffer_.size()) {
    used_ = static_cast<std::size_t>(at - begins_);
    return;
  }
  begins_ = at;
  used_ = 0;
  buffer_.clear();
}

bool LinesFrom::next(std::string_view& line) {
  for (;;) {
    const std::size_t end = buffer_.find('\n', used_);
    const std::size_t length = (end == std::string::npos ? buffer_.size() : end) - used_;
    if (length > kMaxLine_bytes) return false;
    if (end != std::string::npos) {
      line = std::string_view(buffer_).substr(used_, length);
      used_ = end + 1;
      if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
      return true;
    }
    begins_ += used_;
    buffer_.erase(0, used_);
    used_ = 0;
    const std::size_t had = buffer_.size();
    buffer_.resize(had + kPiece_bytes);
    const std::size_t n = file_.readSome(begins_ + had, buffer_.data() + had, kPiece_bytes);
    buffer_.resize(had + n);
    if (n > 0) continue;
    if (had == 0) return false;
    // The last line has no line feed.
    if (had > kMaxLine_bytes) return false;
    line = std::string_view(buffer_);
    used_ = had;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return true;
  }
}

}  // namespace moltact
