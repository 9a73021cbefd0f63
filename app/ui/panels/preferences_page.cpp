// Edit > Preferences: settings of the user, not of a scene. Every change takes effect at once and is stored.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "app/ui/application/application.h"
#include "app/ui/extensions/lesson_list.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/language/units.h"
#include "engine/platform/folders.h"

namespace moltact {
namespace {

void quietText(const std::string& text) {
  WithFont small(Font::Small);
  WithText quiet(look().palette.quiet);
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

void drawColours(Settings& s) {
  sectionTitle(tr("Colours"));
  static const std::vector<std::string> kThemes{N_("Light"), N_("Dark"), N_("High contrast")};
  std::size_t theme = std::size_t(s.theme);
  if (segments("preferences/theme", kThemes, theme)) s.theme = ThemeChoice(theme);
  toggle("preferences/colour-blind-safe", tr("Atom colours for every kind of colour vision"), s.colour_blind_safe);
}

void drawProbe(Settings& s) {
  sectionTitle(tr("Probe and hand"));
  static const std::vector<std::string> kLooks{N_("Water"), N_("Ball"), N_("Stylus")};
  std::size_t look = std::size_t(s.probe_look);
  if (segments("preferences/probe", kLooks, look)) s.probe_look = ProbeLook(look);
  quietText(tr("A stylus stands where your hand is, beside the water molecule."));
}

void drawSize(Settings& s) {
  sectionTitle(tr("Size of letters"));
  static const std::vector<std::string> kLetters{"100 %", "115 %", "130 %", "150 %"};
  static constexpr double kLetterSizes[] = {1.0, 1.15, 1.3, 1.5};
  std::size_t letters = 0;
  while (letters + 1 < std::size(kLetterSizes) && s.text_size > kLetterSizes[letters] + 0.01) ++letters;
  if (segments("preferences/text-size", kLetters, letters)) s.text_size = kLetterSizes[letters];
  ImGui::Dummy({0, look().px(8)});
  sectionTitle(tr("Size of everything"));
  double percent = std::round(s.scale * 100.0);
  // The page would grow under the pointer, so the size is applied when the button is released.
  static constexpr double kSteps[] = {75, 90, 100, 125, 150, 175, 200, 250, 300};
  std::size_t at = 0;
  for (std::size_t k = 0; k < std::size(kSteps); ++k)
    if (std::abs(kSteps[k] - percent) < std::abs(kSteps[at] - percent)) at = k;
  const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  if (button("preferences/smaller", tr("Smaller"), ButtonLook::Plain, width, at > 0)) s.scale = kSteps[at - 1] / 100.0;
  ImGui::SameLine();
  if (button("preferences/larger", tr("Larger"), ButtonLook::Plain, width, at + 1 < std::size(kSteps)))
    s.scale = kSteps[at + 1] / 100.0;
  const std::string size = quantityText(percent / 100.0, Dimension::Share);
  quietText(trf("{0} of what this display asks for", size));
  recordItem("preferences/size", size);
}

void drawLanguage(Settings& s) {
  sectionTitle(tr("Language"));
  static const std::vector<Language> kLanguages = languages(translationsFolder());
  std::vector<std::string> names{N_("As the system")};
  std::size_t chosen = 0;
  for (const Language& l : kLanguages) {
    if (l.code == s.language) chosen = names.size();
    names.push_back(l.name);
  }
  if (segments("preferences/language", names, chosen)) s.language = chosen == 0 ? "" : kLanguages[chosen - 1].code;
}

void drawNumbers(Settings& s) {
  sectionTitle(tr("Numbers"));
  static const std::vector<std::string> kNumbers{N_("As in the language"), "1.4", "1,4"};
  std::size_t sign = std::size_t(s.decimal_sign);
  if (segments("preferences/numbers", kNumbers, sign)) s.decimal_sign = DecimalSign(sign);
  ImGui::Dummy({0, look().px(8)});
  for (const OfferedDimension& d : offeredDimensions()) {
    sectionTitle(tr(d.title));
    std::vector<std::string> symbols;
    for (const std::string_view symbol : offeredUnits(d.dimension)) symbols.emplace_back(symbol);
    const std::string name(d.name), own(UnitSet().of(d.dimension)->symbol);
    const auto kept = s.units.find(name);
    const std::string& now = kept == s.units.end() ? own : kept->second;
    std::size_t chosen = std::size_t(std::find(symbols.begin(), symbols.end(), now) - symbols.begin());
    if (!segments(("preferences/unit/" + name).c_str(), symbols, chosen)) continue;
    if (symbols[chosen] == own)
      s.units.erase(name);
    else
      s.units[name] = symbols[chosen];
  }
  quietText(tr("The text of a lesson keeps the unit that its author wrote."));
}

void drawOwnLessons(Application& app) {
  sectionTitle(tr("Your own lessons"));
  const std::filesystem::path folder = lessonFolderOf(app.settings);
  quietText(folder.empty() ? tr("No folder is set.") : folder.string());
  recordItem("preferences/lesson-folder", folder.string());
  if (!button("preferences/choose-folder", tr("Choose another folder …"))) return;
  app.panels.pages.preferences = false;
  app.file_dialog.ask({.title = tr("The folder with your lessons"),
                       .chosen =
                           [&app](const std::filesystem::path& chosen) {
                             app.settings.lesson_folder = chosen.string();
                             app.panels.pages.preferences = true;
                           }},
                      folder);
}

}  // namespace

void drawPreferencesPage(Application& app) {
  if (!beginPage("preferences", tr("Preferences"), app.panels.pages.preferences, 520, 740)) return;
  ImGui::BeginChild("list");
  Settings& s = app.settings;
  const auto part = [] { ImGui::Dummy({0, look().px(8)}); };
  drawLanguage(s);
  part();
  drawColours(s);
  part();
  drawSize(s);
  part();
  drawProbe(s);
  part();
  sectionTitle(tr("More than the eye"));
  toggle("preferences/sound", tr("Sound of touch"), s.sound,
         tr("Force as pitch; sliding scrapes, a crease clicks, a pit thuds."));
  if (s.sound) slider("preferences/volume", tr("Volume"), s.sound_volume, 0.0, 1.0, 0.05, {Dimension::Share, {}});
  toggle("preferences/large-text", tr("What is touched in large type"), s.large_state_text);
  toggle("preferences/reduced-motion", tr("Less motion"), s.reduced_motion,
         tr("Another scene is there at once; the view does not glide or fade."));
  part();
  sectionTitle(tr("Mouse"));
  toggle("preferences/left-handed", tr("Left-handed mouse"), s.left_handed,
         tr("Over the molecule the right button pushes and the left one turns."));
  part();
  drawNumbers(s);
  part();
  drawOwnLessons(app);
  ImGui::EndChild();
  endPage();
}

}  // namespace moltact
