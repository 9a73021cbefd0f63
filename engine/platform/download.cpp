#include "engine/platform/download.h"

#include <curl/curl.h>

#include <memory>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

struct Sink {
  const std::function<bool(std::string_view)>& take;
  const std::function<bool()>& cancelled;
  std::size_t max_bytes = 0, taken = 0;
  bool too_large = false, not_taken = false, ended = false;
};

std::size_t receive(char* data, std::size_t one, std::size_t count, void* to) {
  Sink& sink = *static_cast<Sink*>(to);
  const std::size_t bytes = one * count;
  sink.taken += bytes;
  sink.too_large = sink.taken > sink.max_bytes;
  if (sink.too_large) return 0;
  sink.not_taken = !sink.take({data, bytes});
  return sink.not_taken ? 0 : bytes;
}

// Called at least once a second, also without data; a nonzero result ends the transfer.
int onProgress(void* to, curl_off_t, curl_off_t, curl_off_t, curl_off_t) {
  Sink& sink = *static_cast<Sink*>(to);
  sink.ended = sink.ended || (sink.cancelled && sink.cancelled());
  return sink.ended ? 1 : 0;
}

DownloadFailure kindOf(CURLcode code, long status, const Sink& sink) {
  if (sink.too_large) return DownloadFailure::TooLarge;
  if (sink.ended) return DownloadFailure::Cancelled;
  if (sink.not_taken) return DownloadFailure::ConsumerStopped;
  if (status == 404 || status == 410 || code == CURLE_FILE_COULDNT_READ_FILE) return DownloadFailure::NotFound;
  if (code == CURLE_HTTP_RETURNED_ERROR || code == CURLE_URL_MALFORMAT || code == CURLE_UNSUPPORTED_PROTOCOL)
    return DownloadFailure::Refused;
  return DownloadFailure::Offline;
}

}  // namespace

DownloadResult download(const std::string& url, std::size_t max_bytes,
                        const std::function<bool(std::string_view)>& take, const std::function<bool()>& cancelled) {
  static const CURLcode started = curl_global_init(CURL_GLOBAL_DEFAULT);
  const std::unique_ptr<CURL, void (*)(CURL*)> curl(started == CURLE_OK ? curl_easy_init() : nullptr,
                                                    curl_easy_cleanup);
  if (!curl) return {DownloadFailure::Refused, tr("libcurl cannot be started")};
  Sink sink{take, cancelled, max_bytes};
  char words[CURL_ERROR_SIZE] = "";
  curl_easy_setopt(curl.get(), CURLOPT_URL, url.c_str());
  curl_easy_setopt(curl.get(), CURLOPT_PROTOCOLS_STR, "https,http,file");
  curl_easy_setopt(curl.get(), CURLOPT_REDIR_PROTOCOLS_STR, "https,http");
  curl_easy_setopt(curl.get(), CURLOPT_FOLLOWLOCATION, 1L);
  curl_easy_setopt(curl.get(), CURLOPT_MAXREDIRS, 5L);
  curl_easy_setopt(curl.get(), CURLOPT_FAILONERROR, 1L);
  curl_easy_setopt(curl.get(), CURLOPT_NOSIGNAL, 1L);
  curl_easy_setopt(curl.get(), CURLOPT_CONNECTTIMEOUT, 10L);
  curl_easy_setopt(curl.get(), CURLOPT_LOW_SPEED_LIMIT, 34L);
  curl_easy_setopt(curl.get(), CURLOPT_LOW_SPEED_TIME, 30L);
  curl_easy_setopt(curl.get(), CURLOPT_USERAGENT, "moltact");
  curl_easy_setopt(curl.get(), CURLOPT_ERRORBUFFER, words);
  curl_easy_setopt(curl.get(), CURLOPT_WRITEFUNCTION, receive);
  curl_easy_setopt(curl.get(), CURLOPT_WRITEDATA, &sink);
  curl_easy_setopt(curl.get(), CURLOPT_XFERINFOFUNCTION, onProgress);
  curl_easy_setopt(curl.get(), CURLOPT_XFERINFODATA, &sink);
  curl_easy_setopt(curl.get(), CURLOPT_NOPROGRESS, 0L);
  const CURLcode code = curl_easy_perform(curl.get());
  long status = 0;
  curl_easy_getinfo(curl.get(), CURLINFO_RESPONSE_CODE, &status);
  if (code == CURLE_OK) return {};
  return {kindOf(code, status, sink), words[0] ? words : curl_easy_strerror(code)};
}

}  // namespace moltact
