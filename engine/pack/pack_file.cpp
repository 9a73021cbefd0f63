#include "engine/pack/pack_file.h"

#include <zip.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/core/content_hash.h"
#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/pack/pack_name.h"
#include "engine/platform/read_file.h"

namespace moltact {
namespace {

constexpr std::size_t kPiece = std::size_t{64} << 10;
// The signature of every entry of a zip's directory. If there are far more than allowed, the directory is not read.
constexpr std::string_view kDirectoryEntry = "PK\1\2";

std::string handOutAgain() { return tr("ask for the file again, or have it packed again with 'moltact pack'"); }

std::size_t count(std::string_view bytes, std::string_view what) {
  std::size_t n = 0;
  for (std::size_t at = bytes.find(what); at != std::string_view::npos; at = bytes.find(what, at + what.size())) ++n;
  return n;
}

}  // namespace

struct PackFile::Impl {
  std::string name, bytes, hash, lesson;
  zip_t* zip = nullptr;
  struct Found {
    PackEntry entry;
    zip_uint64_t index = 0;
  };
  std::vector<Found> files;  // by name
  std::vector<PackEntry> entries;

  ~Impl() {
    if (zip) zip_discard(zip);
  }

  Problem problem(std::string message, std::string remedy = handOutAgain()) const {
    return {name, 0, 0, std::move(message), std::move(remedy)};
  }
  Problem tooManyEntries() const {
    return problem(trf("it holds more than {0} files", kMaxPackEntries), tr("pack fewer of them"));
  }

  std::optional<Problem> openZip() {
    if (bytes.size() > kMaxPackBytes)
      return problem(trf("it is larger than {0} MiB", kMaxPackBytes >> 20), tr("pack smaller molecules"));
    if (count(bytes, kDirectoryEntry) > 4 * kMaxPackEntries) return tooManyEntries();
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
    if (source) zip = zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error);
    if (source && !zip) zip_source_free(source);
    std::optional<Problem> fault;
    if (!zip) fault = problem(trf("it is no pack, or is cut off or damaged: {0}", zip_error_strerror(&error)));
    zip_error_fini(&error);
    return fault;
  }

  /// Checks the stated properties of one entry; `found` stays empty for a folder.
  std::optional<Problem> look(zip_uint64_t index, std::optional<Found>& found) {
    const char* raw = zip_get_name(zip, index, ZIP_FL_ENC_RAW);
    if (!raw) return problem(tr("the name of a file in it cannot be read"));
    std::string_view written = raw;
    const bool folder = written.ends_with('/');
    if (folder) written.remove_suffix(1);
    if (const std::string fault = packNameFault(written); !fault.empty())
      return problem(trf("the name '{0}' in it {1}", written, fault));
    zip_stat_t stat;
    zip_stat_init(&stat);
    constexpr zip_uint64_t kNeeded =
        ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_COMP_METHOD | ZIP_STAT_ENCRYPTION_METHOD;
    if (zip_stat_index(zip, index, 0, &stat) != 0 || (stat.valid & kNeeded) != kNeeded)
      return problem(trf("'{0}' in it cannot be read: {1}", written, zip_strerror(zip)));
    if (stat.encryption_method != ZIP_EM_NONE)
      return problem(trf("'{0}' in it is encrypted", written), tr("have it packed without a password"));
    zip_uint8_t system = ZIP_OPSYS_DOS;
    zip_uint32_t attributes = 0;
    zip_file_get_external_attributes(zip, index, 0, &system, &attributes);
    constexpr zip_uint32_t kKind = 0170000, kFile = 0100000, kFolder = 0040000;  // file types in a Unix mode
    // Other systems may also have written a mode, and some readers use it.
    const zip_uint32_t kind = attributes >> 16 & kKind;
    if (kind != 0 && kind != (folder ? kFolder : kFile))
      return problem(trf("'{0}' in it is a link or no ordinary file", written), tr("have the files themselves packed"));
    if (folder) return std::nullopt;
    if (stat.comp_method != ZIP_CM_STORE && stat.comp_method != ZIP_CM_DEFLATE)
      return problem(trf("'{0}' in it is compressed by a method that this program does not read", written));
    if (stat.size > kMaxUnpacked) return tooLarge();
    if (stat.size > kSmallUnpacked && stat.size / kMaxPackRatio > stat.comp_size)
      return problem(trf("'{0}' in it would grow to more than {1} times its size", written, kMaxPackRatio));
    found = Found{{std::string(written), std::size_t(stat.size)}, index};
    return std::nullopt;
  }

  Problem tooLarge() const {
    return problem(trf("its files would take more than {0} MiB", kMaxUnpacked >> 20), tr("pack smaller molecules"));
  }

