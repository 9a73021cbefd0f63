// A lesson for a learning platform: one zip with the browser edition, the pack in it and a manifest, as SCORM 1.2, SCORM
// 2004 4th edition or cmi5 (docs/learning-platforms.md). Any thread except the haptic one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"

namespace moltact {

enum class LearningPlatform { Scorm12, Scorm2004, Cmi5 };

/// "1.2", "2004" or "cmi5": the attribute data-platform of the page.
std::string_view nameOf(LearningPlatform platform);
/// The name of the manifest's file, in the zip's top folder.
std::string_view manifestName(LearningPlatform platform);

struct PlatformCourse {
  std::string name;         ///< the lesson's file name without ending
  std::string title;        ///< plain text
  std::string description;  ///< one line; may be empty
  std::string language;     ///< "de"; empty: not known
  std::vector<std::string> goals;
};

/// The identifier of a lesson in statements to a record store, which depends on its name and title only:
/// "urn:uuid:…" (RFC 9562, version 8).
std::string lessonIri(const PlatformCourse& course);

std::string platformManifest(LearningPlatform platform, const PlatformCourse& course);

/// The zip. `page`: the text of the browser edition, read from `page_file`. Returns a Problem if that is not a browser
/// edition, already contains a lesson, or is one of an earlier version that knows no platform.
Expected<std::string> platformZip(LearningPlatform platform, const PlatformCourse& course, std::string page,
                                  const std::string& page_file, std::string_view pack);

}  // namespace moltact
