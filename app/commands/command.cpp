#include "app/commands/command.h"

#include "app/commands/language_option.h"

namespace moltact {

void addBench(CLI::App& app);
void addCheck(CLI::App& app);
void addDevice(CLI::App& app);
void addDevices(CLI::App& app);
void addExport(CLI::App& app);
void addFetch(CLI::App& app);
void addInfo(CLI::App& app);
void addLessonReference(CLI::App& app);
void addNewLesson(CLI::App& app);
void addPlay(CLI::App& app);
void addRender(CLI::App& app);
void addReplay(CLI::App& app);
void addReport(CLI::App& app);

void addAllCommands(CLI::App& app) {
  addInfo(app);
  addReplay(app);
  addPlay(app);
  addRender(app);
  addExport(app);
  addFetch(app);
  addReport(app);
  addBench(app);
  addDevices(app);
  addDevice(app);
  addCheck(app);
  addNewLesson(app);
  addLessonReference(app);
  for (CLI::App* command : app.get_subcommands({})) addLanguageOption(*command);
}

}  // namespace moltact
