// A grading run on paper: results.json (Gradescope), junit.xml, report.html and a table.
//
//   prepareOut(out);             // removes an earlier run's reports
//   writeReports(out, grade);    // all three, whole or not at all
//   printTable(grade, out);
#pragma once

#include <filesystem>
#include <string>

#include "core/record.h"

namespace penumbra {

// Makes the folder; an old report must not survive a run that fails. Throws Error.
void prepareOut(const std::filesystem::path& out);

// Written beside each other under a temporary name, then renamed. Throws Error.
void writeReports(const std::filesystem::path& out, const GradeRecord& grade);
void printTable(const GradeRecord& grade, const std::filesystem::path& out);

std::string resultsJson(
    const GradeRecord& grade);  // gradescope-autograders.readthedocs.io, Output Format
// Every comparison with its pictures: for our own pages (the zoo), not for a platform.
std::string recordJson(const GradeRecord& grade);
std::string junitXml(const GradeRecord& grade);
// One file: no script, no link but to the handout, pictures inside. `out` is where it will stand.
std::string reportHtml(const GradeRecord& grade, const std::filesystem::path& out);

// Text for XML and HTML: markup escaped, what is no UTF-8 or no legal character replaced.
std::string escaped(const std::string& text);

}  // namespace penumbra
