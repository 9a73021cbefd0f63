// The modes and compliances of an elastic network, computed together or taken from a cache folder, where they are kept
// under a hash of the network. A file that is damaged, of another version, of another byte order or of another network
// is computed anew and replaced. Any thread except the haptic one; the calls block on the disk. Units: angstrom,
// kcal/mol.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/dynamics/normal_modes.h"

namespace moltact {

/// What is computed once for a network, for springs of stiffness 1.
struct NetworkSolution {
  NormalModes modes;
  std::vector<glm::dmat3> compliances;  ///< of each node
};

/// The `count` lowest modes (fewer if the network has fewer) and the compliances. `progress` is called with the finished
/// fraction and returns false to cancel, which is a Problem, as are those of lowestModes().
Expected<NetworkSolution> solved(const ElasticNetwork& network, std::size_t count,
                                 const std::function<bool(double)>& progress = {});

/// The content of a file with the solution.
std::string bytesOf(const NetworkSolution& solution, const ElasticNetwork& network, std::size_t count);
/// The solution in such a content; empty if the content is not complete and unchanged, or not of `count` modes of this
/// network.
std::optional<NetworkSolution> solutionIn(std::string_view bytes, const ElasticNetwork& network, std::size_t count);

/// The largest number of files that the folder keeps; the oldest go first. A file has at most 1.2 MB.
inline constexpr std::size_t kMaxKeptSolutions = 100;
/// The file of a network in the cache folder.
std::filesystem::path solutionFile(const std::filesystem::path& folder, const ElasticNetwork& network,
                                   std::size_t count);
/// As solved(), or from the folder; what is computed is kept there. An empty `folder` keeps nothing. A folder that cannot
/// be written is no problem.
Expected<NetworkSolution> keptOrSolved(const ElasticNetwork& network, std::size_t count,
                                       const std::filesystem::path& folder,
                                       const std::function<bool(double)>& progress = {});

}  // namespace moltact
