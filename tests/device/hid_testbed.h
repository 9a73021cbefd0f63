// A HID device mocked by umockdev for the real libhidapi: its entry in the system, its descriptor and feature report,
// and the device's end of the connection. Runs under umockdev-wrapper. The node is a terminal, not a hidraw device:
// consecutive reports may arrive together, so `send` waits until each has been read. Test's thread; another thread
// answers ioctls.
#pragma once

#include <doctest/doctest.h>
#include <fcntl.h>
#include <glib.h>
#include <sys/ioctl.h>
#include <umockdev.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace moltact::test {

using Bytes = std::vector<std::uint8_t>;

/// A report descriptor: usage page, usage, one empty collection.
inline Bytes hidDescriptor(unsigned page, unsigned usage) {
  return {0x06, std::uint8_t(page), std::uint8_t(page >> 8), 0x09, std::uint8_t(usage), 0xA1, 0x01, 0xC0};
}

struct MockedHid {
  const char* vendor;   ///< "256F", upper case
  const char* product;  ///< "C635"
  const char* name;     ///< "3Dconnexion SpaceMouse Compact": the first word is the vendor
  Bytes descriptor;
  Bytes feature = {};  ///< the contents of the feature report of its first byte; empty: no such report
};

class HidTestbed {
 public:
  HidTestbed() : bed_(umockdev_testbed_new()) {}
  ~HidTestbed() {
    unplug();
    g_object_unref(bed_);
  }
  HidTestbed(const HidTestbed&) = delete;
  HidTestbed& operator=(const HidTestbed&) = delete;

  void plug(const MockedHid& device) {
    device_ = device;
    ++plugged_;
    GError* error = nullptr;
    const bool added = umockdev_testbed_add_from_string(bed_, listed().c_str(), &error);
    REQUIRE_MESSAGE(added, (error ? error->message : ""));
    handler_ = umockdev_ioctl_base_new();
    g_signal_connect(handler_, "handle-ioctl", G_CALLBACK(&HidTestbed::answer), this);
    const bool attached = umockdev_testbed_attach_ioctl(bed_, node().c_str(), handler_, &error);
    REQUIRE_MESSAGE(attached, (error ? error->message : ""));
    far_end_ = umockdev_testbed_get_dev_fd(bed_, node().c_str());
    REQUIRE(far_end_ >= 0);
    fcntl(far_end_, F_SETFL, O_NONBLOCK);
    near_end_ = open(ptsname(far_end_), O_RDWR | O_NOCTTY);
    REQUIRE(near_end_ >= 0);
  }

  /// "/dev/hidraw0"; the number differs each time that a device is plugged in.
  std::string node() const { return "/dev/" + raw(); }

  /// Removes the device from the list; open handles read an error from now on.
  void unplug() {
    if (far_end_ < 0) return;
    close(near_end_);
    umockdev_testbed_detach_ioctl(bed_, node().c_str(), nullptr);
    // The node first, then its parents.
    const std::string usb = std::string("/sys") + kUsb, interface = usb + "/1-1:1.0", hid = interface + '/' + hidName();
    for (const std::string& path : {hid + "/hidraw/" + raw(), hid, interface, usb})
      umockdev_testbed_remove_device(bed_, path.c_str());
    // umockdev keeps the other end of the terminal; closing it hangs up on readers of the node.
    const int nothing = open("/dev/null", O_RDWR);
    dup2(nothing, far_end_);
    close(nothing);
    g_object_unref(handler_);
    far_end_ = -1;
  }

