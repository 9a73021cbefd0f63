// Between the files of this folder.
#pragma once

namespace moltact {

/// The language or the decimal sign is another one from here on.
void languageChanged() noexcept;

}  // namespace moltact
