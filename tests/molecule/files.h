// Small files for tests, and the library's folder.
#pragma once

#include <unistd.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "engine/molecule/reader.h"

namespace moltact::test {

inline std::filesystem::path libraryFolder() { return std::filesystem::path(MOLTACT_SOURCE_DIR) / "molecules"; }

/// A temporary folder, deleted at the end of the test.
struct Scratch {
  std::filesystem::path folder;
  Scratch() {
    static int count = 0;
    folder = std::filesystem::temp_directory_path() /
             ("moltact-test-" + std::to_string(::getpid()) + '-' + std::to_string(count++));
    std::filesystem::create_directories(folder);
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
  }
  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    const auto path = folder / name;
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }
};

inline std::string contentOf(const std::filesystem::path& file) {
  std::ostringstream out;
  out << std::ifstream(file, std::ios::binary).rdbuf();
  return out.str();
}

inline std::string gzipped(const std::string& text) {
  z_stream stream{};
  deflateInit2(&stream, 6, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&stream, text.size()) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

/// The message of the problem in these bytes under this name; "" if they can be read.
inline std::string problemOf(const std::string& bytes, const std::string& name, const ReadOptions& options = {}) {
  auto molecule = readMoleculeBytes(bytes, name, options);
  return molecule ? std::string() : molecule.problem().text();
}

/// One ATOM line in the columns of the format.
inline std::string atomLine(const char* name, char alternate, const char* residue, char chain, int number,
                            char insertion, double x, double y, double z, double occupancy, const char* element,
                            const char* record = "ATOM") {
  char line[96];
  std::snprintf(line, sizeof line, "%-6s%5d %-4s%c%3s %c%4d%c   %8.3f%8.3f%8.3f%6.2f%6.2f          %2s  \n", record, 1,
                name, alternate, residue, chain, number, insertion, x, y, z, occupancy, 0.0, element);
  return line;
}

}  // namespace moltact::test
