// The demo's page: a gallery that opens from disk.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/metrics.h"

namespace penumbra {

struct DemoGrade {
    std::string assignment;
    double score = 0;    // of 100
    double seconds = 0;  // that grading took
    std::string report;  // path of report.html below grades/
};

struct DemoCard {
    std::string assignment, scene;
    std::size_t triangles = 0;
    std::map<std::string, double> milliseconds;  // by pass
    std::string notes;                           // a line each
    Metrics metrics;                             // of visibility against rays
    std::string stem;  // pictures/<stem>-color.png, -mine, -truth, -difference
};

struct DemoPage {
    std::vector<DemoGrade> grades;
    std::vector<DemoCard> cards;
};

std::string demoPage(const DemoPage& page);

}  // namespace penumbra