  /// Sends a report and waits up to a second until it has been read. The system may still join it to the previous one,
  /// so a test repeats what it relies on.
  void send(const Bytes& report) {
    const auto size = static_cast<ssize_t>(report.size());
    REQUIRE(write(far_end_, report.data(), report.size()) == size);
    std::this_thread::sleep_for(std::chrono::microseconds(500));  // a terminal passes data on with a delay
    for (int k = 0; k < 10'000 && unread() > 0; ++k) std::this_thread::sleep_for(std::chrono::microseconds(100));
    CHECK(unread() == 0);
  }

  /// Sends without waiting, for a reader in another process.
  void sendAtOnce(const Bytes& report) {
    if (unread() == 0) (void)!write(far_end_, report.data(), report.size());
  }

  /// Returns all data written to the device since the last call.
  Bytes written() {
    Bytes out(8192);
    const ssize_t size = read(far_end_, out.data(), out.size());
    out.resize(size > 0 ? std::size_t(size) : 0);
    return out;
  }

 private:
  static constexpr const char* kUsb = "/devices/pci0000:00/0000:00:14.0/usb1/1-1";

  std::string raw() const { return "hidraw" + std::to_string(plugged_ - 1); }
  std::string hidName() const {
    return std::string("0003:") + device_.vendor + ':' + device_.product + ".00" + std::to_string(plugged_);
  }

  int unread() const {
    int bytes = 0;
    return ioctl(near_end_, FIONREAD, &bytes) == 0 ? bytes : 0;
  }

  // The description that `umockdev-record` would write: hidraw node, HID device, USB interface, USB device.
  std::string listed() const {
    const std::string vendor = device_.vendor, product = device_.product, name = device_.name;
    const std::string hid = hidName();
    const std::string usb = kUsb, interface = usb + "/1-1:1.0", node = interface + '/' + hid;
    std::string hex;
    for (const std::uint8_t byte : device_.descriptor) {
      char two[3];
      std::snprintf(two, sizeof two, "%02X", byte);
      hex += two;
    }
    const auto lower = [](std::string text) {
      for (char& c : text) c = char(std::tolower(c));
      return text;
    };
    return "P: " + node + "/hidraw/" + raw() + "\nN: " + raw() + "\nE: DEVNAME=/dev/" + raw() +
           "\nE: SUBSYSTEM=hidraw\nL: device=../../../" + hid + "\n\n" + "P: " + node +
           "\nE: SUBSYSTEM=hid\nE: DRIVER=hid-generic\nE: HID_ID=0003:0000" + vendor + ":0000" + product +
           "\nE: HID_NAME=" + name + "\nE: HID_UNIQ=\nH: report_descriptor=" + hex + "\n\n" + "P: " + interface +
           "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\nA: bInterfaceNumber=00\n\n" + "P: " + usb +
           "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nA: idVendor=" + lower(vendor) +
           "\nA: idProduct=" + lower(product) + "\nA: manufacturer=" + name.substr(0, name.find(' ')) +
           "\nA: product=" + name + "\nA: bcdDevice=0100\n\n";
  }

  // Answers for descriptor and feature report as the kernel does. The requests are hidraw's: 'H' and a number.
  static gboolean answer(UMockdevIoctlBase*, UMockdevIoctlClient* client, HidTestbed* self) {
    const unsigned long request = umockdev_ioctl_client_get_request(client);
    const unsigned number = unsigned(request & 0xFF), room = unsigned(request >> 16 & 0x3FFF);
    if ((request >> 8 & 0xFF) != 'H') return FALSE;
    UMockdevIoctlData* const data =
        umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, room, nullptr);
    const auto give = [&](std::size_t at, const Bytes& bytes) {
      Bytes copy = bytes;
      copy.resize(std::min<std::size_t>(copy.size(), room - at));
      umockdev_ioctl_data_update(data, gsize(at), copy.data(), gint(copy.size()));
      return glong(copy.size());
    };
    glong result = -1;
    const Bytes& descriptor = self->device_.descriptor;
    const auto size = std::uint8_t(descriptor.size());
    if (number == 1)
      give(0, {size, 0, 0, 0}), result = 0;
    else if (number == 2)
      give(0, {size, 0, 0, 0}), give(4, descriptor), result = 0;
    else if (number == 7 && !self->device_.feature.empty())
      result = give(0, self->device_.feature);
    umockdev_ioctl_client_complete(client, result, result < 0 ? EINVAL : 0);
    g_object_unref(data);
    return TRUE;
  }

  UMockdevTestbed* bed_;
  UMockdevIoctlBase* handler_ = nullptr;
  MockedHid device_{};
  int plugged_ = 0, far_end_ = -1, near_end_ = -1;
};

}  // namespace moltact::test
