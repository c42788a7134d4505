// Runs an assignment's checks on one variant and weighs them by its rubric.
//
//   GradeRecord grade = gradeVariant(place, handoutVariant(place), {.only = "Task3*"});
//   writeReports(out, grade);          // report.h
//   return exitCode(grade);
#pragma once

#include <set>

#include "core/record.h"
#include "core/rubric.h"
#include "core/variant.h"

namespace penumbra {

struct GradeOptions {
    std::string
        only;  // "Task3*": checks whose name matches; a plain word matches anywhere; "" = all
    bool showProgress = true;      // a line per check on stderr
    bool picturesOfPassed = true;  // in the report; those of failed comparisons are always there
    std::filesystem::path truthCache = {};  // folder (truth_cache.h); "" = none
};

// Every check that this program was compiled with, "Suite.Name".
std::vector<std::string> writtenChecks();

// Throws Error for bad input: a rubric that does not fit, a filter that nothing matches.
GradeRecord gradeVariant(const Place& place, const Variant& variant,
                         const GradeOptions& options = {});

// "Suite.Name" of checks that did not pass.
std::set<std::string> failedChecks(const GradeRecord& grade);

// '*' any text, '?' one character.
bool matches(const std::string& pattern, const std::string& text);

// main() of every N.grade program: see grade_main.cpp.
int gradeMain(int argc, char** argv, const Place& place);

}  // namespace penumbra
