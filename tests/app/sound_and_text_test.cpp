// Touch as sound and as text, through the window on the frames' clock.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "app/ui/extensions/extensions.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

double loudest(const std::vector<float>& s, std::size_t from, std::size_t to) {
  double most = 0;
  for (std::size_t k = from; k < std::min(to, s.size()); ++k) most = std::max(most, std::abs(double(s[k])));
  return most;
}

}  // namespace

TEST_CASE("sound is off at first; switched on, 1 s without touch is silent and a push of 1 s is heard") {
  auto d = startWith();
  TouchSound& sound = d->app().extensions().touch_sound;
  d->point("view");
  d->frames(10);
  CHECK(sound.heard().empty());
  d->app().settings.sound = true;
  d->frames(61);
  const std::size_t before = sound.heard().size();
  CHECK(before >= std::size_t(0.9 * kSamples_per_s));
  CHECK(loudest(sound.heard(), 0, before) == 0.0);
  d->press();
  d->frames(60);
  REQUIRE(d->text("status/contact") == "touching");
  CHECK(loudest(sound.heard(), before, sound.heard().size()) > 0.05);
  CHECK(loudest(sound.heard(), before, sound.heard().size()) < 0.99);
  d->release();
  d->frames(90);
  CHECK(loudest(sound.heard(), sound.heard().size() - kSamples_per_s / 10, sound.heard().size()) == 0.0);
  d->app().settings.sound = false;
  d->frames(1);
  const std::size_t end = sound.heard().size();
  d->frames(30);
  CHECK(sound.heard().size() == end);
}

TEST_CASE(
    "at the first touch who has no force-feedback device is asked once whether to hear it; the answer and the question "
    "are remembered, and a cross is a no") {
  const Scratch scratch;
  for (const std::string answer : {"sound-yes", "sound-no", "dismiss"}) {
    CAPTURE(answer);
    ScriptedUser::Options options;
    options.application.settings_file = scratch.folder / (answer + ".json");
    const auto question = [](ScriptedUser& d) {
      for (std::size_t k = 0; k < d.app().messages.all().size(); ++k)
        if (contains(d.text("message/" + std::to_string(k)), "hear what you touch"))
          return "message/" + std::to_string(k);
      return std::string();
    };
    const auto touches = [](ScriptedUser& d) {
      d.point("view");
      d.frames(10);
      d.press();
      d.frames(90);
      d.release();
      d.frames(30);
    };
    {
      auto d = startWith("1ubq", options);
      d->point("view");
      d->frames(60);
      CHECK(question(*d).empty());
      touches(*d);
      REQUIRE_FALSE(question(*d).empty());
      CHECK_FALSE(d->app().settings.sound);
      REQUIRE(d->click(question(*d) + "/" + answer));
      d->frames(3);
      CHECK(question(*d).empty());
      CHECK(d->app().settings.sound == (answer == "sound-yes"));
      CHECK(d->app().settings.sound_volume < 0.5);
      touches(*d);
      CHECK(question(*d).empty());
      CHECK((loudest(d->app().extensions().touch_sound.heard(), 0, ~std::size_t(0)) > 0.0) == (answer == "sound-yes"));
    }
    auto again = startWith("1ubq", options);
    CHECK(again->app().settings.sound == (answer == "sound-yes"));
    touches(*again);
    CHECK(question(*again).empty());
  }
}

TEST_CASE("a pushed probe that is dragged over the protein is heard to slide, half as loud at half the volume") {
  const auto heardAt = [](double volume) {
    auto d = startWith();
    d->app().settings.sound = true;
    d->app().settings.sound_volume = volume;
    d->point("view");
    d->frames(10);
    d->press();
    d->frames(60);
    for (int k = 0; k < 60; ++k) d->point("view", 0.5 + 0.003 * k, 0.5);
    return d->app().extensions().touch_sound.heard();
  };
  const std::vector<float> half = heardAt(0.5), whole = heardAt(1.0);
  REQUIRE(half.size() == whole.size());
  double off = 0.0;
  for (std::size_t k = 0; k < half.size(); ++k) off = std::max(off, std::abs(double(2.0f * half[k] - whole[k])));
  CHECK(off < 1e-6);
  CHECK(loudest(whole, 0, whole.size()) > 0.1);
}

TEST_CASE("without a sound card sound that is switched on is reported once, and again when it is switched on again") {
  setenv("ALSOFT_DRIVERS", "none", 1);
  ScriptedUser::Options options;
  options.application.clock = ServoClock::RealThread;
  auto d = startWith("argon-pair", options);
  const auto reported = [&] {
    int n = 0;
    for (const Message& m : d->app().messages.all()) n += contains(m.text, "There is no sound");
    return n;
  };
  const auto wait = [&] {
    for (int k = 0; k < 12000 && reported() == 0; ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      d->frames(1);
    }
  };
  CHECK(reported() == 0);
  for (int round = 0; round < 2; ++round) {
    d->app().settings.sound = true;
    wait();
    CHECK(reported() == 1);
    d->app().messages.dismiss(0);
    d->frames(10);
    CHECK(reported() == 0);
    d->app().settings.sound = false;
    d->frames(2);
  }
}

TEST_CASE(
    "the state text contains the step, its task and the contact, one line each; a missing folder is "
    "a problem") {
  const auto file = std::filesystem::temp_directory_path() / "moltact_state_text.txt";
  auto d = startWith("");
  StateText& text = d->app().extensions().state_text;
  CHECK(text.writeTo("/no/such/folder/text").value().text().find("its folder is not there") != std::string::npos);
  REQUIRE_FALSE(text.writeTo(file));
  openFirst(*d);
  d->app().finishLoading();
  d->frames(120);
  d->point("view");
  d->press();
  d->frames(240);
  d->release();
  d->frames(240);
  std::ifstream in(file);
  std::stringstream all;
  all << in.rdbuf();
  std::filesystem::remove(file);
  const std::string lines = all.str();
  CAPTURE(lines);
  CHECK(lines.find("step 1 of ") == 0);
  CHECK(contains(lines, "\ntouching: "));
  CHECK(lines.find("not touching\n", lines.find("\ntouching: ")) != std::string::npos);
  // 10 s leave room for no more than a line of each kind every 1.5 s.
  CHECK(std::count(lines.begin(), lines.end(), '\n') <= 16);
}

TEST_CASE("what is touched in large type is higher than in the usual type, and stays within the view at 200 % scale") {
  auto d = startWith("1ubq");
  d->point("view");
  d->press();
  d->frames(120);
  const WidgetRecord* usual = widgets().find("view/state");
  REQUIRE(usual);
  const float height = usual->high.y - usual->low.y;
  d->app().settings.large_state_text = true;
  d->frames(5);
  CHECK(widgets().find("view/state")->high.y - widgets().find("view/state")->low.y > 1.2f * height);
  d->app().settings.scale = 2.0;
  d->frames(5);
  d->point("view");
  d->frames(60);
  const WidgetRecord* large = widgets().find("view/state");
  REQUIRE(large);
  const WidgetRecord* view = widgets().find("view");
  REQUIRE(view);
  CHECK(large->low.x >= view->low.x);
  CHECK(large->high.x <= view->high.x);
  CHECK(large->low.y >= view->low.y);
}

}  // namespace moltact
