#include "engine/molecule/inflate.h"

#include <zlib.h>

#include <algorithm>
#include <memory>

namespace moltact {

bool isGzip(std::string_view bytes) { return bytes.size() >= 2 && bytes[0] == '\x1f' && bytes[1] == '\x8b'; }

Expected<std::string> inflateGzip(std::string_view bytes, std::size_t most, const std::string& file) {
  constexpr const char* kRemedy = "copy or download the file again";
  constexpr int kGzipOnly = 16 + MAX_WBITS;
  constexpr std::size_t kStep = std::size_t{1} << 18;
  z_stream stream{};
  if (inflateInit2(&stream, kGzipOnly) != Z_OK)
    return Problem{file, 0, 0, "it cannot be unpacked: no memory", ""};
  const std::unique_ptr<z_stream, int (*)(z_stream*)> closing(&stream, inflateEnd);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());  // a file is at most 1 GiB
  std::string out;
  for (;;) {
    const std::size_t had = out.size();
    out.resize(had + kStep);
    stream.next_out = reinterpret_cast<Bytef*>(out.data() + had);
    stream.avail_out = static_cast<uInt>(kStep);
    const int status = inflate(&stream, Z_NO_FLUSH);
    out.resize(out.size() - stream.avail_out);
    if (out.size() > most)
      return Problem{file, 0, 0, "it unpacks to more than " + std::to_string(most >> 20) + " MiB",
                     "split it, or keep one model"};
    if (status == Z_STREAM_END) {
      if (!isGzip({reinterpret_cast<const char*>(stream.next_in), stream.avail_in})) return out;
      inflateReset(&stream);
    } else if (status != Z_OK) {
      const bool cut = status == Z_BUF_ERROR && stream.avail_in == 0;
      return Problem{file, 0, 0, cut ? "the gzip file is cut short" : "the gzip file is damaged", kRemedy};
    } else if (stream.avail_in == 0 && stream.avail_out != 0) {
      return Problem{file, 0, 0, "the gzip file is cut short", kRemedy};
    }
  }
}

}  // namespace moltact
