// Assembles zips byte by byte after PKWARE's APPNOTE 6.3, without libzip: also malicious ones.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <vector>

namespace moltact::test {

struct ZipEntry {
  std::string name, bytes;
  bool deflated = false;
  std::uint32_t unix_mode = 0;  ///< 0: not given
  bool encrypted = false;
  int method = -1;                ///< given instead of the true one; negative: the true one
  std::int64_t header_size = -1;  ///< the same
  bool wrong_checksum = false;
};

inline std::string deflated(const std::string& bytes) {
  z_stream z{};
  deflateInit2(&z, 9, Z_DEFLATED, -MAX_WBITS, 9, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&z, uLong(bytes.size())), '\0');
  z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  z.avail_in = uInt(bytes.size());
  z.next_out = reinterpret_cast<Bytef*>(out.data());
  z.avail_out = uInt(out.size());
  deflate(&z, Z_FINISH);
  out.resize(z.total_out);
  deflateEnd(&z);
  return out;
}

inline std::string little(std::uint64_t value, int bytes) {
  std::string out;
  for (int k = 0; k < bytes; ++k) out += char(value >> (8 * k) & 0xFF);
  return out;
}

inline std::string zipOf(const std::vector<ZipEntry>& entries) {
  std::string body, directory;
  for (const ZipEntry& e : entries) {
    // Traditional encryption prepends 12 bytes to a file.
    const std::string packed = std::string(e.encrypted ? 12 : 0, 'k') + (e.deflated ? deflated(e.bytes) : e.bytes);
    const std::uint64_t size = e.header_size >= 0 ? std::uint64_t(e.header_size) : e.bytes.size();
    const auto checksum =
        crc32(0, reinterpret_cast<const Bytef*>(e.bytes.data()), uInt(e.bytes.size())) ^ (e.wrong_checksum ? 1u : 0u);
    const int method = e.method >= 0 ? e.method : e.deflated ? 8 : 0;
    const std::string common = little(20, 2) + little(e.encrypted ? 1 : 0, 2) + little(std::uint64_t(method), 2) +
                               little(0, 2) + little(0x21, 2) + little(checksum, 4) + little(packed.size(), 4) +
                               little(size, 4) + little(e.name.size(), 2) + little(0, 2);
    directory += "PK\1\2" + little(3 << 8 | 20, 2) + common + little(0, 2) + little(0, 2) + little(0, 2) +
                 little(std::uint64_t(e.unix_mode) << 16, 4) + little(body.size(), 4) + e.name;
    body += "PK\3\4" + common + e.name + packed;
  }
  return body + directory + "PK\5\6" + little(0, 4) + little(entries.size(), 2) + little(entries.size(), 2) +
         little(directory.size(), 4) + little(body.size(), 4) + little(0, 2);
}

inline const std::string kManifest = "{\"format\": 1, \"lesson\": \"l.md\"}";
inline const std::string kSmallLesson =
    "---\ntitle: Small\nminutes: 1\ngoals: G\nmolecules: argon\nauthor: A\nlicence: L\n---\n"
    "## One\n```scene\nmolecule: argon\n```\nText.\n";

/// A valid pack with additional entries.
inline std::string packWith(std::vector<ZipEntry> more = {}) {
  std::vector<ZipEntry> all{{"pack.json", kManifest}, {"l.md", kSmallLesson}};
  all.insert(all.end(), more.begin(), more.end());
  return zipOf(all);
}

}  // namespace moltact::test
