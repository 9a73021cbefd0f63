// HID devices of a page: WebHID, if the browser supports it. app/web/devices.js manages the devices that the user has
// selected (Module.hid): it opens them, reads their descriptions and queues their reports for each port. The report id
// is the first byte, as in hidapi.
#include <emscripten.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/device/driver.h"
#include "engine/device/hid/hid_port.h"
#include "engine/language/catalogue.h"

// The following functions are JavaScript.
// clang-format off
EM_JS(int, hidIsThere, (void), { return Module.hid.there() ? 1 : 0; })
EM_JS(void, hidAsk, (void), { Module.hid.ask(); })
// JSON of [{path, title, vendor, product, usage_page, usage}, …]; the caller frees it.
EM_JS(char*, hidList, (void), {
  const text = Module.hid.list();
  const size = lengthBytesUTF8(text) + 1;
  const at = _malloc(size);
  stringToUTF8(text, at, size);
  return at;
})
EM_JS(int, hidOpen, (const char* path), { return Module.hid.open(UTF8ToString(path)); })
EM_JS(void, hidClose, (int port), { Module.hid.close(port); })
EM_JS(int, hidRead, (int port, void* to, int max_bytes), {
  const report = Module.hid.read(port);
  if (!report) return report === null ? 0 : -1;
  const bytes = report.subarray(0, max_bytes);
  HEAPU8.set(bytes, to);
  return bytes.length;
})
EM_JS(int, hidFeature, (int port, void* to, int max_bytes), {
  const report = Module.hid.feature(port, HEAPU8[to]);
  if (!report) return -1;
  const bytes = report.subarray(0, max_bytes);
  HEAPU8.set(bytes, to);
  return bytes.length;
})
EM_JS(int, hidWrite, (int port, const void* from, int size), {
  return Module.hid.write(port, HEAPU8.slice(from, from + size)) ? 1 : 0;
})
EM_JS(void, hidLast, (int port, const void* from, int size), {
  Module.hid.last(port, HEAPU8.slice(from, from + size));
})
// clang-format on

namespace moltact {
namespace {

class PagePort final : public PacketPort {
 public:
  explicit PagePort(int port) : port_(port) {}
  ~PagePort() override { hidClose(port_); }
  PagePort(const PagePort&) = delete;
  PagePort& operator=(const PagePort&) = delete;

  int read(std::span<std::uint8_t> report, int) override { return hidRead(port_, report.data(), int(report.size())); }
  bool write(std::span<const std::uint8_t> report) override {
    return hidWrite(port_, report.data(), int(report.size())) != 0;
  }
  int feature(std::span<std::uint8_t> report) override { return hidFeature(port_, report.data(), int(report.size())); }
  // The page sends it when the device is closed or the page is left.
  void lastReport(std::span<const std::uint8_t> report) override { hidLast(port_, report.data(), int(report.size())); }

 private:
  int port_;
};

// Device strings are shown unchanged, except for characters that are not plain text.
std::string plain(std::string text) {
  for (char& c : text) c = c >= 32 && c < 127 ? c : '?';
  return text;
}

}  // namespace

std::vector<HidEntry> listHid() {
  char* const text = hidList();
  const nlohmann::json all = nlohmann::json::parse(text, nullptr, false);
  std::free(text);
  std::vector<HidEntry> out;
  if (!all.is_array()) return out;
  for (const nlohmann::json& one : all)
    out.push_back({.path = one.value("path", ""),
                   .title = plain(one.value("title", "")),
                   .vendor = one.value("vendor", std::uint16_t{0}),
                   .product = one.value("product", std::uint16_t{0}),
                   .usage_page = one.value("usage_page", std::uint16_t{0}),
                   .usage = one.value("usage", std::uint16_t{0})});
  return out;
}

Expected<std::unique_ptr<PacketPort>> openHid(const HidEntry& entry) {
  const int port = hidOpen(entry.path.c_str());
  if (port < 0)
    return Problem{"", 0, 0, trf("{0} cannot be opened ({1})", entry.title, tr("the browser does not reach it")),
                   tr("close other programs that use it, then plug it in again")};
  return std::unique_ptr<PacketPort>(std::make_unique<PagePort>(port));
}

bool devicesAreAskedFor() noexcept { return hidIsThere() != 0; }
void askForDevice() { hidAsk(); }

}  // namespace moltact
