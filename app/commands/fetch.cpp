// moltact fetch ID: downloads an entry of the Protein Data Bank into the user's data folder.
#include <memory>

#include "app/commands/command.h"
#include "engine/molecule/fetch_entry.h"
#include "engine/molecule/pdb_id.h"
#include "engine/platform/folders.h"
#include "engine/platform/interrupt.h"
#include "engine/platform/terminal.h"

namespace moltact {
namespace {

struct FetchArguments {
  std::string id, url;
  bool again = false;
};

void run(const FetchArguments& arguments) {
  const InterruptWatch interrupt;
  const auto entry =
      fetchEntry(arguments.id, userMoleculesFolder(), arguments.url, arguments.again, [&] { return interrupt.seen(); });
  if (!entry) throw CommandError{entry.problem().text(), interrupt.seen() ? 130 : 1};
  out() << entry->file.string() << ": " << entry->atoms << " atoms" << (entry->was_there ? ", here already" : "")
        << "\nOpen it by its name: moltact info " << pdbId(arguments.id) << '\n';
}

}  // namespace

void addFetch(CLI::App& app) {
  auto arguments = std::make_shared<FetchArguments>();
  CLI::App* command = app.add_subcommand("fetch", "Download an entry of the Protein Data Bank (needs the internet)");
  command->add_option("id", arguments->id, "The entry's id, such as 5ADH or pdb_00005adh")->required();
  command->add_flag("--again", arguments->again, "Download even if the file exists already");
  command->add_option("--url", arguments->url,
                      "Download the file from this address instead: a mirror (https, http or file)");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace moltact
