// Downloads one file through libcurl. Blocks until it is done or has failed; not for the haptic thread or the window's
// thread.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace moltact {

enum class DownloadFailure { None, NotFound, Offline, Refused, TooLarge, ConsumerStopped, Cancelled };

struct DownloadResult {
  DownloadFailure failure = DownloadFailure::None;
  std::string detail;  ///< message of libcurl or the server; empty on success
};

/// Fetches `url` (https, http or file) and passes the bytes to `take` in pieces. If `take` returns false the download
/// ends with ConsumerStopped. It fails if there is no connection after 10 s, if less than 1 kB arrives within 30 s, or
/// if the file exceeds `max_bytes`. It ends with Cancelled within about a second after `cancelled` (may be empty)
/// returns true.
DownloadResult download(const std::string& url, std::size_t max_bytes,
                        const std::function<bool(std::string_view)>& take, const std::function<bool()>& cancelled = {});

}  // namespace moltact
