#include "app/ui/panels/method_chooser.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "app/ui/application.h"
#include "app/ui/panels/while_locked.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/haptics/mesh/sphere_mesh.h"
#include "engine/haptics/methods.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

struct FamilyText {
  std::string_view family, sentence;
};
constexpr std::array kTexts{
    FamilyText{"Exact", N_("Follows the spheres themselves, without error.")},
    FamilyText{"Paper", N_("The steps of Stocks and Laycock, 2008, as they were published.")},
    FamilyText{"Mesh", N_("Triangles stand in for each sphere. The fewer there are, the more you feel their edges.")},
    FamilyText{"Grid", N_("Distances are stored on a grid. The wider apart, the rounder its creases become.")},
    FamilyText{"Penalty", N_("Each atom pushes for itself, and nothing remembers from which side you came.")},
};

std::string plainSentence(const Method& m) {
  for (const FamilyText& t : kTexts)
    if (t.family == m.family) return std::string(tr(t.sentence));
  return std::string(tr(m.sentence));
}

using Field = std::string_view Method::*;

// The different values of a field among some methods, in their order.
std::vector<std::string> valuesOf(const std::vector<const Method*>& among, Field field) {
  std::vector<std::string> values;
  for (const Method* m : among)
    if (std::find(values.begin(), values.end(), m->*field) == values.end()) values.emplace_back(m->*field);
  return values;
}

std::vector<const Method*> those(const std::vector<const Method*>& among, Field field, std::string_view value) {
  std::vector<const Method*> out;
  for (const Method* m : among)
    if (m->*field == value) out.push_back(m);
  return out;
}

// One row of segments; `among` becomes the methods of the chosen value. True when another was chosen.
bool row(const char* name, std::vector<const Method*>& among, Field field, const Method& now) {
  const std::vector<std::string> values = valuesOf(among, field);
  bool changed = false;
  std::size_t chosen = std::size_t(std::find(values.begin(), values.end(), now.*field) - values.begin());
  if (values.size() > 1) changed = segments(name, values, chosen);
  if (chosen < values.size()) among = those(among, field, values[chosen]);
  return changed;
}

// The middle grade, and of that the first: neither the crudest nor the finest.
const Method* middleOf(const std::vector<const Method*>& among) {
  const std::vector<std::string> grades = valuesOf(among, &Method::grade);
  return those(among, &Method::grade, grades[grades.size() / 2]).front();
}

}  // namespace

void drawMethodChooser(Application& app) {
  const Method* now = findMethod(app.scene.method());
  if (!now) return;
  std::vector<const Method*> among;
  for (const Method& m : methods()) among.push_back(&m);
  const Method* next = nullptr;
  const WhileLocked locked(app, "method");
  if (row("method", among, &Method::family, *now))
    next = middleOf(among);
  else if (row("grade", among, &Method::grade, *now))
    next = among.front();
  else if (row("variant", among, &Method::variant, *now))
    next = among.front();
  {
    WithFont small(Font::Small);
    WithText quiet(look().palette.quiet);
    ImGui::PushTextWrapPos(0.0f);
    const std::string text = plainSentence(*now);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    recordItem("method/sentence", text);
  }
  if (next) app.scene.useMethod(next->name);
}

void drawTouchHead(Application& app) {
  if (!app.panels.methods) {
    WithFont title(Font::Title);
    ImGui::TextUnformatted(tr("Touch"));
    return;
  }
  const std::vector<std::string> tabs{N_("Touch"), N_("Methods")};
  std::size_t front = app.panels.methods_first ? 1 : 0;
  if (segments("tab", tabs, front)) app.panels.methods_first = front == 1;
}

std::shared_ptr<const SphereMesh> feltFacets(std::string_view method) {
  const Method* m = findMethod(method);
  return m && m->triangles > 0 ? SphereMesh::ofTriangles(m->triangles) : nullptr;
}

}  // namespace moltact
