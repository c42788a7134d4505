#include "metamorphic/relations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/truths.h"
#include "metamorphic/transforms.h"
#include "scene/gallery.h"

namespace penumbra {

namespace {

std::vector<std::string> joined(std::vector<std::string> a, const std::vector<std::string>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

// One method of one program under one driver.
class Studio {
public:
    Studio(GradingSession& session, std::string driver, glm::ivec2 size,
           std::vector<std::string> settings)
        : session_(session),
          driver_(std::move(driver)),
          size_(size),
          settings_(std::move(settings)) {}

    std::shared_ptr<const FrameFile> frame(const Scene& scene,
                                           const std::vector<std::string>& more = {}) const {
        auto result = session_.render({.scene = session_.sceneFile(scene),
                                       .size = size_,
                                       .settings = joined(settings_, more),
                                       .images = {"visibility", "depth"}});
        const std::string& renderer = result->info.at("renderer");
        if (renderer.find(driver_) == std::string::npos)
            throw Error("not the driver that was asked for", renderer + " instead of " + driver_,
                        "install Mesa's software rasterisers (libosmesa6)");
        return result;
    }

    Image picture(const Scene& scene, const std::vector<std::string>& more = {}) const {
        return frame(scene, more)->images.at("visibility");
    }

    Studio ofSize(glm::ivec2 size) const { return Studio(session_, driver_, size, settings_); }
    glm::ivec2 size() const { return size_; }

    Difference between(const Scene& a, const Scene& b) const {
        return difference(picture(a), picture(b));
    }

private:
    GradingSession& session_;
    std::string driver_;
    glm::ivec2 size_;
    std::vector<std::string> settings_;
};

struct Measured {
    Difference difference;
    std::string trouble = "";
};

Measured scale(const Studio& studio, const Scene& scene) {
    const Difference larger = studio.between(scene, scaled(scene, 1024.0f));
    const Difference smaller = studio.between(scene, scaled(scene, 1 / 1024.0f));
    return {larger.any > smaller.any ? larger : smaller};
}

Measured translation(const Studio& studio, const Scene& scene) {
    return {studio.between(scene, moved(scene, {96, -64, 128}))};
}

Measured texels(const Studio& studio, const Scene&) {
    const Studio square = studio.ofSize(glm::ivec2(kStepPicture));
    const Image before = square.picture(sheetScene(0)), after = square.picture(sheetScene(1));
    const auto [least, most] = std::minmax_element(before.pixels.begin(), before.pixels.end());
    return {shifted(before, after, kStepPixels), *least < *most ? "" : "the sheet has no shadow"};
}

Measured halfTurn(const Studio& studio, const Scene& scene) {
    return {studio.between(scene, turned(scene, quarterTurns(2)))};
}

Measured quarterTurn(const Studio& studio, const Scene& scene) {
    return {studio.between(scene, turned(scene, quarterTurns(1)))};
}

Measured anyTurn(const Studio& studio, const Scene& scene) {
    return {studio.between(scene, turned(scene, obliqueTurn()))};
}

Measured order(const Studio& studio, const Scene& scene) {
    return {studio.between(scene, reversed(scene))};
}

Measured limit(const Studio& studio, const Scene& scene,
               const std::vector<std::vector<std::string>>& steps) {
    const TracedScene traced(scene, studio.size());
    const Image rays = traced.pointVisibility();
    Measured result;
    double before = 1e30;
    for (const auto& step : steps) {
        const Image image = studio.picture(scene, step);
        const double distance = meanDifference(image, rays);
        if (!(distance < before))
            result.trouble = fmt::format("not nearer: {:.5f} after {:.5f}", distance, before);
        before = distance;
        result.difference = {};
        for (int y = 0; y < rays.height; ++y)
            for (int x = 0; x < rays.width; ++x)
                if (!nearAnEdge(rays, traced.receivers(), x, y))
                    result.difference.count(std::abs(image.at(x, y) - rays.at(x, y)), x, y);
    }
    return result;
}

// What a slab brightens where the camera sees the same surface with and without it.
Difference brightened(const Studio& studio, const Scene& scene, const Box& slab) {
    const auto before = studio.frame(withSpecks(scene, slab));
    const auto after = studio.frame(withSlab(scene, slab));
    const Image &without = before->images.at("visibility"), &with = after->images.at("visibility");
    Difference result;
    for (int y = 0; y < with.height; ++y)
        for (int x = 0; x < with.width; ++x)
            if (before->images.at("depth").at(x, y) == after->images.at("depth").at(x, y))
                result.count(std::max(with.at(x, y) - without.at(x, y), 0.0f), x, y);
    return result;
}

Measured blockerApart(const Studio& studio, const Scene&) {
    return {brightened(studio, twoBoxes(), lowBox())};
}

Measured anyBlocker(const Studio& studio, const Scene& scene) {
    return {brightened(studio, scene, slabBeforeTheLight(scene))};
}

struct Relation {
    std::string name;
    Measured (*measure)(const Studio&, const Scene&);  // null: below, since it asks for more
    bool ownScene = false;
};

const std::vector<Relation>& relations() {
    static const std::vector<Relation> all = {{"scale", scale},
                                              {"translation", translation},
                                              {"texels", texels, true},
                                              {"half turn", halfTurn},
                                              {"quarter turn", quarterTurn},
                                              {"turn", anyTurn},
                                              {"blocker", blockerApart, true},
                                              {"any blocker", anyBlocker},
                                              {"order", order},
                                              {"limit", nullptr},
                                              {"driver", nullptr}};
    return all;
}

// Pictures by method and scene, from the driver that others are held against.
using Pictures = std::map<std::string, Image>;
constexpr const char* kFirstDriver = "llvmpipe";

class Trial {
public:
    Trial(const RelationsRequest& request, const std::string& driver)
        : request_(request), driver_(driver), session_([&] {
              VariantProgram program = request.program;
              program.environment = driverEnvironment(driver);
              return program;
          }()) {
        for (const std::string& name :
             request.scenes.empty() ? request.plan.scenes : request.scenes) {
            scenes_.push_back(onGrid(loadScene(name)));
            if (request.plan.oneMesh) scenes_.back() = merged(std::move(scenes_.back()));
            if (driver != kFirstDriver) break;  // softpipe is ten times slower
        }
    }

    Pictures pictures() {
        Pictures result;
        for (const MetamorphicMethod& method : methods())
            for (const Scene& scene : scenes_)
                if (asked("driver", method))
                    result[method.name + scene.name] = studio(method).picture(scene);
        return result;
    }

    std::vector<Outcome> run(const Pictures& others) {
        std::vector<Outcome> outcomes;
        for (const MetamorphicMethod& method : methods())
            for (const Relation& relation : relations()) {
                if (!asked(relation.name, method)) continue;
                if (relation.name == "driver" && driver_ == kFirstDriver) continue;
                for (const Scene& scene : scenes_) {
                    outcomes.push_back(tried(relation, method, scene, others));
                    if (relation.ownScene) break;
                }
            }
        return outcomes;
    }

private:
    Studio studio(const MetamorphicMethod& method) {
        return Studio(session_, driver_, request_.size, method.settings);
    }

    std::vector<MetamorphicMethod> methods() const {
        std::vector<MetamorphicMethod> chosen;
        for (const MetamorphicMethod& m : request_.plan.methods)
            if (request_.onlyMethod.empty() || request_.onlyMethod == m.name) chosen.push_back(m);
        return chosen;
    }

    bool asked(const std::string& relation, const MetamorphicMethod& method) const {
        if (!request_.only.empty() && request_.only != relation) return false;
        const Allowance* a = request_.plan.allowance(relation, method.name, request_.driver);
        return request_.excepted || !a || a->pixels >= 0;
    }

    Measured measure(const Relation& relation, const MetamorphicMethod& method, const Scene& scene,
                     const Pictures& others) {
        const Studio view = studio(method);
        if (relation.measure) return relation.measure(view, scene);
        if (relation.name == "limit") return limit(view, scene, method.limit);
        return {difference(view.picture(scene), others.at(method.name + scene.name))};
    }

    Outcome tried(const Relation& relation, const MetamorphicMethod& method, const Scene& scene,
                  const Pictures& others) {
        Outcome outcome{.relation = relation.name,
                        .method = method.name,
                        .scene = relation.ownScene ? "" : scene.name,
                        .measured = {},
                        .allowance = request_.plan.allowance(relation.name, method.name, driver_)};
        session_.begin("Metamorphic", relation.name);
        try {
            const Measured measured = measure(relation, method, scene, others);
            outcome.measured = measured.difference;
            outcome.trouble = measured.trouble;
        } catch (const NoFrame& e) {
            outcome.trouble = e.what();
        }
        session_.end();
        return outcome;
    }

    static std::vector<std::string> driverEnvironment(const std::string& driver) {
        // Both rasterisers answer through Mesa's own context. softpipe calls itself 3.3, and knows
        // enough of 4.1.
        return {"PENUMBRA_CONTEXT=osmesa", "GALLIUM_DRIVER=" + driver,
                "MESA_GL_VERSION_OVERRIDE=4.1", "MESA_GLSL_VERSION_OVERRIDE=410"};
    }

    const RelationsRequest& request_;
    std::string driver_;
    GradingSession session_;
    std::vector<Scene> scenes_;
};

}  // namespace

const std::vector<std::string>& relationNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const Relation& relation : relations()) all.push_back(relation.name);
        return all;
    }();
    return names;
}

bool Outcome::holds() const {
    if (!trouble.empty()) return false;
    return allowance ? measured.visible <= allowance->pixels : measured.any == 0;
}

std::vector<Outcome> tryRelations(const RelationsRequest& request) {
    Pictures others;
    if (request.driver != kFirstDriver) others = Trial(request, kFirstDriver).pictures();
    return Trial(request, request.driver).run(others);
}

}  // namespace penumbra
