// Downloads one file through libcurl. Blocks until done or given up; not for the haptic thread nor the
// window's.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "engine/core/problem.h"

namespace moltact {

enum class DownloadFailure { None, NotFound, Offline, Refused, TooLarge, CannotWrite };

struct DownloadResult {
  DownloadFailure failure = DownloadFailure::None;
  std::string detail;  ///< in libcurl's or the server's words; empty on success
};

/// Fetches `url` (https, http or file) into `file`, which is written anew. Gives up when no connection stands
/// after 10 s, when less than 1 kB arrives within 30 s, or when more than `most_bytes` come.
DownloadResult download(const std::string& url, const std::filesystem::path& file, std::size_t most_bytes);

}  // namespace moltact
