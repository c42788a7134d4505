// What a person looks at: study.html, one file that opens from disk, and study.svg for documents.
#pragma once

#include <string>

#include "study/results.h"

namespace penumbra {

// page.html with the figures and pictures inside. Throws Error where page.html is missing.
std::string studyHtml(const StudyResults& results);

// One panel for each scene and light: cost in floors against RMSE, each technique's own front.
std::string studySvg(const StudyResults& results);

}  // namespace penumbra
