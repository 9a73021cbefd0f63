// A device during a lesson and over two starts. It is unplugged and returns within a step. The chosen device is stored,
// awaited, and used when it is present.
#include <chrono>
#include <cstdlib>
#include <future>
#include <thread>

#include "app/ui/extensions/device_link.h"
#include "app/ui/extensions/extensions.h"
#include "tests/app/scripted_user_fixture.h"
#include "tests/device/tcp_stylus.h"

namespace moltact {
namespace {

ScriptedUser::Options deviceLessonKeeping(const std::filesystem::path& settings) {
  ScriptedUser::Options options;
  options.application.settings_file = settings;
  return options;
}

// Whether one of the messages says so.
bool reported(ScriptedUser& d, const std::string& part) {
  for (const Message& m : d.app().messages.all())
    if (contains(m.text, part)) return true;
  return false;
}

// Which libHD.so is found, for as long as this stands: tests after it are without one.
struct LibHd {
  explicit LibHd(const char* file) { name(file); }
  ~LibHd() { ::unsetenv("MOLTACT_LIBHD"); }
  void name(const char* file) { ::setenv("MOLTACT_LIBHD", file, 1); }
};

const char* kDeviceLesson = R"(---
title: Held
minutes: 5
goals: Hold on.
molecules: 1ubq
author: A
licence: CC0
---

## Before

```scene
molecule: 1ubq
```

Nothing to do.

## Press

```touch
reach: residue 70
say: Touch valine 70.
```
)";

}  // namespace

TEST_CASE(
    "unplugged in a lesson's step, by a script: the mouse does the step's task, the stylus leads again when it is "
    "back, and the step is the same") {
  const Scratch scratch;
  auto d = startWith("");
  const std::string script = "open " + scratch.file("held.md", kDeviceLesson).string() + R"(
key Alt+Right
expect lesson/step Press
key Ctrl+D
wait 3
click device/simulated
key Escape
wait 5
expect status/device Simulated stylus
wait 120
expect status/contact touching
plug out
expect status/device Mouse
expect status/contact free
wait 15
expect message/0 Until then the mouse leads
expect lesson/step Press
expect task/0 current: Touch valine 70.
point view 0.40 0.30
wait 20
press
wait 90
release
expect task/0 done: Touch valine 70.
expect lesson/step Press
plug in
wait 20
expect status/device Simulated stylus
expect lesson/step Press
expect task/0 done
)";
  const auto problem = d->run(script, "script");
  CHECK_MESSAGE(!problem, (problem ? problem->text() : ""));
}

TEST_CASE("a device that was chosen is in use at the next start; the mouse that was chosen after it, too") {
  const Scratch scratch;
  const auto file = scratch.folder / "settings.json";
  {
    auto d = startWith("1ubq", deviceLessonKeeping(file));
    CHECK(d->text("status/device") == "Mouse");
    d->app().extensions().device.choose("simulated");
    d->frames(2);
  }
  {
    auto d = startWith("1ubq", deviceLessonKeeping(file));
    CHECK(d->text("status/device") == "Simulated stylus");
    d->app().extensions().device.choose("mouse");
    d->frames(2);
  }
  auto d = startWith("1ubq", deviceLessonKeeping(file));
  CHECK(d->text("status/device") == "Mouse");
}

TEST_CASE(
    "a chosen device that is missing is reported once and the mouse is used; within seconds of its "
    "connection the device is used") {
  const Scratch scratch;
  const auto file = scratch.file("settings.json", R"({"device": "omni"})");
  LibHd lib("/nowhere/libHD.so");
  auto d = startWith("1ubq", deviceLessonKeeping(file));
  CHECK(d->text("status/device") == "Mouse");
  CHECK(reported(*d, "Phantom Omni or Touch is not there"));
  CHECK(reported(*d, "Until it is, the mouse leads."));
  d->tap("Ctrl+D");
  d->frames(3);
  CHECK(d->text("device/awaited") == "Phantom Omni or Touch leads as soon as it can be reached.");
  d->tap("Escape");
  lib.name(MOLTACT_STAND_IN_LIBHD);
  d->frames(150);
  CHECK(d->app().extensions().device.chosen() == "omni");
  CHECK(reported(*d, " is there and leads."));
  CHECK(d->app().extensions().device.awaited().empty());
  CHECK(d->app().settings.device == "omni");
}

TEST_CASE(
    "who chooses another device while one is waited for is asked no more for the first; a name that no driver has is "
    "forgotten") {
  const Scratch scratch;
  {
    auto d = startWith("1ubq", deviceLessonKeeping(scratch.file("settings.json", R"({"device": "spacemouse"})")));
    CHECK_FALSE(d->app().extensions().device.awaited().empty());
    d->app().extensions().device.choose("mouse");
    d->frames(1);
    CHECK(d->app().extensions().device.awaited().empty());
    CHECK(d->app().settings.device == "mouse");
  }
  auto d = startWith("1ubq", deviceLessonKeeping(scratch.file("settings.json", R"({"device": "ouija"})")));
  CHECK(d->app().extensions().device.awaited().empty());
  CHECK_FALSE(reported(*d, "is not there"));
  CHECK(d->text("status/device") == "Mouse");
}

TEST_CASE("the open device page shows within two seconds what was plugged in, and what was unplugged") {
  auto d = startWith();
  bool there = false;
  d->app().extensions().device.setFinder([&] {
    std::vector<FoundDevice> found{{.name = "mouse", .title = "Mouse", .usable = true, .auto_selectable = true}};
    if (there)
      found.insert(found.begin(),
                   {.name = "omni", .title = "Touch", .usable = true, .gives_force = true, .auto_selectable = true});
    return found;
  });
  d->tap("Ctrl+D");
  d->frames(3);
  CHECK(d->shows("device/mouse"));
  CHECK_FALSE(d->shows("device/omni"));
  there = true;
  d->frames(125);
  CHECK(d->shows("device/omni"));
  there = false;
  d->frames(125);
  CHECK_FALSE(d->shows("device/omni"));
  // A script's window takes and offers nothing by itself.
  CHECK(d->text("status/device") == "Mouse");
  CHECK_FALSE(reported(*d, "plugged in"));
}

