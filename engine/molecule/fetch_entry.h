// Downloads an entry of the Protein Data Bank into a folder. Blocks; not for the haptic thread or the window's thread.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "engine/core/problem.h"

namespace moltact {

struct FetchedEntry {
  std::filesystem::path file;
  std::size_t atoms = 0;   ///< as read by default
  bool was_there = false;  ///< the file existed already; nothing was downloaded
};

/// The address of the entry in the archive: https://files.rcsb.org/download/5ADH.cif.gz.
std::string entryUrl(const std::string& pdb_id);

/// Downloads the entry `id` (see pdb_id.h) to `folder`/ID.cif.gz; creates the folder if it is missing. The download
/// gets a temporary name, is read as a molecule and then renamed. An existing valid file is kept unless `again`. A
/// nonempty `url` replaces the archive's address (a mirror). Ends with a Problem soon after `cancelled` (may be empty)
/// returns true, and leaves nothing behind.
Expected<FetchedEntry> fetchEntry(const std::string& id, const std::filesystem::path& folder,
                                  const std::string& url = {}, bool again = false,
                                  const std::function<bool()>& cancelled = {});

}  // namespace moltact
