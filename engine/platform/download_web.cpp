// A page waits for nothing, so nothing is downloaded from inside the program: what an address in its own address bar asks
// for is fetched by page.js.
#include "engine/language/catalogue.h"
#include "engine/platform/download.h"

namespace moltact {

DownloadResult download(const std::string&, std::size_t, const std::function<bool(std::string_view)>&,
                        const std::function<bool()>&) {
  return {DownloadFailure::Offline, tr("a page downloads nothing by itself")};
}

}  // namespace moltact
