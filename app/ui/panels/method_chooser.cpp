#include "app/ui/panels/method_chooser.h"

#include <algorithm>
#include <string>
#include <vector>

#include "app/ui/application/application.h"
#include "app/ui/panels/while_locked.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/haptics/field/force_choices.h"
#include "engine/haptics/methods.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

using Field = std::string (*)(const Method&);
std::string familyOf(const Method& m) { return std::string(m.family.name); }
std::string variantOf(const Method& m) { return std::string(m.variant); }

// The distinct values of a field among some methods, in their order.
std::vector<std::string> valuesOf(const std::vector<const Method*>& among, Field field) {
  std::vector<std::string> values;
  for (const Method* m : among)
    if (std::find(values.begin(), values.end(), field(*m)) == values.end()) values.push_back(field(*m));
  return values;
}

std::vector<const Method*> those(const std::vector<const Method*>& among, Field field, std::string_view value) {
  std::vector<const Method*> out;
  for (const Method* m : among)
    if (field(*m) == value) out.push_back(m);
  return out;
}

// Draws one row of segments and reduces `among` to the methods with the chosen value. Returns whether another one was
// chosen.
bool row(const char* name, std::vector<const Method*>& among, Field field, const Method& now) {
  const std::vector<std::string> values = valuesOf(among, field);
  bool changed = false;
  std::size_t chosen = std::size_t(std::find(values.begin(), values.end(), field(now)) - values.begin());
  if (values.size() > 1) changed = segments(name, values, chosen);
  if (chosen < values.size()) among = those(among, field, values[chosen]);
  return changed;
}

// The first method of the middle grade.
const Method* middleOf(const std::vector<const Method*>& among) {
  const std::vector<std::string> grades = valuesOf(among, gradeText);
  return those(among, gradeText, grades[grades.size() / 2]).front();
}

}  // namespace

void drawMethodChooser(Application& app) {
  const Method* now = findMethod(app.scene.touch().method);
  if (!now) return;
  std::vector<const Method*> among;
  for (const Method& m : methods()) among.push_back(&m);
  const Method* next = nullptr;
  const WhileLocked locked(app, "method");
  if (row("method", among, familyOf, *now))
    next = middleOf(among);
  else if (row("grade", among, gradeText, *now))
    next = among.front();
  else if (row("variant", among, variantOf, *now))
    next = among.front();
  {
    WithFont small(Font::Small);
    WithText quiet(look().palette.quiet);
    ImGui::PushTextWrapPos(0.0f);
    std::string text(tr(now->family.plain));
    const bool moves = app.scene.log().latest().motion != 0;
    if (const std::string_view still = motionSentence(*now); moves && !still.empty())
      text.append(" ").append(tr(still));
    else if (moves && forceChoice(app.scene.touch().forces).any())
      text.append(" ").append(tr("The forces between atoms cannot follow them while they move."));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    recordItem("method/sentence", text);
  }
  if (next) useMethod(app.scene, next->name);
}

}  // namespace moltact
