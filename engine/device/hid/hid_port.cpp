#include "engine/device/hid/hid_port.h"

#include <hidapi/hidapi.h>

#include <mutex>
#include <utility>

#include "engine/device/driver.h"
#include "engine/language/catalogue.h"
#include "engine/platform/force_inhibit.h"

namespace moltact {
namespace {

// hidapi's global functions are not thread-safe.
std::mutex& globalHid() {
  static std::mutex one;
  return one;
}

// Device strings are shown unchanged, except for characters that are not plain text.
std::string plain(const wchar_t* text) {
  std::string out;
  for (; text && *text; ++text) out += *text >= 32 && *text < 127 ? static_cast<char>(*text) : '?';
  return out;
}

class RealPort final : public PacketPort {
 public:
  RealPort(hid_device* device, std::string path) : device_(device), path_(std::move(path)) {}
  ~RealPort() override { hid_close(device_); }
  int read(std::span<std::uint8_t> report, int wait_ms) override {
    return hid_read_timeout(device_, report.data(), report.size(), wait_ms);
  }
  bool write(std::span<const std::uint8_t> report) override {
    return hid_write(device_, report.data(), report.size()) >= 0;
  }
  int feature(std::span<std::uint8_t> report) override {
    return hid_get_feature_report(device_, report.data(), report.size());
  }
  // A hidraw node accepts the same bytes as hidapi.
  void lastReport(std::span<const std::uint8_t> report) override { last_report_.arm(path_.c_str(), report); }

 private:
  hid_device* device_;
  std::string path_;
  LastReport last_report_;
};

}  // namespace

std::vector<HidEntry> listHid() {
  const std::lock_guard lock(globalHid());
  std::vector<HidEntry> out;
  hid_device_info* const all = hid_enumerate(0, 0);
  for (const hid_device_info* one = all; one; one = one->next) {
    HidEntry entry;
    entry.path = one->path ? one->path : "";
    const std::string maker = plain(one->manufacturer_string), product = plain(one->product_string);
    entry.title = maker.empty() || product.empty() ? maker + product : maker + ' ' + product;
    entry.serial = plain(one->serial_number);
    entry.vendor = one->vendor_id;
    entry.product = one->product_id;
    entry.usage_page = one->usage_page;
    entry.usage = one->usage;
    out.push_back(std::move(entry));
  }
  hid_free_enumeration(all);
  return out;
}

Expected<std::unique_ptr<PacketPort>> openHid(const HidEntry& entry) {
  const std::lock_guard lock(globalHid());
  hid_device* const device = hid_open_path(entry.path.c_str());
  if (!device)
    return Problem{
        "", 0, 0, trf("{0} cannot be opened ({1})", entry.path, plain(hid_error(nullptr))),
        tr("give yourself the right to it with the udev rule in docs/devices.md, then plug the device in again")};
  return std::unique_ptr<PacketPort>(std::make_unique<RealPort>(device, entry.path));
}

bool devicesAreAskedFor() noexcept { return false; }
void askForDevice() {}

}  // namespace moltact
