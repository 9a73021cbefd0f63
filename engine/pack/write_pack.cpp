#include "engine/pack/write_pack.h"

#include <zip.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/pack/pack_file.h"

namespace moltact {
namespace {

constexpr zip_uint16_t kDate = 1 << 5 | 1, kTime = 0;  // 1 January 1980, the first date of the format
constexpr zip_uint32_t kOrdinaryFile = 0100644u << 16, kBestDeflate = 9;

// Compressed formats do not become smaller.
bool isCompressed(const std::string& name) {
  const std::string in_small = lower(name);
  for (const char* ending : {".gz", ".png", ".jpg", ".jpeg", ".zip"})
    if (in_small.ends_with(ending)) return true;
  return false;
}

Problem cannot(const char* why) {
  return {{}, 0, 0, trf("the pack cannot be made: {0}", why), tr("close other programs, or pack fewer files")};
}

// libzip in Debian 12 and 13 keeps the order in which files are added.
bool add(zip_t* zip, const std::string& name, const std::string& bytes) {
  zip_source_t* source = zip_source_buffer(zip, bytes.data(), bytes.size(), 0);
  if (!source) return false;
  const zip_int64_t index = zip_file_add(zip, name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip_source_free(source);
    return false;
  }
  const auto at = zip_uint64_t(index);
  const bool store = isCompressed(name);
  return zip_set_file_compression(zip, at, store ? ZIP_CM_STORE : ZIP_CM_DEFLATE, store ? 0 : kBestDeflate) == 0 &&
         zip_file_set_dostime(zip, at, kTime, kDate, 0) == 0 &&
         zip_file_set_external_attributes(zip, at, 0, ZIP_OPSYS_UNIX, kOrdinaryFile) == 0;
}

}  // namespace

Expected<std::string> writePack(const std::string& lesson, const std::map<std::string, std::string>& files) {
  const std::string manifest = nlohmann::ordered_json{{"format", kPackFormat}, {"lesson", lesson}}.dump(
                                   2, ' ', false, nlohmann::json::error_handler_t::replace) +
                               '\n';
  // The manifest first, so that programs can recognize the format by the file's beginning.
  std::vector<std::pair<std::string, std::string>> all{{kPackManifest, manifest}};
  all.insert(all.end(), files.begin(), files.end());
  return writeZip(all);
}

Expected<std::string> writeZip(const std::vector<std::pair<std::string, std::string>>& files) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* memory = zip_source_buffer_create(nullptr, 0, 0, &error);
  if (!memory) return cannot(zip_error_strerror(&error));
  zip_source_keep(memory);
  zip_t* zip = zip_open_from_source(memory, ZIP_CREATE | ZIP_TRUNCATE, &error);
  if (!zip) {
    zip_source_free(memory);
    zip_source_free(memory);
    return cannot(zip_error_strerror(&error));
  }
  bool good = true;
  for (const auto& [name, bytes] : files) good = good && add(zip, name, bytes);
  if (!good || zip_close(zip) != 0) {
    Problem problem = cannot(zip_strerror(zip));
    zip_discard(zip);
    zip_source_free(memory);
    return problem;
  }
  std::string bytes;
  zip_stat_t written;
  zip_stat_init(&written);
  good = zip_source_open(memory) == 0 && zip_source_stat(memory, &written) == 0;
  if (good) {
    bytes.resize(std::size_t(written.size));
    good = zip_source_read(memory, bytes.data(), bytes.size()) == zip_int64_t(bytes.size());
    zip_source_close(memory);
  }
  Problem problem = cannot(zip_error_strerror(zip_source_error(memory)));
  zip_source_free(memory);
  if (!good) return problem;
  return bytes;
}

}  // namespace moltact
