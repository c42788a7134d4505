#include "app/headless.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/frame_file.h"
#include "core/output_folder.h"
#include "gl/timer.h"

namespace penumbra {

namespace {

// Depth and other unbounded images are stretched to [0,1] for the eye; the .exr keeps the values.
Image stretched(const Image& image) {
    float low = 1e30f, high = -1e30f;
    for (const float v : image.pixels)
        if (std::isfinite(v) && v < 1.0f) low = std::min(low, v), high = std::max(high, v);
    if (high <= low) return image;
    Image result = image;
    for (float& v : result.pixels) v = (v - low) / (high - low);
    return result;
}

void savePicture(const std::filesystem::path& path, const std::string& name, const Image& image) {
    const bool depth =
        name.find("depth") != std::string::npos || name.find("map") != std::string::npos;
    savePng(path, depth && image.channels == 1 ? stretched(image) : image,
            name == "color" ? Encoding::srgb : Encoding::linear);
}

}  // namespace

std::map<std::string, std::string> infoStrings(Session& session, const Context& context) {
    return {{"light_model",
             session.assignment().lightModel() == LightModel::point ? "point" : "square"},
            {"directional_lights",
             session.assignment().takesDirectionalLights() ? "parallel" : "far point"},
            {"context", context.backend()},
            {"renderer", context.renderer()},
            {"version", context.version()},
            {"vendor", context.vendor()},
            {"timer", usesTimerQueries() ? "timer queries" : "glFinish and a steady clock"}};
}

void renderToFolder(Session& session, const Context& context, glm::ivec2 size,
                    const std::optional<std::set<std::string>>& wanted,
                    const std::filesystem::path& out) {
    const Frame frame = session.render(size, wanted);
    const auto images = frame.read();
    throwOnGlErrors();
    nlohmann::ordered_json json;
    json["scene"] = session.scene().name;
    json["size"] = {size.x, size.y};
    json["triangles"] = triangleCount(session.scene());
    for (const Setting& s : session.settings().all()) json["settings"][s.name] = Settings::text(s);
    for (const auto& [pass, ms] : frame.milliseconds()) json["milliseconds"][pass] = ms;
    if (!frame.notes().empty()) json["notes"] = frame.notes();
    for (const auto& [key, value] : infoStrings(session, context)) json["gl"][key] = value;
    for (const auto& [name, image] : images) {
        if (const auto bad = nonFiniteCount(image))
            throw Error(fmt::format("{} of {} values are not finite", bad, image.pixels.size()),
                        "image " + name,
                        "look for a division by zero or the root of a negative number");
        json["images"][name] = {image.width, image.height, image.channels};
    }
    OutputFolder folder(out);
    for (const auto& [name, image] : images) {
        saveExr(folder.file(name + ".exr"), image);
        savePicture(folder.file(name + ".png"), name, image);
    }
    writeText(folder.file("frame.json"), json.dump(2) + "\n");
    folder.commit();
}

void renderToFrameFile(Session& session, const Context& context, glm::ivec2 size,
                       const std::optional<std::set<std::string>>& wanted,
                       const std::filesystem::path& file) {
    const Frame frame = session.render(size, wanted);
    FrameFile result{.images = frame.read(),
                     .milliseconds = frame.milliseconds(),
                     .info = infoStrings(session, context)};
    result.info["notes"] = fmt::format("{}", fmt::join(frame.notes(), "\n"));
    throwOnGlErrors();
    saveFrameFile(file, result);
}

}  // namespace penumbra
