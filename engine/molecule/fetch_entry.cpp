#include "engine/molecule/fetch_entry.h"

#include "engine/language/catalogue.h"
#include "engine/molecule/pdb_id.h"
#include "engine/molecule/reader.h"
#include "engine/platform/download.h"
#include "engine/platform/file_guard.h"
#include "engine/platform/write_file.h"

namespace moltact {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMaxDownloadBytes = std::size_t{1} << 30;

Problem downloadProblem(const DownloadResult& result, const std::string& id, const std::string& url,
                        const fs::path& file) {
  switch (result.failure) {
    case DownloadFailure::NotFound:
      return {id, 0, 0, trf("the Protein Data Bank has no such entry (tried {0})", url),
              tr("check the id at www.rcsb.org")};
    case DownloadFailure::Cancelled:
      return {id, 0, 0, tr("broken off; nothing was kept of it"), ""};
    case DownloadFailure::TooLarge:
      return {id, 0, 0, trf("the entry is larger than 1 GiB ({0})", url), tr("take a smaller entry")};
    case DownloadFailure::Refused:
      return {id, 0, 0, trf("the server refused {0}: {1}", url, result.detail),
              trf("try again later, or download the file by hand and put it at {0}", file.string())};
    default:
      return {id, 0, 0, trf("cannot reach {0}: {1}", url, result.detail),
              trf("are you online? Otherwise download the file on another computer and put it at {0}", file.string())};
  }
}

}  // namespace

std::string entryUrl(const std::string& pdb_id) { return "https://files.rcsb.org/download/" + pdb_id + ".cif.gz"; }

Expected<FetchedEntry> fetchEntry(const std::string& text, const fs::path& folder, const std::string& mirror,
                                  bool again, const std::function<bool()>& cancelled) {
  const std::string id = pdbId(text);
  if (id.empty())
    return Problem{text, 0, 0, tr("it is not an id of the Protein Data Bank"),
                   tr("an id is a digit and three letters or digits (5ADH), or pdb_ and eight")};
  if (folder.empty())
    return Problem{"", 0, 0, tr("there is no home folder to keep the entry in"), tr("set HOME or XDG_DATA_HOME")};
  const fs::path file = folder / (id + ".cif.gz");
  if (constexpr std::string_view kLocal = "file://";
      mirror.starts_with(kLocal) && sameFile(mirror.substr(kLocal.size()), file))
    return Problem{mirror, 0, 0, tr("the entry would be copied onto itself"), tr("name another file with --url")};
  std::error_code error;
  if (!again && fs::exists(file, error))
    if (auto there = readMolecule(file)) return FetchedEntry{file, there->atoms.size(), true};
  fs::create_directories(folder, error);
  if (error)
    return Problem{folder.string(), 0, 0, trf("the folder cannot be created: {0}", error.message()),
                   tr("set XDG_DATA_HOME to a folder that can be written")};
  const auto unwritten = [](Problem problem) {
    problem.remedy = trf("{0}, or set XDG_DATA_HOME to another folder", problem.remedy);
    return problem;
  };
  Expected<Draft> draft = Draft::begin(file, IfThere::Renew);
  if (!draft) return unwritten(draft.problem());
  const std::string url = mirror.empty() ? entryUrl(id) : mirror;
  std::optional<Problem> problem;
  const auto take = [&](std::string_view bytes) { return !(problem = draft->append(bytes)); };
  const DownloadResult result = download(url, kMaxDownloadBytes, take, cancelled);
  if (result.failure == DownloadFailure::None) problem = draft->flush();
  if (problem) return unwritten(*problem);
  if (result.failure != DownloadFailure::None) return downloadProblem(result, id, url, file);
  // The draft's name has the final ending, because the reader selects the format by it.
  auto molecule = readMolecule(draft->path());
  if (!molecule)
    return Problem{id, 0, 0, trf("what came from {0} cannot be read: {1}", url, molecule.problem().message),
                   tr("try again later")};
  if ((problem = draft->commit())) return unwritten(*problem);
  return FetchedEntry{file, molecule->atoms.size(), false};
}

}  // namespace moltact
