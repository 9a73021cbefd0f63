// Downloads one file through libcurl. Blocks until done or given up; not for the haptic thread nor the
// window's.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace moltact {

enum class DownloadFailure { None, NotFound, Offline, Refused, TooLarge, ConsumerStopped, Cancelled };

struct DownloadResult {
  DownloadFailure failure = DownloadFailure::None;
  std::string detail;  ///< in libcurl's or the server's words; empty on success
};

/// Fetches `url` (https, http or file) and passes the bytes to `take`, piece by piece; where `take` returns false the
/// download ends with ConsumerStopped. Gives up when there is no connection after 10 s, when less than 1 kB arrives
/// within 30 s, or when more than `most_bytes` come. Ends with Cancelled within about a second after `cancelled` (may
/// be empty) returns true.
DownloadResult download(const std::string& url, std::size_t most_bytes,
                        const std::function<bool(std::string_view)>& take, const std::function<bool()>& cancelled = {});

}  // namespace moltact
