#include "app/ui/panels/actions.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/lesson/class_page.h"
#include "app/ui/panels/lesson/class_report.h"
#include "app/ui/panels/lesson/hand_in.h"
#include "app/ui/panels/lesson/print_kit.h"
#include "app/ui/panels/side_panel.h"
#include "app/ui/panels/view_overlays.h"
#include "app/ui/widgets/key_focus.h"
#include "app/ui/widgets/key_names.h"
#include "engine/classroom/taught_class.h"
#include "engine/language/catalogue.h"
#include "engine/platform/hand_over.h"
#include "engine/render/gltf_export.h"

namespace moltact {
namespace {

using App = Application;

bool hasStage(const App& a) { return bool(a.scene.stage()) && !a.panels.pages.welcome; }
bool inLesson(const App& a) { return a.lesson.session() && !a.panels.pages.welcome; }
// Teachers' notes are hidden while students take turns at the screen.
bool mayTeacherNotes(const App& a) {
  return inLesson(a) && !a.extensions().turns.on() && !a.extensions().name_asker.asking() &&
         hasTeacherNotes(a.lesson.session()->lesson());
}
// The kit has the answers, so it is not offered in the browser edition, which students have, or during turns.
bool mayTeachersKit(const App& a) {
  return inLesson(a) && !filesAreHandedOver() && !a.extensions().turns.on() && !a.extensions().name_asker.asking();
}
bool atWork(const App& a) { return !a.panels.pages.welcome; }
// If a lesson locks its panels, a narrow window can still switch between the two panels.
bool mayTouchPanel(const App& a) { return atWork(a) && (a.panels.tabs.shown() || !a.lesson.locks("panels")); }
bool maySideTab(const App& a) { return atWork(a) && !a.lesson.locks("panels"); }

bool mayMagnify(const App& a) {
  return hasStage(a) && !a.scene.playedHand().on() && !a.lesson.locks("magnify") && !a.extensions().task_stager.dark();
}

bool mayMeasure(const App& a) { return hasStage(a) && !a.extensions().task_stager.dark(); }

void measureTouched(App& a) {
  const Contact& contact = a.scene.log().latest().contact;
  if (!contact.touching() || contact.atoms[0] < 0)
    return a.messages.notice(tr("Touch an atom first: what you touch is measured."));
  a.extensions().measuring.take(*a.scene.stage().molecule, std::uint32_t(contact.atoms[0]));
}

// If only one side panel has room, showing one hides the other.
void switchPanels(App& a, bool lesson) {
  const bool shows = (lesson ? a.layout().lesson : a.layout().touch).empty();
  if (lesson)
    a.panels.lesson = shows;
  else
    a.panels.tabs.show(shows);
  if (shows) a.panels.lesson_first = lesson;
}

void switchTab(App& a, std::string_view tab) {
  if (a.panels.tabs.has(tab))
    a.panels.tabs.close(tab);
  else
    a.panels.tabs.open(tab);
}

// The cutting plane faces the viewer in the present orientation of the molecule.
void switchCut(App& a) {
  if (a.scene.look.atoms.cut) {
    a.scene.look.atoms.cut.reset();
    return;
  }
  const Vec3 normal = a.scene.camera.back();
  a.scene.look.atoms.cut = CutPlane{normal, glm::dot(normal, a.scene.stage().middle.A)};
}

// Copies the view as a line of a scene: "view: turned 30 10 0".
void copyView(App& app) {
  const std::string line = "view: " + viewText(app.scene.camera);
  ImGui::SetClipboardText(line.c_str());
  app.messages.notice(trf("Copied: {0}", line));
}

void saveGltf(App& app, const std::filesystem::path& file) {
  if (!app.scene.stage()) return;
  const ViewScene seen = seenScene(app);
  const Expected<GltfScene> scene =
      exportMolecule(*seen.molecule,
                     {.look = seen.look,
                      .annotations = seen.annotations,
                      .highlighted = seen.shown.has(ViewPart::Target) ? seen.highlighted : std::vector<std::uint32_t>(),
                      .colours = seen.elements,
                      .colour_by = seen.colour_by});
  if (!scene) return app.messages.error(scene.problem().text());
  if (const auto problem = writeGlb(file, *scene)) return app.messages.error(problem->text());
  handOver(file);
  app.messages.notice(trf("Molecule saved as {0}; 1 unit is 1 nm", file.string()));
}

void askForGltf(App& app) {
  app.file_dialog.ask({.title = tr("Save the molecule as a 3-D model"),
                       .name = app.scene.molecule().file.stem().string() + ".glb",
                       .ending = ".glb",
                       .chosen = [&app](const std::filesystem::path& file) { saveGltf(app, file); }},
                      app.options().picture_folder);
}

constexpr std::array kActions{
    Action{.name = "welcome",
           .menu = Menu::File,
           .label = N_("Welcome page"),
           .shortcut = "Ctrl+H",
           .sentence = N_("All lessons and molecules"),
           .icon = Icon::Home,
           .tool = 1,
           .run = [](App& a) { a.panels.pages.welcome = !a.panels.pages.welcome || !a.hasWork(); },
           .on = [](const App& a) { return a.panels.pages.welcome; }},
    Action{.name = "open",
           .menu = Menu::File,
           .label = N_("Open …"),
           .shortcut = "Ctrl+O",
           .sentence = N_("Open a molecule or a lesson"),
           .icon = Icon::Folder,
           .tool = 2,
           .run =
               [](App& a) {
                 if (!askForFile()) a.panels.pages.open = true;
               }},
    Action{.name = "reading",
           .menu = Menu::File,
           .label = N_("Models, waters, assembly …"),
           .sentence = N_("How the molecule's file is read: which model, with its waters, as which assembly"),
           .run = [](App& a) { a.panels.pages.reading = true; },
           .enabled = [](const App& a) { return hasStage(a) && !a.lesson.onStage() && !a.scene.playedHand().on(); }},
    Action{.name = "picture",
           .menu = Menu::File,
           .parted = true,
           .label = N_("Save picture"),
           .shortcut = "Ctrl+S",
           .sentence = N_("Save the view as a picture"),
           .icon = Icon::Camera,
           .tool = 4,
           .run = [](App& a) { a.askForPicture(); },
           .enabled = hasStage},
    Action{.name = "picture_as",
           .menu = Menu::File,
           .label = N_("Save picture as …"),
           .shortcut = "Ctrl+Shift+S",
           .run = [](App& a) { a.askForPictureAs(); },
           .enabled = hasStage},
    Action{.name = "export",
           .menu = Menu::File,
           .label = N_("Save molecule as glTF …"),
           .sentence = N_("Save the molecule as a 3-D model for slides and web pages"),
           .run = [](App& a) { askForGltf(a); },
           .enabled = hasStage},
    Action{.name = "quit",
           .menu = Menu::File,
           .parted = true,
           .label = N_("Quit"),
           .shortcut = "Ctrl+Q",
           .run = [](App& a) { a.leave(); },
           .enabled = [](const App& a) { return a.options().clock != ServoClock::Page; },
           .while_writing = true},

    Action{.name = "undo",
           .menu = Menu::Edit,
           .label = N_("Undo"),
           .shortcut = "Ctrl+Z",
           .sentence = N_("Undo the last change of method, probe, spring, parts shown, colours or view"),
           .icon = Icon::Undo,
           .tool = 3,
           .run = [](App& a) { a.extensions().history.undo(); },
           .enabled = [](const App& a) { return atWork(a) && a.extensions().history.canUndo(); }},
    Action{.name = "redo",
           .menu = Menu::Edit,
           .label = N_("Redo"),
           .shortcut = "Ctrl+Shift+Z",
           .also = "Ctrl+Y",
           .sentence = N_("Redo what was undone"),
           .icon = Icon::Redo,
           .tool = 3,
           .run = [](App& a) { a.extensions().history.redo(); },
           .enabled = [](const App& a) { return atWork(a) && a.extensions().history.canRedo(); }},
    Action{.name = "measure",
           .menu = Menu::Edit,
           .parted = true,
           .label = N_("Measure"),
           .shortcut = "Ctrl+E",
           .sentence = N_("Click two atoms for their distance, a third for the angle, a fourth for the torsion"),
           .run = [](App& a) { a.extensions().measuring.switchOn(!a.extensions().measuring.on()); },
           .enabled = mayMeasure,
           .on = [](const App& a) { return a.extensions().measuring.on(); }},
    Action{.name = "measure-touched",
           .menu = Menu::Edit,
           .label = N_("Measure from the touched atom"),
           .shortcut = "Ctrl+Shift+E",
           .sentence = N_("The atom that you touch is the next place that is measured"),
           .run = [](App& a) { measureTouched(a); },
           .enabled = mayMeasure},
    Action{.name = "measure-clear",
           .menu = Menu::Edit,
           .label = N_("Clear measures"),
           .run = [](App& a) { a.extensions().measuring.clear(); },
           .enabled = [](const App& a) { return a.extensions().measuring.any(); }},
    Action{.name = "copy-view",
           .menu = Menu::Edit,
           .label = N_("Copy this view for a lesson"),
           .sentence = N_("The line of a scene by which the molecule is turned as it is now"),
           .run = [](App& a) { copyView(a); },
           .enabled = hasStage},
    Action{.name = "preferences",
           .menu = Menu::Edit,
           .parted = true,
           .label = N_("Preferences …"),
           .shortcut = "Ctrl+,",
           .sentence = N_("Colours, sizes, mouse and numbers"),
           .icon = Icon::Gear,
           .tool = 4,
           .run = [](App& a) { a.panels.pages.preferences = true; }},

    Action{.name = "lesson",
           .menu = Menu::View,
           .label = N_("Lesson panel"),
           .shortcut = "Ctrl+L",
           .sentence = N_("Lesson panel"),
           .icon = Icon::LeftPanel,
           .tool = 1,
           .run = [](App& a) { switchPanels(a, true); },
           .enabled = inLesson,
           .on = [](const App& a) { return !a.layout().lesson.empty(); }},
    Action{.name = "touch",
           .menu = Menu::View,
           .label = N_("Touch panel"),
           .shortcut = "Ctrl+T",
           .sentence = N_("Touch panel"),
           .icon = Icon::RightPanel,
           .tool = 1,
           .run = [](App& a) { switchPanels(a, false); },
           .enabled = mayTouchPanel,
           .on = [](const App& a) { return !a.layout().touch.empty(); }},
#define MOLTACT_TAB_ACTION(Name, key, title, item, keys) \
  Action{.name = key,                                    \
         .menu = Menu::View,                             \
         .label = item,                                  \
         .shortcut = keys,                               \
         .run = [](App& a) { switchTab(a, key); },       \
         .enabled = maySideTab,                          \
         .on = [](const App& a) { return a.panels.tabs.has(key); }},
    MOLTACT_SIDE_TABS(MOLTACT_TAB_ACTION)
#undef MOLTACT_TAB_ACTION
        Action{.name = "cut",
               .menu = Menu::View,
               .label = N_("Cut open"),
               .sentence = N_("Cut the molecule open through its middle; Ctrl with the wheel moves the cut"),
               .run = [](App& a) { switchCut(a); },
               .enabled = [](const App& a) { return hasStage(a) && !a.lesson.locks("show"); },
               .on = [](const App& a) { return a.scene.look.atoms.cut.has_value(); }},
    // Disabled in a lesson's scene, because names and marks could give away answers.
    Action{.name = "look",
           .menu = Menu::View,
           .label = N_("How atoms are drawn …"),
           .sentence = N_("Style, colours, names, marks and hydrogen bonds of the atoms that you name"),
           .run = [](App& a) { a.panels.pages.look = true; },
           .enabled = [](const App& a) { return hasStage(a) && !a.lesson.onStage() && !a.lesson.locks("show"); }},
    Action{.name = "legend",
           .menu = Menu::View,
           .label = N_("Legend of colours"),
           .run = [](App& a) { a.settings.legend = !a.settings.legend; },
           .on = [](const App& a) { return a.settings.legend; }},
    Action{.name = "reset",
           .menu = Menu::View,
           .parted = true,
           .label = N_("Reset view"),
           .shortcut = "Home",
           .run = [](App& a) { a.resetViewByHand(); },
           .enabled = [](const App& a) { return hasStage(a) && !a.extensions().task_stager.dark(); }},
    Action{.name = "zoom",
           .menu = Menu::View,
           .label = N_("Come close to …"),
           .shortcut = "Ctrl+F",
           .sentence = N_("Turn atoms that you name to the front and come close to them"),
           .run = [](App& a) { a.panels.pages.zoom = true; },
           .enabled = [](const App& a) { return hasStage(a) && !a.extensions().task_stager.dark(); }},
    Action{.name = "magnify",
           .menu = Menu::View,
           .label = N_("Magnify round the probe"),
           .shortcut = "Ctrl+G",
           .sentence = N_("What lies round the probe fills the room of your hand"),
           .run = [](App& a) { a.scene.view().magnify(!a.scene.view().fit.by_hand); },
           .enabled = mayMagnify,
           .on = [](const App& a) { return a.scene.view().fit.by_hand; }},
    Action{.name = "depth",
           .menu = Menu::View,
           .parted = true,
           .label = N_("Depth of the hand"),
           .sentence =
               N_("While you touch, show from the side how deep your hand is, and the energy of forces between atoms"),
           .run = [](App& a) { a.settings.depth_gauge = !a.settings.depth_gauge; },
           .on = [](const App& a) { return a.settings.depth_gauge; }},
    Action{.name = "large-text",
           .menu = Menu::View,
           .label = N_("What is touched in large type"),
           .run = [](App& a) { a.settings.large_state_text = !a.settings.large_state_text; },
           .on = [](const App& a) { return a.settings.large_state_text; }},
    Action{.name = "sound",
           .menu = Menu::View,
           .label = N_("Sound of touch"),
           .sentence = N_("Hear what is touched"),
           .icon = Icon::Sound,
           .tool = 4,
           .run = [](App& a) { a.settings.sound = !a.settings.sound; },
           .on = [](const App& a) { return a.settings.sound; }},
    Action{.name = "expert",
           .menu = Menu::View,
           .label = N_("Expert figures"),
           .sentence = N_("Say below how the touch loop keeps its time, and of how many atoms"),
           .run = [](App& a) { a.settings.expert = !a.settings.expert; },
           .on = [](const App& a) { return a.settings.expert; }},
    Action{.name = "device",
           .menu = Menu::View,
           .parted = true,
           .label = N_("Device …"),
           .shortcut = "Ctrl+D",
           .sentence = N_("The device in your hand: choose it, try it, see its limits"),
           .run = [](App& a) { a.panels.pages.device = true; }},
    Action{.name = "calibrate",
           .menu = Menu::View,
           .label = N_("Calibrate the device"),
           .run = [](App& a) { a.scene.servo().loop().device()->calibrate(); },
           .enabled = [](const App& a) { return a.extensions().device.wantsCalibration(a.scene.servo()); }},
    Action{.name = "stop-force",
           .menu = Menu::View,
           .label = N_("Stop all force"),
           .shortcut = "F9",
           .run = [](App& a) { a.scene.force().stop(!a.scene.servo_settings.panic); },
           .on = [](const App& a) { return a.scene.servo_settings.panic; },
           .while_writing = true},
    Action{.name = "light",
           .menu = Menu::View,
           .parted = true,
           .label = N_("Light"),
           .run = [](App& a) { a.settings.theme = ThemeChoice::Light; },
           .on = [](const App& a) { return a.settings.theme == ThemeChoice::Light; }},
    Action{.name = "dark",
           .menu = Menu::View,
           .label = N_("Dark"),
           .run = [](App& a) { a.settings.theme = ThemeChoice::Dark; },
           .on = [](const App& a) { return a.settings.theme == ThemeChoice::Dark; }},
    Action{.name = "high-contrast",
           .menu = Menu::View,
           .label = N_("High contrast"),
           .run = [](App& a) { a.settings.theme = ThemeChoice::HighContrast; },
           .on = [](const App& a) { return a.settings.theme == ThemeChoice::HighContrast; }},
    Action{.name = "full-screen",
           .menu = Menu::View,
           .label = N_("Full screen"),
           .shortcut = "F11",
           .sentence = N_("Full screen, for a projector"),
           .icon = Icon::FullScreen,
           .tool = 5,
           .run = [](App& a) { a.panels.window.full_screen = !a.panels.window.full_screen; },
           .on = [](const App& a) { return a.panels.window.full_screen; }},

    Action{.name = "next",
           .menu = Menu::Lesson,
           .label = N_("Next step"),
           .shortcut = "Alt+Right",
           .run = [](App& a) { a.lesson.next(); },
           .enabled = [](const App& a) { return inLesson(a) && a.lesson.canGoOn(); }},
    Action{.name = "back",
           .menu = Menu::Lesson,
           .label = N_("Previous step"),
           .shortcut = "Alt+Left",
           .run = [](App& a) { a.lesson.back(); },
           .enabled = [](const App& a) { return inLesson(a) && a.lesson.canGoBack(); }},
    Action{.name = "hand-in",
           .menu = Menu::Lesson,
           .label = N_("Hand in my results …"),
           .sentence = N_("A file of what you have done in this lesson, for your teacher"),
           .run = [](App& a) { handIn(a); },
           .enabled = [](const App& a) { return inLesson(a) && canHandIn(a); }},
    Action{.name = "turns",
           .menu = Menu::Lesson,
           .parted = true,
           .label = N_("Take turns at one device …"),
           .sentence = N_("Turns of set length for a class that shares a device"),
           .run = [](App& a) { a.panels.pages.turns = true; },
           .enabled = [](const App& a) { return !a.extensions().turns.on(); },
           .on = [](const App& a) { return a.extensions().turns.on(); }},
    Action{.name = "class",
           .menu = Menu::Lesson,
           .label = N_("Teach this lesson to a class …"),
           .sentence = N_("Serves the lesson to the students' browsers, and shows you who is where"),
           .run = openClassPage,
           .enabled = [](const App& a) { return canServeClass() && (inLesson(a) || teachesClass()); },
           .on = [](const App&) { return teachesClass(); }},
    Action{.name = "teacher-notes",
           .menu = Menu::Lesson,
           .label = N_("Teacher's notes"),
           .sentence = N_("The lesson's notes for the teacher, among its text, until another student begins"),
           .run = [](App& a) { a.panels.lesson_memory.teacher_notes = !a.panels.lesson_memory.teacher_notes; },
           .enabled = mayTeacherNotes,
           .on = [](const App& a) { return a.panels.lesson_memory.teacher_notes; }},
    Action{.name = "teachers-kit",
           .menu = Menu::Lesson,
           .label = N_("Teacher's kit …"),
           .sentence = N_("Teacher's page, worksheet and exit ticket of this lesson, as a page for printing"),
           .run = [](App& a) { writeTeachersKit(a); },
           .enabled = mayTeachersKit},
    Action{.name = "report",
           .menu = Menu::Lesson,
           .label = N_("Report on a class …"),
           .sentence = N_("A page and a table of all results in a folder, for teachers"),
           .run = [](App& a) { reportOnClass(a); }},

    Action{.name = "controls",
           .menu = Menu::Help,
           .label = N_("Mouse and keys"),
           .shortcut = "F1",
           .also = "?",
           .sentence = N_("What mouse and keys do"),
           .icon = Icon::Question,
           .tool = 5,
           .run = [](App& a) { a.panels.pages.controls = true; }},
    Action{.name = "about",
           .menu = Menu::Help,
           .label = N_("About Moltact"),
           .run = [](App& a) { a.panels.pages.about = true; }},

    Action{.name = "sound-yes",
           .menu = Menu::None,
           .label = N_("Yes, let me hear it"),
           .run = [](App& a) { a.extensions().touch_sound.answer(true); }},
    Action{.name = "sound-no",
           .menu = Menu::None,
           .label = N_("No sound"),
           .run = [](App& a) { a.extensions().touch_sound.answer(false); }},
};

}  // namespace

const char* menuName(Menu menu) {
  static constexpr std::array<const char*, kMenus> kLabels{
      NC_("menu", "File"), NC_("menu", "Edit"), NC_("menu", "View"), NC_("menu", "Lesson"), NC_("menu", "Help")};
  return kLabels[std::size_t(menu)];
}

const char* menuLabel(Menu menu) { return trc("menu", menuName(menu)); }

char menuLetter(Menu menu) {
  // In order, each menu takes the first letter of its label that no earlier menu has taken; without a free one, the first
  // free letter of the alphabet.
  std::string taken;
  for (int k = 0; k <= int(menu); ++k) {
    char letter = 0;
    const std::string label = std::string(menuLabel(Menu(k))) + menuName(Menu(k)) + "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
    for (const char c : label) {
      const auto byte = static_cast<unsigned char>(c);
      if (letter || byte >= 128 || !std::isalpha(byte)) continue;
      const char upper = char(std::toupper(byte));
      if (taken.find(upper) == std::string::npos) letter = upper;
    }
    taken += letter;
  }
  return taken.back();
}

std::span<const Action> allActions() { return kActions; }

const Action* findAction(std::string_view name) {
  const auto found = std::find_if(kActions.begin(), kActions.end(), [&](const Action& a) { return a.name == name; });
  return found == kActions.end() ? nullptr : &*found;
}

bool enabled(const Action& action, const Application& app) { return !action.enabled || action.enabled(app); }

std::string toolTip(const Action& action) {
  std::string text(tr(action.sentence.empty() ? action.label : action.sentence));
  if (!action.shortcut.empty()) text += " (" + keysText(action.shortcut) + ")";
  return text;
}

namespace {

void runShortcuts(Application& app) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool page = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  for (const Action& action : kActions) {
    if ((page || io.WantTextInput) && !action.while_writing) continue;
    if ((keysPressed(action.shortcut) || keysPressed(action.also)) && enabled(action, app)) action.run(app);
  }
  // Escape closes an open page. It also leaves the welcome page, but never a molecule or a lesson.
  if (!page && !io.WantTextInput && !ImGui::IsAnyMouseDown() && app.panels.pages.welcome && app.hasWork() &&
      keysPressed("Escape"))
    findAction("welcome")->run(app);
}

}  // namespace

void runKeys(Application& app) {
  std::string letters;
  for (int menu = 0; menu < kMenus; ++menu) letters += menuLetter(Menu(menu));
  leadByKeys(app.panels, letters);
  runShortcuts(app);
}

}  // namespace moltact
