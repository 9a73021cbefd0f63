// Damage tracking: a partial redraw gives the same pixels as a full one, and redraws little.
#include "app/ui/widgets/damage.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "app/ui/widgets/theme.h"
#include "engine/render/gl_objects.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

// The frame drawn last, all of it, in a framebuffer that held nothing.
std::vector<std::uint8_t> drawnWhole(int width, int height) {
  GlTarget target;
  REQUIRE(target.resize(width, height));
  target.bind();
  const ImVec4 ground = ImGui::ColorConvertU32ToFloat4(look().palette.ground);
  glClearColor(ground.x, ground.y, ground.z, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  std::vector<std::uint8_t> rows(std::size_t(width) * std::size_t(height) * 3), rgb;
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, rows.data());
  const std::size_t row = std::size_t(width) * 3;
  for (std::size_t y = std::size_t(height); y-- > 0;)
    rgb.insert(rgb.end(), rows.begin() + std::ptrdiff_t(y * row), rows.begin() + std::ptrdiff_t((y + 1) * row));
  return rgb;
}

double areaOf(const std::vector<Rectangle>& all) {
  double area = 0;
  for (const Rectangle& r : all) area += double(r.size().x) * double(r.size().y);
  return area;
}

// Frames of two windows, one of which says how far something has come.
struct Frames {
  std::unique_ptr<ScriptedUser> user = startWith("");  // for its context and fonts
  Damage damage;
  glm::vec2 size{640, 480};
  std::uint64_t version = 1;

  std::vector<Rectangle> next(const std::string& text) {
    ImGui::GetIO().DisplaySize = {size.x, size.y};
    ImGui::NewFrame();
    const auto window = [&](const char* name, float x, float y, const std::string& says) {
      ImGui::SetNextWindowPos({x, y});
      ImGui::SetNextWindowSize({100, 80});
      ImGui::Begin(name, nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs);
      ImGui::TextUnformatted(says.c_str());
      ImGui::End();
    };
    window("one", 10, 20, "still");
    window("two", 300, 200, text);
    ImGui::SetNextWindowPos({400, 300});
    ImGui::SetNextWindowSize({120, 90});
    ImGui::Begin("three", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs);
    addPicture(*ImGui::GetWindowDrawList(), ImGui::GetIO().Fonts->TexID, {{410, 310}, {500, 380}}, version);
    ImGui::End();
    ImGui::Render();
    return damage.since(*ImGui::GetDrawData());
  }
};

}  // namespace

TEST_CASE("damage: the whole window first, then nothing, then only the window whose text is another") {
  Frames f;
  f.next("a");  // windows find their sizes
  f.next("a");
  CHECK(f.next("a").empty());
  const std::vector<Rectangle> changed = f.next("b");
  REQUIRE(changed.size() == 1);
  CHECK(changed[0].low.x >= 300);
  CHECK(changed[0].low.y >= 200);
  CHECK(changed[0].high.x <= 400);
  CHECK(changed[0].high.y <= 280);
  CHECK(areaOf(changed) > 0);
  CHECK(f.next("b").empty());
  f.damage.forget();
  REQUIRE(f.next("b").size() == 1);
  f.size = {800, 480};
  const std::vector<Rectangle> all = f.next("b");
  REQUIRE(all.size() == 1);
  CHECK(areaOf(all) == 800 * 480);
}

TEST_CASE("damage: a new version of a picture redraws its window") {
  Frames f;
  for (int k = 0; k < 3; ++k) f.next("a");
  ++f.version;
  const std::vector<Rectangle> changed = f.next("a");
  REQUIRE(changed.size() == 1);
  // The window but for its padding, to which its contents are cut off.
  CHECK(areaOf(changed) > 0.8 * 120 * 90);
  CHECK(changed[0].low.x >= 400);
  CHECK(changed[0].low.y >= 300);
  CHECK(changed[0].high.x <= 520);
  CHECK(changed[0].high.y <= 390);
  CHECK(f.next("a").empty());
}

TEST_CASE("what is drawn in parts is what would have been drawn whole: a lesson, its menus, messages and pages") {
  ScriptedUser::Options options;
  options.draws = ScriptedUser::Draws::All;
  auto d = startWith("", std::move(options));
  openFirst(*d);
  d->app().finishLoading();
  d->frames(3);
  int compared = 0;
  const auto same = [&](const char* after) {
    INFO(after);
    const Picture parts = d->picture();
    CHECK(parts.rgb == drawnWhole(parts.width_px, parts.height_px));
    ++compared;
  };
  same("a lesson is opened");
  CHECK(d->point("view"));
  d->press();
  for (int k = 0; k < 5; ++k) {
    d->frames(4);
    same("while it is pressed");
  }
  d->release();
  same("it is let go");
  CHECK(d->hold("Ctrl"));
  CHECK(d->hold("Right"));
  for (int k = 0; k < 4; ++k) {
    d->frames(2);
    same("while it turns");
  }
  CHECK(d->letGo("Right"));
  CHECK(d->letGo("Ctrl"));
  d->frames(30);
  same("it has come to rest");
  for (const char* step :
       {"click menu/view", "key Escape", "point tool/sound", "wait 40", "click menu/help", "key Escape", "key F1",
        "key Escape", "key F9", "click tool/preferences", "key Escape", "theme dark", "scale 1.3", "size 900 700",
        "click tool/welcome", "wheel -3", "size 1280 800", "theme high-contrast", "click tool/lesson"}) {
    const auto problem = d->run(step, "steps");
    CHECK_MESSAGE(!problem, (problem ? problem->text() : ""));
    same(step);
    d->frames(3);
    same(step);
  }
  CHECK(compared > 40);
}

}  // namespace moltact
