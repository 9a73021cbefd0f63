#include "engine/device/hid/hid_kind.h"

#include <algorithm>

#include "engine/language/catalogue.h"

namespace moltact {

std::vector<FoundDevice> findHid(const HidKind& kind) {
  std::vector<FoundDevice> out, closed;
  std::string strangers;
  for (const HidEntry& entry : listHid()) {
    if (!kind.is(entry)) continue;
    FoundDevice one{.title = entry.title.empty() ? std::string(kind.title) : entry.title, .place = entry.path};
    DeviceInfo info = kind.known;
    const auto port = openHid(entry);
    const auto protocol = kind.protocol();
    const std::optional<Problem> problem = port ? protocol->begin(**port, info) : port.problem();
    one.gives_force = info.gives_force;
    if (!problem) {
      one.usable = true;
      one.auto_selectable = info.gives_force;
      out.push_back(std::move(one));
    } else if (protocol->ofKind()) {
      one.why = problem->text();
      closed.push_back(std::move(one));
    } else {
      strangers += "; " + one.title + ": " + problem->message;
    }
  }
  out.insert(out.end(), closed.begin(), closed.end());
  if (out.empty()) {
    FoundDevice none{.title = std::string(kind.title), .gives_force = kind.known.gives_force};
    none.why = tr("none is plugged in") + strangers;
    out.push_back(std::move(none));
  }
  return out;
}

Expected<std::unique_ptr<Device>> openHid(const HidKind& kind, const FoundDevice& found) {
  DeviceInfo known = kind.known;
  if (known.name.empty()) known.name = found.title;
  // The device that was found first; others of the kind only if it is missing or is no longer of the kind.
  const auto opener =
      [is = kind.is, path = found.place](const PacketDevice::Accept& accept) -> Expected<std::unique_ptr<PacketPort>> {
    std::vector<HidEntry> all = listHid();
    std::erase_if(all, [&](const HidEntry& entry) { return !is(entry); });
    std::stable_partition(all.begin(), all.end(), [&](const HidEntry& entry) { return entry.path == path; });
    Problem why{"", 0, 0, tr("the device is not plugged in"), tr("plug it in")};
    for (const HidEntry& entry : all) {
      auto port = openHid(entry);
      if (!port) {
        why = port.problem();
        continue;
      }
      const auto problem = accept(**port);
      if (!problem) return port;
      why = *problem;
    }
    return why;
  };
  return PacketDevice::open(opener, kind.protocol(), std::move(known));
}

}  // namespace moltact
