#include "engine/dynamics/network_solution.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <system_error>
#include <utility>

#include "engine/core/content_hash.h"
#include "engine/core/file_bytes.h"
#include "engine/language/catalogue.h"
#include "engine/platform/read_file.h"
#include "engine/platform/write_file.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

// Increase the number when modes or compliances of the same network change.
constexpr std::string_view kMagic = "moltact modes 1\n";
constexpr std::uint32_t kByteOrder = 0x01020304u;
constexpr std::size_t kMaxSolutionBytes = std::size_t{4} << 20;

template <class Number>
void appendNumber(std::string& out, Number number) {
  const auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  out.append(bytes.data(), bytes.size());
}

// A hash of everything that the solution depends on.
std::uint64_t hashOf(const ElasticNetwork& network, std::size_t count) {
  std::string all(kMagic);
  appendNumber(all, kByteOrder);
  appendNumber(all, std::uint64_t(count));
  appendNumber(all, std::uint64_t(network.nodes().size()));
  for (std::size_t i = 0; i < network.nodes().size(); ++i)
    for (int c = 0; c < 3; ++c) appendNumber(all, double(network.place_A(i)[c]));
  for (const auto& [a, b] : network.springs()) appendNumber(all, a), appendNumber(all, b);
  return hash64(all);
}

// Takes numbers from the front of a content; the caller has compared the sizes.
class Numbers {
 public:
  explicit Numbers(std::string_view bytes) : bytes_(bytes) {}
  template <class Number>
  Number next() {
    const Number out = numberAt<Number>(bytes_.data());
    bytes_.remove_prefix(sizeof(Number));
    return out;
  }

 private:
  std::string_view bytes_;
};

// Deletes all but the newest files.
void keepNewest(const fs::path& folder) {
  std::error_code error;
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (it->path().extension() == ".modes") files.emplace_back(it->last_write_time(error), it->path());
  if (files.size() <= kMaxKeptSolutions) return;
  std::sort(files.begin(), files.end());
  for (std::size_t k = 0; k < files.size() - kMaxKeptSolutions; ++k) fs::remove(files[k].second, error);
}

}  // namespace

Expected<NetworkSolution> solved(const ElasticNetwork& network, std::size_t count,
                                 const std::function<bool(double)>& progress) {
  NetworkSolution out;
  auto modes = lowestModes(network, count);
  if (!modes) return modes.problem();
  out.modes = *std::move(modes);
  out.compliances = nodeCompliances(network, progress);
  if (out.compliances.empty()) return Problem{{}, 0, 0, tr("the calculation was cancelled"), {}};
  return out;
}

std::string bytesOf(const NetworkSolution& solution, const ElasticNetwork& network, std::size_t count) {
  std::string out(kMagic);
  appendNumber(out, kByteOrder);
  appendNumber(out, std::uint32_t(solution.modes.count()));
  appendNumber(out, hashOf(network, count));
  for (const double e : solution.modes.eigenvalues) appendNumber(out, e);
  for (const Vec3& v : solution.modes.vectors)
    for (int c = 0; c < 3; ++c) appendNumber(out, double(v[c]));
  for (const glm::dmat3& m : solution.compliances)
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r) appendNumber(out, double(m[c][r]));
  appendNumber(out, hash64(out));
  return out;
}

std::optional<NetworkSolution> solutionIn(std::string_view bytes, const ElasticNetwork& network, std::size_t count) {
  constexpr std::size_t kHead = kMagic.size() + 2 * sizeof(std::uint32_t) + sizeof(std::uint64_t);
  constexpr std::size_t kCheck = sizeof(std::uint64_t);
  if (bytes.size() < kHead + kCheck || !bytes.starts_with(kMagic)) return {};
  const std::string_view body = bytes.substr(0, bytes.size() - kCheck);
  if (numberAt<std::uint64_t>(body.data() + body.size()) != hash64(body)) return {};
  Numbers in(body.substr(kMagic.size()));
  if (in.next<std::uint32_t>() != kByteOrder) return {};
  const std::size_t nodes = network.nodes().size(), modes = in.next<std::uint32_t>();
  if (in.next<std::uint64_t>() != hashOf(network, count) || modes < 1 || modes > std::min(count, 3 * nodes - 6))
    return {};
  if (body.size() != kHead + sizeof(double) * (modes + 3 * modes * nodes + 9 * nodes)) return {};
  NetworkSolution out;
  out.modes.nodes = nodes;
  bool valid = true;
  const auto number = [&] {
    const double x = in.next<double>();
    valid = valid && std::isfinite(x);
    return x;
  };
  for (std::size_t k = 0; k < modes; ++k) {
    out.modes.eigenvalues.push_back(number());
    valid =
        valid && out.modes.eigenvalues[k] > 0.0 && (k == 0 || out.modes.eigenvalues[k - 1] <= out.modes.eigenvalues[k]);
  }
  out.modes.vectors.resize(modes * nodes);
  for (Vec3& v : out.modes.vectors)
    for (int c = 0; c < 3; ++c) v[c] = number();
  out.compliances.resize(nodes);
  for (glm::dmat3& m : out.compliances)
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r) m[c][r] = number();
  if (!valid) return {};
  return out;
}

fs::path solutionFile(const fs::path& folder, const ElasticNetwork& network, std::size_t count) {
  std::string name;
  appendNumber(name, hashOf(network, count));
  return folder / ("network-" + contentHash(name) + ".modes");
}

Expected<NetworkSolution> keptOrSolved(const ElasticNetwork& network, std::size_t count, const fs::path& folder,
                                       const std::function<bool(double)>& progress) {
  if (folder.empty()) return solved(network, count, progress);
  const fs::path file = solutionFile(folder, network, count);
  std::error_code ignored;
  if (fs::exists(file, ignored))
    if (const Expected<std::string> bytes = readFile(file, kMaxSolutionBytes, ""))
      if (auto kept = solutionIn(*bytes, network, count)) return *std::move(kept);
  Expected<NetworkSolution> out = solved(network, count, progress);
  if (!out) return out;
  fs::create_directories(folder, ignored);
  // A failure to write, for example on a full disk, only costs time later.
  if (!writeWhole(file, bytesOf(*out, network, count), IfThere::Renew)) keepNewest(folder);
  return out;
}

}  // namespace moltact
