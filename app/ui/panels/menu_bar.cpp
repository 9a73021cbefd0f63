// The menu bar, generated from the table of actions, with submenus for lists of files and parts.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/files/library.h"
#include "app/ui/lesson/lesson_guide.h"
#include "app/ui/panels/actions.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/imgui_versions.h"
#include "app/ui/widgets/key_names.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/render/molecule_model.h"
#include "engine/structure/colouring.h"

namespace moltact {
namespace {

bool item(const std::string& name, const char* label, const char* shortcut = nullptr, bool on = false,
          bool enabled = true) {
  const bool chosen = ImGui::MenuItem(label, shortcut, on, enabled);
  recordItem(name, on ? "on" : "");
  return chosen;
}

// Opens the menu as a click would and gives its first line the focus.
void openByKeys(const char* label) {
  ImGui::OpenPopup(label);
  showKeysPlace(true);
  ignoreRestingMouse();
}

bool beginMenu(const std::string& name, const char* label, bool enabled = true) {
  const bool open = ImGui::BeginMenu(label, enabled);
  // While a menu is open, the last item is the menu's window, so its title is recorded only while it is closed.
  if (!open) recordItem(name, label);
  return open;
}

bool beginSubmenu(Application& app, const std::string& name, const char* label, bool enabled = true) {
  const bool open = beginMenu(name, label, enabled);
  if (!open && enabled && ImGui::IsItemFocused()) app.panels.at_submenu = true;
  return open;
}

void libraryMenu(Application& app) {
  if (!beginSubmenu(app, "menu/file/library", tr("Library"))) return;
  for (const LibraryItem& entry : library())
    if (item("menu/file/library/" + entry.id, entry.label.c_str())) app.open(entry.file);
  ImGui::EndMenu();
}

void recentMenu(Application& app) {
  if (!beginSubmenu(app, "menu/file/recent", tr("Recent"), !app.settings.recent.empty())) return;
  std::string chosen;
  for (std::size_t k = 0; k < app.settings.recent.size(); ++k)
    if (item("menu/file/recent/" + std::to_string(k), app.settings.recent[k].c_str())) chosen = app.settings.recent[k];
  if (!chosen.empty()) app.open(chosen);
  ImGui::EndMenu();
}

void shapesMenu(Application& app) {
  if (!beginSubmenu(app, "menu/view/shapes", tr("Shapes"), !app.panels.pages.welcome && !app.lesson.locks("show")))
    return;
  for (const ViewPartInfo& part : viewParts()) {
    const bool on = app.scene.look.shown.has(part.part);
    if (part.expert && !on && !app.settings.expert) continue;
    if (item("menu/view/shapes/" + std::string(part.name), part.shownLabel(), nullptr, on))
      app.scene.look.shown.set(part.part, !on);
  }
  ImGui::EndMenu();
}

constexpr float kSeeThrough = 0.55f;

bool showsWhatIsBound(const std::vector<StyledAtoms>& styles) {
  return styles.size() == 2 && styles[0].style == DrawStyle::Surface && styles[1].style == DrawStyle::BallAndStick;
}

// All atoms in one style. A surface would hide bound molecules: ligands are drawn as balls and sticks, and the surface
// of all other atoms is translucent.
std::vector<StyledAtoms> stylesOf(DrawStyle style, const Molecule* molecule) {
  std::vector<std::uint32_t> bound, others;
  if (style == DrawStyle::Surface && molecule)
    for (std::uint32_t a = 0; a < molecule->atoms.size(); ++a) {
      const std::uint32_t r = molecule->atoms[a].residue;
      (r != kNoResidue && molecule->residues[r].kind == ResidueKind::Ligand ? bound : others).push_back(a);
    }
  if (bound.empty() || others.empty()) return {{.style = style}};
  const auto listOf = [](std::vector<std::uint32_t> atoms) {
    return std::make_shared<const std::vector<std::uint32_t>>(std::move(atoms));
  };
  return {{.style = style, .atoms = listOf(std::move(others)), .opacity = kSeeThrough},
          {.style = DrawStyle::BallAndStick, .atoms = listOf(std::move(bound))}};
}

// The separator begins the group of drawing options, which also contains the shapes.
void styleMenu(Application& app) {
  ImGui::Separator();
  if (!beginSubmenu(app, "menu/view/style", tr("Style"), !app.panels.pages.welcome && !app.lesson.locks("show")))
    return;
  for (const DrawStyleInfo& style : drawStyles()) {
    const std::vector<StyledAtoms>& now = app.scene.look.atoms.styles;
    const bool on = now.empty() ? style.style == DrawStyle::Spheres
                                : now[0].style == style.style && (now.size() == 1 || showsWhatIsBound(now));
    if (item("menu/view/style/" + std::string(style.name), style.shownLabel(), nullptr, on))
      app.scene.look.atoms.styles = stylesOf(style.style, app.scene.stage().molecule.get());
  }
  ImGui::EndMenu();
}

void colourMenu(Application& app) {
  if (!beginSubmenu(app, "menu/view/colours", tr("Colours"), app.scene.stage() && !app.lesson.locks("show"))) return;
  const Colouring* const now = app.scene.look.atoms.colouring.get();
  for (const ColouringScheme& scheme : colouringSchemes()) {
    // In a lesson's scene, charge, hydrophobicity and others could give away answers.
    const bool plain = scheme.name == "element" || scheme.name == "chain";
    if (!plain && app.lesson.onStage()) continue;
    SceneSpec asked;
    asked.colour = scheme.name;
    const bool on = now ? now->scheme == scheme.name : plain && colourBy(asked) == app.scene.look.colour_by;
    if (item("menu/view/colours/" + std::string(scheme.name), scheme.shownLabel(), nullptr, on)) {
      app.scene.look.colour_by = colourBy(asked);
      app.scene.look.atoms.colouring = app.scene.look.colouring(asked.colour);
    }
  }
  ImGui::EndMenu();
}

// The views that the lesson's scene names.
void viewsMenu(Application& app) {
  if (app.panels.pages.welcome || !app.lesson.session() || app.lesson.session()->scene().views.empty()) return;
  if (!beginSubmenu(app, "menu/view/views", tr("Views"), app.scene.stage() && !app.extensions().task_stager.dark()))
    return;
  for (const NamedView& v : app.lesson.session()->scene().views)
    if (item("menu/view/views/" + v.name, v.name.c_str())) app.showView(v.view);
  ImGui::EndMenu();
}

void sizeMenu(Application& app) {
  if (!beginSubmenu(app, "menu/view/scale", tr("Interface size"))) return;
  for (const int percent : {75, 90, 100, 125, 150, 175, 200, 250, 300}) {
    const std::string label = quantityText(percent / 100.0, Dimension::Share);
    if (item("menu/view/scale/" + std::to_string(percent), label.c_str(), nullptr,
             app.settings.scale * 100.0 == double(percent)))
      app.settings.scale = percent / 100.0;
  }
  ImGui::EndMenu();
}

void lessonList(Application& app) {
  ImGui::Separator();
  if (!beginSubmenu(app, "menu/lesson/lessons", tr("Lessons"))) return;
  for (const LibraryItem& entry : lessons())
    if (item("menu/lesson/lessons/" + entry.id, entry.label.c_str())) app.open(entry.file);
  ImGui::EndMenu();
}

// A submenu that follows an action.
struct Inset {
  std::string_view after;
  void (*draw)(Application&);
};
constexpr Inset kInsets[] = {{"open", libraryMenu},   {"open", recentMenu},    {"methods", styleMenu},
                             {"methods", colourMenu}, {"methods", shapesMenu}, {"high-contrast", sizeMenu},
                             {"report", lessonList},  {"reset", viewsMenu}};

void drawMenu(Application& app, Menu menu) {
  const std::string label(menuLabel(menu)), prefix = "menu/" + lower(menuName(menu));
  if (app.panels.menu_wanted == int(menu)) openByKeys(label.c_str());
  if (!beginMenu(prefix, label.c_str())) return;
  app.panels.menu_open = int(menu);
  for (const Action& a : allActions()) {
    if (a.menu != menu) continue;
    if (a.parted) ImGui::Separator();
    const std::string text(tr(a.label)), shortcut = keysText(a.shortcut);
    if (item(prefix + "/" + std::string(a.name), text.c_str(), shortcut.c_str(), a.on && a.on(app), enabled(a, app)))
      a.run(app);
    for (const Inset& inset : kInsets)
      if (inset.after == a.name) inset.draw(app);
  }
  ImGui::EndMenu();
}

}  // namespace

void drawMenuBar(Application& app) {
  const Look& l = look();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {l.px(8), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      {l.px(8), std::floor(0.5f * (app.layout().menu.size().y - ImGui::GetFontSize()))});
  const bool shown =
      beginPanel("menu bar", app.layout().menu,
                 ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  if (shown && ImGui::BeginMenuBar()) {
    // The bar's paddings do not apply to its menus.
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {l.px(12), l.px(10)});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {l.px(16), l.px(10)});
    app.panels.menu_open = -1;
    app.panels.at_submenu = false;
    for (int menu = 0; menu < kMenus; ++menu) drawMenu(app, Menu(menu));
    app.panels.menu_wanted = -1;
    app.panels.window.menus_end = ImGui::GetCursorScreenPos().x;
    ImGui::PopStyleVar(2);
    ImGui::EndMenuBar();
  }
  if (shown) {
    const Rectangle& r = app.layout().menu;
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->PushClipRectFullScreen();
    draw->AddLine({r.low.x, r.high.y - 1}, {r.high.x, r.high.y - 1}, l.palette.line, std::max(1.0f, l.scale));
    draw->PopClipRect();
    endPanel();
  }
  ImGui::PopStyleVar(2);
}

}  // namespace moltact
