#include "study/page.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base64.h"
#include "core/error.h"
#include "scene/gallery.h"
#include "study/style.h"

namespace penumbra {

std::string studyHtml(const StudyResults& results) {
    const auto file = repositoryRoot() / "autograder/study/page.html";
    std::ifstream stream(file);
    std::stringstream text;
    text << stream.rdbuf();
    std::string html = text.str();
    const std::string place = "/*STUDY*/null";
    const std::size_t at = html.find(place);
    if (at == std::string::npos)
        throw Error("the page's template is missing", file.string(), "restore it");

    auto json = nlohmann::ordered_json::parse(studyJson(results));
    for (const auto& [key, image] : results.pictures)
        json["pictures"][key] = base64(encodePng(image, Encoding::linear));
    for (const CurveStyle& s : curveStyles(results))
        json["styles"].push_back({{"program", s.program},
                                  {"curve", s.curve},
                                  {"color", s.color},
                                  {"marker", s.marker},
                                  {"dash", s.dash}});
    // Same order as in studyJson().
    for (std::size_t i = 0; i < results.points.size(); ++i)
        json["points"][i]["picture"] = results.points[i].picture;
    for (std::size_t i = 0; i < results.truths.size(); ++i)
        json["truths"][i]["picture"] = results.truths[i].picture;
    // "</script>" in a note would end the script.
    std::string data = json.dump();
    for (std::size_t i = data.find("</"); i != std::string::npos; i = data.find("</", i + 3))
        data.replace(i, 2, "<\\/");
    return html.replace(at, place.size(), data);
}

}  // namespace penumbra
