// Downloads an entry of the Protein Data Bank into a folder. Blocks; not for the haptic thread nor the
// window's.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "engine/core/problem.h"

namespace moltact {

struct FetchedEntry {
  std::filesystem::path file;
  std::size_t atoms = 0;   ///< as read by default
  bool was_there = false;  ///< the file lay in the folder already; nothing was downloaded
};

/// Where the archive has the entry: https://files.rcsb.org/download/5ADH.cif.gz.
std::string entryUrl(const std::string& pdb_id);

/// Downloads the entry `id` (see pdb_id.h) to `folder`/ID.cif.gz, which is created where missing. The
/// download goes to a temporary name, is read as a molecule, and only then takes its place. A sound file that
/// lies there already is kept unless `again`. `url`, where not empty, takes the place of the archive's
/// address (a mirror). Ends with a Problem soon after `cancelled` (may be empty) gives true; nothing is left then.
Expected<FetchedEntry> fetchEntry(const std::string& id, const std::filesystem::path& folder,
                                  const std::string& url = {}, bool again = false,
                                  const std::function<bool()>& cancelled = {});

}  // namespace moltact
