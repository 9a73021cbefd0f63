// A page must not block, so the program itself downloads nothing; page.js fetches what the address in the address bar
// requests.
#include "engine/language/catalogue.h"
#include "engine/platform/download.h"

namespace moltact {

DownloadResult download(const std::string&, std::size_t, const std::function<bool(std::string_view)>&,
                        const std::function<bool()>&) {
  return {DownloadFailure::Offline, tr("a page downloads nothing by itself")};
}

}  // namespace moltact
