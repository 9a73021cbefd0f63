#include "app/ui/panels/pose_list.h"

#include <filesystem>
#include <string>
#include <vector>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/view_overlays.h"
#include "app/ui/widgets/clock_text.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/rich_text.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/platform/hand_over.h"
#include "engine/platform/write_file.h"

namespace moltact {
namespace {

bool mayShowPoses(const Application& app) { return app.extensions().held_poses.on() && mayNameAtoms(app); }

std::string poseEnergy(const HeldPose& pose) { return numberText(pose.energy.total_kcal_mol(), decimals(1)); }

void savePose(Application& app, const std::filesystem::path& file) {
  const Expected<std::string> text = app.extensions().held_poses.saved(lower(file.extension().string()));
  if (!text) return app.messages.error(text.problem().text());
  if (const auto problem = writeWhole(file, *text)) return app.messages.error(problem->text());
  handOver(file);
  app.messages.notice(trf("Pose saved as {0}", file.string()));
}

void askForPoseFile(Application& app, const char* ending) {
  app.file_dialog.ask(
      {.title = tr("Save the pose"),
       .name = app.scene.molecule().file.stem().string() + "-pose" + ending,
       .ending = ending,
       .chosen = [&app](const std::filesystem::path& file) { savePose(app, file); },
       .other_ending = ".sdf",
       .note = tr("A name that ends in .sdf saves an SD file with bonds and charges, .pdb a PDB file.")},
      app.options().picture_folder);
}

// The columns: energy and distance end at these shares of the width, the time at the right.
constexpr float kEnergyEnds = 0.26f, kOffEnds = 0.56f;

void poseColumns(ImVec2 low, float width, ImU32 colour, const std::string& energy, const std::string& off,
                 const std::string& time) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const auto endingAt = [&](float x, const std::string& text) {
    draw->AddText({low.x + x - ImGui::CalcTextSize(text.c_str()).x, low.y}, colour, text.c_str());
  };
  endingAt(kEnergyEnds * width, energy);
  endingAt(kOffEnds * width, off);
  endingAt(width, time);
}

void poseRow(HeldPoses& poses, std::size_t index) {
  const Look& l = look();
  const HeldPose& pose = poses.list()[index];
  const bool selected = poses.selected() == index;
  const std::string name = "pose/" + std::to_string(index), energy = poseEnergy(pose),
                    off = numberText(poses.offKnown_A(pose), decimals(2)),
                    time = pose.minimised ? std::string(tr("minimised")) : clockText(int(pose.time_s));
  const float width = ImGui::GetContentRegionAvail().x, pad = l.px(6), high = ImGui::GetTextLineHeight() + l.px(6);
  ImGui::PushID(name.c_str());
  if (ImGui::InvisibleButton("row", {width, high})) poses.select(selected ? std::nullopt : std::optional(index));
  ImGui::PopID();
  const ImVec2 low = ImGui::GetItemRectMin(), end = ImGui::GetItemRectMax();
  if (selected || ImGui::IsItemHovered())
    ImGui::GetWindowDrawList()->AddRectFilled(low, end, selected ? l.palette.accent_soft : l.palette.pressed, l.px(4));
  poseColumns({low.x + pad, low.y + l.px(3)}, width - 2 * pad, l.palette.text, energy, off, time);
  recordItem(name, energyBetweenAtoms(pose.energy.total_kcal_mol(), decimals(1)) + ", " + off + " Å, " + time);
}

void quietPoseLine(const char* name, const std::string& text) {
  const WithText quiet(look().palette.quiet);
  ImGui::TextUnformatted(wrapped(text, ImGui::GetContentRegionAvail().x).c_str());
  recordItem(name, text);
}

void drawPoseList(HeldPoses& poses) {
  const Look& l = look();
  const WithFont small(Font::Small);
  if (poses.list().empty())
    return quietPoseLine("poses", tr("A pose is listed when the body rests at a negative energy lower than before."));
  const float pad = l.px(6), width = ImGui::GetContentRegionAvail().x;
  const ImVec2 low = ImGui::GetCursorScreenPos();
  poseColumns({low.x + pad, low.y}, width - 2 * pad, l.palette.quiet, tr("kcal/mol"), tr("Å off"), tr("time"));
  ImGui::Dummy({width, ImGui::GetTextLineHeight()});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {l.px(8), 0.0f});
  for (std::size_t k = 0; k < poses.list().size(); ++k) poseRow(poses, k);
  ImGui::PopStyleVar();
  ImGui::Dummy({width, l.px(2)});
  quietPoseLine("poses", poses.taskNamesPose()
                             ? tr("Å off: root mean square distance of the atoms from the pose of the task.")
                             : tr("Å off: root mean square distance of the atoms from the pose of the file."));
}

void drawSelectedPose(Application& app, HeldPoses& poses) {
  if (!poses.selected() || *poses.selected() >= poses.list().size()) return;
  if (button("poses/save", tr("Save the pose …"), ButtonLook::Plain, -1.0f)) askForPoseFile(app, ".pdb");
  // A page hands over one file at once, without a question for its name.
  if (filesAreHandedOver() && button("poses/save-sdf", tr("Save the pose as SDF"), ButtonLook::Plain, -1.0f))
    askForPoseFile(app, ".sdf");
  if (!poses.list()[*poses.selected()].minimised) {
    if (button("poses/take", tr("Back to this pose"), ButtonLook::Plain, -1.0f, poses.canTake())) poses.take();
    if (app.scene.servo().deviceLeads()) {
      const WithFont small(Font::Small);
      quietPoseLine("poses/device", tr("Your hand stays where it is: the view turns until it holds the body so."));
    }
  }
}

void drawPoseMinimum(HeldPoses& poses) {
  const auto& found = poses.minimum();
  const bool idle = !found || found->done, selected = poses.selected().has_value();
  if (button("poses/minimise", selected ? tr("Minimise from this pose") : tr("Minimise from here"), ButtonLook::Plain,
             -1.0f, idle))
    poses.minimise();
  tip(
      tr("Searches the energy minimum below the selected pose, or else below the present one. The body in the hand "
         "does not "
         "move."));
  if (!found) return;
  {
    const WithFont small(Font::Small);
    const std::string from = energyBetweenAtoms(found->from.energy.total_kcal_mol(), decimals(1)),
                      to = energyBetweenAtoms(found->to.energy.total_kcal_mol(), decimals(1));
    std::string text = !found->done ? trf("Step {0}: {1}", found->steps, to)
                                    : trf("From {0}. Minimum: {1}, {2} Å away, after {3} steps.", from, to,
                                          numberText(poses.movedByMinimum_A(), decimals(2)), found->steps);
    if (found->done && !found->converged) text += std::string(" ") + tr("It would fall further with more steps.");
    quietPoseLine("poses/minimum", text);
  }
  if (found->done && !found->listed && button("poses/add", tr("Add to the list"), ButtonLook::Plain, -1.0f))
    poses.addMinimum();
}

}  // namespace

void drawPoses(Application& app) {
  if (!mayShowPoses(app)) return;
  HeldPoses& poses = app.extensions().held_poses;
  ImGui::Spacing();
  sectionTitle(tr("Poses"));
  drawPoseList(poses);
  drawSelectedPose(app, poses);
  drawPoseMinimum(poses);
}

void showPose(const Application& app, ViewScene& scene) {
  if (!mayShowPoses(app) || !scene.body) return;
  if (const auto pose = app.extensions().held_poses.marked()) {
    scene.marked_place = pose->place;
    scene.marked_orientation = pose->orientation;
  }
}

}  // namespace moltact