  std::optional<Problem> lookAtAll() {
    const zip_int64_t entry_count = zip_get_num_entries(zip, 0);
    if (entry_count > zip_int64_t(kMaxPackEntries)) return tooManyEntries();
    std::size_t whole = 0;
    std::set<std::string> names, folders;  // folded for case-insensitive systems
    for (zip_int64_t k = 0; k < entry_count; ++k) {
      std::optional<Found> found;
      if (auto fault = look(zip_uint64_t(k), found)) return fault;
      if (!found) continue;
      whole += found->entry.bytes;
      if (whole > kMaxUnpacked) return tooLarge();
      const std::string folded = foldedPackName(found->entry.name);
      if (!names.insert(folded).second) return problem(trf("it holds '{0}' twice", found->entry.name));
      for (std::size_t slash = folded.find('/'); slash != std::string::npos; slash = folded.find('/', slash + 1))
        folders.insert(folded.substr(0, slash));
      files.push_back(*std::move(found));
    }
    for (const Found& f : files)
      if (folders.contains(foldedPackName(f.entry.name)))
        return problem(trf("'{0}' in it is a file and a folder", f.entry.name));
    std::sort(files.begin(), files.end(), [](const Found& a, const Found& b) { return a.entry.name < b.entry.name; });
    return std::nullopt;
  }

  const Found* find(std::string_view wanted) const {
    const auto at = std::lower_bound(files.begin(), files.end(), wanted,
                                     [](const Found& f, std::string_view n) { return f.entry.name < n; });
    return at != files.end() && at->entry.name == wanted ? &*at : nullptr;
  }

  std::optional<Problem> read(const Found& file, const Take& take) const {
    const auto damaged = [&](const char* why) {
      return problem(trf("'{0}' in it is damaged: {1}", file.entry.name, why));
    };
    const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> in(zip_fopen_index(zip, file.index, 0), zip_fclose);
    if (!in) return damaged(zip_strerror(zip));
    std::vector<char> piece(kPiece);
    for (std::size_t left = file.entry.bytes;;) {
      const zip_int64_t n = zip_fread(in.get(), piece.data(), piece.size());
      if (n < 0) return damaged(zip_file_strerror(in.get()));
      if (n == 0 && left == 0) return std::nullopt;
      if (n == 0 || std::size_t(n) > left)
        return damaged(tr("its size is not the one that the directory of the zip states"));
      left -= std::size_t(n);
      if (auto fault = take({piece.data(), std::size_t(n)})) return fault;
    }
  }

  std::optional<Problem> readManifest() {
    const Found* manifest = find(kPackManifest);
    if (!manifest)
      return problem(trf("it is a zip, but no pack of a lesson: there is no '{0}' in it", kPackManifest),
                     tr("unpack it yourself and open what it holds, or have the lesson packed with 'moltact pack'"));
    if (manifest->entry.bytes > kMaxPackManifestBytes)
      return problem(trf("'{0}' in it is larger than {1} bytes", kPackManifest, kMaxPackManifestBytes));
    std::string text;
    if (auto fault = read(*manifest, [&](std::string_view piece) {
          text += piece;
          return std::nullopt;
        }))
      return fault;
    const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
    const auto wrong = [&] {
      return problem(trf("'{0}' in it does not name its format and its lesson", kPackManifest));
    };
    if (!json.is_object()) return wrong();
    const auto format = json.find("format"), first = json.find("lesson");
    if (format == json.end() || !format->is_number_integer() || first == json.end() || !first->is_string())
      return wrong();
    if (*format != kPackFormat)
      return problem(trf("it is a pack of format {0}, which this program does not know", format->dump()),
                     tr("open it with a newer Moltact"));
    lesson = first->get<std::string>();
    if (!find(lesson) || lesson.find('/') != std::string::npos ||
        lower(std::filesystem::path(lesson).extension().string()) != ".md")
      return problem(trf("the lesson '{0}' that it names is not in it", lesson));
    return std::nullopt;
  }
};

PackFile::PackFile(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
PackFile::PackFile(PackFile&&) noexcept = default;
PackFile& PackFile::operator=(PackFile&&) noexcept = default;
PackFile::~PackFile() = default;

Expected<PackFile> PackFile::open(const std::filesystem::path& file) {
  Expected<std::string> bytes = readFile(file, kMaxPackBytes, tr("pack smaller molecules"));
  if (!bytes) return bytes.problem();
  return ofBytes(file.string(), *std::move(bytes));
}

Expected<PackFile> PackFile::ofBytes(std::string name, std::string bytes) {
  auto impl = std::make_unique<Impl>();
  impl->name = std::move(name);
  impl->bytes = std::move(bytes);
  if (auto fault = impl->openZip()) return *std::move(fault);
  if (auto fault = impl->lookAtAll()) return *std::move(fault);
  if (auto fault = impl->readManifest()) return *std::move(fault);
  impl->hash = contentHash(impl->bytes);
  for (const Impl::Found& f : impl->files)
    if (f.entry.name != kPackManifest) impl->entries.push_back(f.entry);
  return PackFile(std::move(impl));
}

const std::string& PackFile::name() const { return impl_->name; }
const std::string& PackFile::hash() const { return impl_->hash; }
const std::string& PackFile::lesson() const { return impl_->lesson; }
const std::vector<PackEntry>& PackFile::entries() const { return impl_->entries; }

std::optional<Problem> PackFile::read(const PackEntry& entry, const Take& take) const {
  const Impl::Found* file = impl_->find(entry.name);
  if (!file) return impl_->problem(trf("there is no '{0}' in it", entry.name));
  return impl_->read(*file, take);
}

Expected<std::string> PackFile::read(const PackEntry& entry) const {
  std::string bytes;
  if (auto fault = read(entry, [&](std::string_view piece) {
        bytes += piece;
        return std::optional<Problem>();
      }))
    return *std::move(fault);
  return bytes;
}

}  // namespace moltact
