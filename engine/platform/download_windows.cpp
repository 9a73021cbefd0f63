// Uses the system's own WinHTTP, so that nothing has to be installed.
#include <windows.h>
#include <winhttp.h>

#include <filesystem>
#include <system_error>
#include <vector>

#include "engine/platform/download.h"

namespace moltact {
namespace {

struct Closed {
  HINTERNET handle;
  ~Closed() {
    if (handle) WinHttpCloseHandle(handle);
  }
  explicit operator bool() const { return handle != nullptr; }
};

DownloadResult failed(DownloadFailure why) { return {why, std::system_category().message(int(GetLastError()))}; }

}  // namespace

DownloadResult download(const std::string& url, std::size_t max_bytes,
                        const std::function<bool(std::string_view)>& take, const std::function<bool()>& cancelled) {
  const std::wstring address = std::filesystem::path(url).wstring();
  URL_COMPONENTS parts{};
  parts.dwStructSize = sizeof parts;
  parts.dwSchemeLength = parts.dwHostNameLength = parts.dwUrlPathLength = parts.dwExtraInfoLength = DWORD(-1);
  if (!WinHttpCrackUrl(address.c_str(), 0, 0, &parts)) return failed(DownloadFailure::Refused);
  const std::wstring host(parts.lpszHostName, parts.dwHostNameLength);
  const std::wstring asked = std::wstring(parts.lpszUrlPath, parts.dwUrlPathLength) +
                             std::wstring(parts.lpszExtraInfo, parts.dwExtraInfoLength);

  constexpr int kConnect_ms = 10'000, kSilent_ms = 30'000;
  const Closed session{
      WinHttpOpen(L"moltact", WINHTTP_ACCESS_TYPE_AUTOMATIC_PROXY, WINHTTP_NO_PROXY_NAME, WINHTTP_NO_PROXY_BYPASS, 0)};
  if (!session) return failed(DownloadFailure::Offline);
  WinHttpSetTimeouts(session.handle, kConnect_ms, kConnect_ms, kSilent_ms, kSilent_ms);
  const Closed connection{WinHttpConnect(session.handle, host.c_str(), parts.nPort, 0)};
  if (!connection) return failed(DownloadFailure::Offline);
  const Closed request{WinHttpOpenRequest(connection.handle, L"GET", asked.c_str(), nullptr, WINHTTP_NO_REFERER,
                                          WINHTTP_DEFAULT_ACCEPT_TYPES,
                                          parts.nScheme == INTERNET_SCHEME_HTTPS ? WINHTTP_FLAG_SECURE : 0)};
  if (!request) return failed(DownloadFailure::Offline);
  if (cancelled && cancelled()) return {DownloadFailure::Cancelled, ""};
  if (!WinHttpSendRequest(request.handle, WINHTTP_NO_ADDITIONAL_HEADERS, 0, WINHTTP_NO_REQUEST_DATA, 0, 0, 0) ||
      !WinHttpReceiveResponse(request.handle, nullptr))
    return failed(DownloadFailure::Offline);
  DWORD status = 0, size = sizeof status;
  WinHttpQueryHeaders(request.handle, WINHTTP_QUERY_STATUS_CODE | WINHTTP_QUERY_FLAG_NUMBER,
                      WINHTTP_HEADER_NAME_BY_INDEX, &status, &size, WINHTTP_NO_HEADER_INDEX);
  if (status == 404 || status == 410) return {DownloadFailure::NotFound, std::to_string(status)};
  if (status >= 400) return {DownloadFailure::Refused, std::to_string(status)};

  std::vector<char> piece(std::size_t{64} << 10);
  for (std::size_t taken = 0;;) {
    if (cancelled && cancelled()) return {DownloadFailure::Cancelled, ""};
    DWORD got = 0;
    if (!WinHttpReadData(request.handle, piece.data(), DWORD(piece.size()), &got))
      return failed(DownloadFailure::Offline);
    if (got == 0) return {};
    taken += got;
    if (taken > max_bytes) return {DownloadFailure::TooLarge, ""};
    if (!take({piece.data(), got})) return {DownloadFailure::ConsumerStopped, ""};
  }
}

}  // namespace moltact
