// The real libhidapi on devices that umockdev mocks: enumeration, opening, reports in and out. Runs under umockdev-wrapper.
// What this proves: the use of the library and the parsing; not USB timing, and not a device.
#include <doctest/doctest.h>
#include <glib.h>
#include <umockdev.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>

#include "engine/device/driver.h"
#include "engine/device/hid/hid_port.h"

using namespace moltact;

namespace {

// A report descriptor of a vendor's page and usage, in hexadecimal: usage page, usage, one collection.
std::string descriptor(unsigned page, unsigned usage) {
  char text[64];
  std::snprintf(text, sizeof text, "06%02X%02X09%02XA101C0", page & 0xFF, page >> 8, usage);
  return text;
}

// What `umockdev-record` would have written of a HID device behind hidraw0.
std::string device(const char* vendor, const char* product, const char* name, const std::string& hex) {
  const std::string hid = std::string("0003:") + vendor + ':' + product + ".0001";
  const std::string usb = "/devices/pci0000:00/0000:00:14.0/usb1/1-1", interface = usb + "/1-1:1.0", node = interface + '/' + hid;
  std::string lower_vendor = vendor, lower_product = product;
  for (char& c : lower_vendor) c = char(std::tolower(c));
  for (char& c : lower_product) c = char(std::tolower(c));
  return "P: " + node + "/hidraw/hidraw0\nN: hidraw0\nE: DEVNAME=/dev/hidraw0\nE: SUBSYSTEM=hidraw\nL: device=../../../" + hid + "\n\n" +
         "P: " + node + "\nE: SUBSYSTEM=hid\nE: DRIVER=hid-generic\nE: HID_ID=0003:0000" + vendor + ":0000" + product + "\nE: HID_NAME=" + name +
         "\nE: HID_UNIQ=\nH: report_descriptor=" + hex + "\n\n" +
         "P: " + interface + "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\nA: bInterfaceNumber=00\n\n" +
         "P: " + usb + "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nA: idVendor=" + lower_vendor + "\nA: idProduct=" + lower_product +
         "\nA: manufacturer=" + std::string(name).substr(0, std::string(name).find(' ')) + "\nA: product=" + name + "\nA: bcdDevice=0100\n\n";
}

struct Testbed {
  Testbed() : bed(umockdev_testbed_new()) {}
  ~Testbed() { g_object_unref(bed); }
  void add(const std::string& text, const std::string& hex, const std::string& script) {
    GError* error = nullptr;
    const bool added = umockdev_testbed_add_from_string(bed, text.c_str(), &error);
    REQUIRE_MESSAGE(added, (error ? error->message : ""));
    char size[32];
    std::snprintf(size, sizeof size, "%02zX000000", hex.size() / 2);
    const std::string ioctls = "@DEV /dev/hidraw0\nHIDIOCGRDESCSIZE 0 " + std::string(size) + "\nHIDIOCGRDESC 0 " + size + hex + "\n";
    const std::string file = std::string(g_get_tmp_dir()) + "/moltact_hid_" + std::to_string(getpid()), reads = file + ".script";
    g_file_set_contents(file.c_str(), ioctls.c_str(), -1, nullptr);
    g_file_set_contents(reads.c_str(), script.c_str(), gssize(script.size()), nullptr);
    const bool loaded = umockdev_testbed_load_ioctl(bed, "/dev/hidraw0", file.c_str(), &error);
    REQUIRE_MESSAGE(loaded, (error ? error->message : ""));
    const bool scripted = script.empty() || umockdev_testbed_load_script(bed, "/dev/hidraw0", reads.c_str(), &error);
    REQUIRE_MESSAGE(scripted, (error ? error->message : ""));
  }
  UMockdevTestbed* bed;
};

// Bytes as umockdev's scripts write them: those under 32 as ^ and the letter 64 further on.
std::string scripted(const std::vector<std::uint8_t>& bytes) {
  std::string out;
  for (const std::uint8_t byte : bytes) {
    if (byte < 32) out += '^', out += char(byte + 64);
    else if (byte == '^') out += "^`";
    else out += char(byte);
  }
  return out;
}

}  // namespace

TEST_CASE("without a HID device the list says that none is plugged in") {
  const Testbed bed;
  CHECK(listHid().empty());
  for (const FoundDevice& one : findDevices())
    if (one.name == "spacemouse") CHECK(one.why == "none is plugged in");
}

TEST_CASE("a SpaceMouse is found by its ids and usage, opened, and its push of 0.2 s moves the hand; the mouse stays the default") {
  Testbed bed;
  const std::string hex = "05010908A101C0";
  // Twelve bytes of axes: 64 to the right, at a light push.
  const std::string push = scripted({1, 0x40, 0x01, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  std::string script;
  for (int k = 0; k < 12; ++k) script += "r 20 " + push + '\n';
  script += "r 20 " + scripted({3, 1, 0}) + '\n';
  bed.add(device("256F", "C635", "3Dconnexion SpaceMouse Compact", hex), hex, script);
  const std::vector<FoundDevice> found = findDevices();
  const auto one = std::find_if(found.begin(), found.end(), [](const FoundDevice& d) { return d.name == "spacemouse"; });
  REQUIRE(one != found.end());
  CHECK_MESSAGE(one->usable, one->why);
  CHECK(one->title.find("SpaceMouse Compact") != std::string::npos);
  CHECK(one->place == "/dev/hidraw0");
  CHECK(defaultDevice(found).name == "mouse");

  auto opened = openDevice("spacemouse");
  REQUIRE_MESSAGE(opened, (opened ? "" : opened.problem().text()));
  DevicePose pose;
  for (int k = 0; k < 5000 && !(pose.buttons == 1); ++k) {
    pose = (*opened)->read(0.001);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  CHECK(pose.buttons == 1);
  CHECK(pose.position.mm.x > 1.0);
  CHECK(pose.position.mm.y == 0.0);
}

TEST_CASE("WoodenHaptics is found by its ids, read, and its currents are written") {
  Testbed bed;
  const std::string hex = descriptor(0xFF00, 0x02);
  std::string script;
  for (int k = 0; k < 20; ++k) script += "r 5 " + scripted({16, 0, 16, 0, 16, 0, std::uint8_t(k), 0}) + '\n';
  bed.add(device("1234", "0006", "Forsslund WoodenHaptics", hex), hex, script);
  auto opened = openDevice("woodenhaptics");
  REQUIRE_MESSAGE(opened, (opened ? "" : opened.problem().text()));
  CHECK((*opened)->info().gives_force);
  DevicePose pose;
  for (int k = 0; k < 3000 && pose.position.mm == Vec3(0); ++k) {
    pose = (*opened)->read(0.001);
    (*opened)->write({Vec3(0, 0.5, 0)});
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  CHECK(pose.connected);
  CHECK(pose.position.mm.y < -39);
}

TEST_CASE("a device of another maker is none of ours") {
  Testbed bed;
  const std::string hex = "05010902A101C0";
  bed.add(device("046D", "C077", "Logitech Mouse", hex), hex, "");
  for (const FoundDevice& one : findDevices())
    if (one.name != "simulated" && one.name != "mouse") CHECK_FALSE(one.usable);
}
