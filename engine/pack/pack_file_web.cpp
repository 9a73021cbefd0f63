// The browser edition has no libzip: a pack is refused with what to do instead.
#include "engine/language/catalogue.h"
#include "engine/pack/pack_file.h"
#include "engine/pack/write_pack.h"

namespace moltact {
namespace {

Problem noPacksHere(std::string file) {
  return {std::move(file), 0, 0, tr("the browser edition does not open packs"),
          tr("open it in the installed program, or drop the lesson and its molecules here one by one")};
}

}  // namespace

struct PackFile::Impl {
  std::string name, hash, lesson;
  std::vector<PackEntry> entries;
};

PackFile::PackFile(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
PackFile::PackFile(PackFile&&) noexcept = default;
PackFile& PackFile::operator=(PackFile&&) noexcept = default;
PackFile::~PackFile() = default;

Expected<PackFile> PackFile::open(const std::filesystem::path& file) { return noPacksHere(file.string()); }
Expected<PackFile> PackFile::ofBytes(std::string name, std::string) { return noPacksHere(std::move(name)); }

const std::string& PackFile::name() const { return impl_->name; }
const std::string& PackFile::hash() const { return impl_->hash; }
const std::string& PackFile::lesson() const { return impl_->lesson; }
const std::vector<PackEntry>& PackFile::entries() const { return impl_->entries; }
std::optional<Problem> PackFile::read(const PackEntry&, const Take&) const { return noPacksHere(impl_->name); }
Expected<std::string> PackFile::read(const PackEntry&) const { return noPacksHere(impl_->name); }

Expected<std::string> writePack(const std::string&, const std::map<std::string, std::string>&) {
  return noPacksHere({});
}

}  // namespace moltact
