#include "tests/fuzz/changed.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

namespace moltact::fuzz {
namespace fs = std::filesystem;

std::vector<std::string> seedsOf(const std::string& name) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator it(fs::path(MOLTACT_SOURCE_DIR) / "tests/fuzz/seeds" / name, error), end;
       !error && it != end; it.increment(error))
    files.push_back(it->path());
  std::sort(files.begin(), files.end());
  std::vector<std::string> out;
  for (const fs::path& file : files) {
    std::ifstream in(file, std::ios::binary);
    out.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return out;
}

std::string changed(const std::vector<std::string>& seeds, std::mt19937_64& random, std::size_t longest) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % std::max<std::size_t>(n, 1)); };
  std::string out = seeds[below(seeds.size())];
  constexpr std::string_view kSigns = "0123456789 -+.eE\n\r\t'\"(),_#;:[]{}<>!`~*|\\/=%&?$";
  constexpr std::string_view kWords[] = {"nan",         "inf",   "-1",   "1e309",        "1e38",     "2147483648",
                                         "99999999999", "0x",    "\xff", "\xef\xbb\xbf", "\xe2\x82", "\n\n",
                                         "```",         "---\n", "\"\"", "null"};
  for (std::size_t n = 1 + below(8); n > 0; --n) {
    const std::size_t at = below(out.size() + 1);
    switch (below(9)) {
      case 0:
        if (at < out.size()) out[at] ^= char(1 << below(8));
        break;
      case 1:
        if (at < out.size()) out[at] = char(random());
        break;
      case 2:
        if (at < out.size()) out[at] = kSigns[below(kSigns.size())];
        break;
      case 3:
        out.insert(at, 1, kSigns[below(kSigns.size())]);
        break;
      case 4:
        out.insert(at, kWords[below(std::size(kWords))]);
        break;
      case 5:
        out.erase(at, below(2) ? below(8) : below(out.size() / 4 + 1));
        break;
      case 6: {
        const std::size_t from = below(out.size());
        out.insert(at, out.substr(from, below(200)));
        break;
      }
      case 7: {
        const std::string& other = seeds[below(seeds.size())];
        const std::size_t from = below(other.size());
        out.insert(at, other.substr(from, below(400)));
        break;
      }
      default:
        if (below(8) == 0) out.resize(at);
        break;
    }
  }
  if (out.size() > longest) out.resize(longest);
  return out;
}

unsigned long fromEnvironment(const char* name, unsigned long otherwise) {
  const char* text = std::getenv(name);
  return text ? std::strtoul(text, nullptr, 10) : otherwise;
}

}  // namespace moltact::fuzz
