// The data of a study as a tidy table, and the codebook that explains it. RFC 4180, UTF-8 with a byte order mark. Names
// of columns and values are English in every language, so that one script reads every table. Any thread but the haptic
// one.
#pragma once

#include <string>

#include "engine/results/study_data.h"

namespace moltact {

/// A row for each student and item: questions (also unanswered ones of a test), tasks, each figure that a task measured,
/// and the measures of each part. docs/study.md lists the columns.
std::string studyCsv(const StudyData& study);

/// A row for each column and each value of a coded column.
std::string studyCodebook();

}  // namespace moltact
