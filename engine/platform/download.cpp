#include "engine/platform/download.h"

#include <curl/curl.h>

#include <fstream>
#include <memory>

namespace moltact {
namespace {

struct Sink {
  std::ofstream out;
  std::size_t written = 0, most = 0;
  bool too_large = false;
};

std::size_t receive(char* data, std::size_t one, std::size_t count, void* to) {
  Sink& sink = *static_cast<Sink*>(to);
  const std::size_t bytes = one * count;
  sink.written += bytes;
  if (sink.written > sink.most) {
    sink.too_large = true;
    return 0;
  }
  return sink.out.write(data, static_cast<std::streamsize>(bytes)) ? bytes : 0;
}

DownloadFailure kindOf(CURLcode code, long status, const Sink& sink) {
  if (sink.too_large) return DownloadFailure::TooLarge;
  if (code == CURLE_WRITE_ERROR) return DownloadFailure::CannotWrite;
  if (status == 404 || status == 410 || code == CURLE_FILE_COULDNT_READ_FILE)
    return DownloadFailure::NotFound;
  if (code == CURLE_HTTP_RETURNED_ERROR || code == CURLE_URL_MALFORMAT || code == CURLE_UNSUPPORTED_PROTOCOL)
    return DownloadFailure::Refused;
  return DownloadFailure::Offline;
}

}  // namespace

DownloadResult download(const std::string& url, const std::filesystem::path& file, std::size_t most_bytes) {
  static const CURLcode started = curl_global_init(CURL_GLOBAL_DEFAULT);
  const std::unique_ptr<CURL, void (*)(CURL*)> curl(started == CURLE_OK ? curl_easy_init() : nullptr,
                                                    curl_easy_cleanup);
  if (!curl) return {DownloadFailure::Refused, "libcurl cannot be started"};
  Sink sink;
  sink.most = most_bytes;
  sink.out.open(file, std::ios::binary | std::ios::trunc);
  if (!sink.out) return {DownloadFailure::CannotWrite, "the file cannot be created"};
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
  const CURLcode code = curl_easy_perform(curl.get());
  long status = 0;
  curl_easy_getinfo(curl.get(), CURLINFO_RESPONSE_CODE, &status);
  sink.out.close();
  if (code == CURLE_OK && sink.out) return {};
  if (code == CURLE_OK) return {DownloadFailure::CannotWrite, "the disk may be full"};
  return {kindOf(code, status, sink), words[0] ? words : curl_easy_strerror(code)};
}

}  // namespace moltact