TEST_CASE(
    "where nobody chose, a device that gives force and is plugged in later is offered and does not lead by itself; "
    "chosen, the offer goes, and so it does when "
    "the device is gone") {
  const LibHd lib(MOLTACT_STAND_IN_LIBHD);
  ScriptedUser::Options options;
  options.application.devices_unasked = true;
  auto d = startWith("1ubq", options);
  d->frames(10);
  // What there is on this computer was taken at the start: begin with nothing.
  d->app().extensions().device.choose("mouse");
  d->frames(1);
  d->app().settings.device.clear();
  bool there = false;
  d->app().extensions().device.setFinder([&] {
    std::vector<FoundDevice> found{{.name = "mouse", .title = "Mouse", .usable = true, .auto_selectable = true}};
    if (there)
      found.insert(found.begin(),
                   {.name = "omni", .title = "Touch", .usable = true, .gives_force = true, .auto_selectable = true});
    return found;
  });
  d->frames(320);
  CHECK_FALSE(reported(*d, "plugged in"));
  there = true;
  d->frames(320);
  CHECK(reported(*d, "Touch is plugged in. Choose it on the device page to feel with it."));
  CHECK(d->text("status/device") == "Mouse");
  there = false;
  d->frames(320);
  CHECK_FALSE(reported(*d, "plugged in"));
  there = true;
  d->frames(320);
  REQUIRE(reported(*d, "plugged in"));
  for (std::size_t k = 0; k < d->app().messages.all().size(); ++k)
    if (contains(d->app().messages.all()[k].text, "plugged in"))
      CHECK(d->click("message/" + std::to_string(k) + "/device"));
  d->frames(3);
  CHECK(d->click("device/omni"));
  d->frames(3);
  CHECK(d->app().extensions().device.chosen() == "omni");
  CHECK_FALSE(reported(*d, "plugged in"));
}

TEST_CASE("a slow search for devices delays no frame") {
  ScriptedUser::Options options;
  options.application.clock = ServoClock::RealThread;
  auto d = startWith("argon-pair", options);
  std::promise<void> gate;
  const std::shared_future<void> open = gate.get_future().share();
  d->app().extensions().device.setFinder([open] {
    open.wait();
    return std::vector<FoundDevice>{{.name = "mouse", .title = "Mouse", .usable = true, .auto_selectable = true}};
  });
  d->tap("Ctrl+D");
  d->frames(300);  // would never end
  CHECK(d->text("device/looking") == "Looking …");
  gate.set_value();
  for (int k = 0; k < 12000 && !d->shows("device/mouse"); ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    d->frames(1);
  }
  CHECK(d->shows("device/mouse"));
}

TEST_CASE(
    "an address on the device page: one without a port is refused with a reason, one on another computer is marked as "
    "unencrypted, and the stylus of this computer leads, also at the next start") {
  test::TcpStylus there;
  const Scratch scratch;
  const auto file = scratch.folder / "settings.json";
  const std::string number = std::to_string(there.port());
  {
    auto d = startWith("1ubq", deviceLessonKeeping(file));
    d->tap("Ctrl+D");
    d->frames(3);
    const auto write = [&](const std::string& text) {
      REQUIRE(d->click("device/open-tcp/address"));
      d->tap("Ctrl+A");
      d->type(text);
      d->frames(2);
      CHECK(d->text("device/open-tcp/address") == text);
    };
    write("127.0.0.1:");
    CHECK(contains(d->text("device/open-tcp/note"), "is not a network address"));
    write("192.168.1.20:7010");
    CHECK(contains(d->text("device/open-tcp/note"), "unencrypted"));
    write(number);
    CHECK_FALSE(d->shows("device/open-tcp/note"));
    REQUIRE(d->click("device/open-tcp/connect"));
    d->frames(3);
    CHECK(d->text("device/name") == "Device of the open layout, over a network");
    CHECK(d->app().settings.device == "open-tcp:" + number);
    CHECK(there.hosts == 1);  // opening connects once
  }
  {
    auto d = startWith("1ubq", deviceLessonKeeping(file));
    d->frames(3);
    CHECK(d->text("status/device") == "Device of the open layout, over a network");
    CHECK(there.hosts == 2);
    d->app().extensions().device.choose("mouse");
    d->frames(2);
  }
  {
    auto d = startWith("1ubq", deviceLessonKeeping(file));
    d->tap("Ctrl+D");
    d->frames(3);
    CHECK(d->text("status/device") == "Mouse");
    CHECK(d->text("device/open-tcp/address") == number);
  }
  // Named at the start it leads, and what was chosen stays chosen.
  auto options = deviceLessonKeeping(file);
  options.application.device = "open-tcp:" + number;
  auto d = startWith("1ubq", options);
  d->frames(3);
  CHECK(d->text("status/device") == "Device of the open layout, over a network");
  CHECK(d->app().settings.device == "mouse");
}

TEST_CASE("a device at an address where nothing listens gives a message with the address, and the mouse leads") {
  std::string gone;
  { gone = test::TcpStylus().device(); }
  auto d = startWith();
  d->app().extensions().device.choose(gone);
  d->frames(3);
  CHECK(reported(*d, "there is no connection to 127.0.0.1:" + gone.substr(gone.find(':') + 1)));
  CHECK(d->text("status/device") == "Mouse");
}

}  // namespace moltact
