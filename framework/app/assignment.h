// The one seam of the course: what window, headless render, grader and study know of a technique.
//
//   struct ShadowMap final : Assignment { … };
//   std::unique_ptr<Assignment> makeAssignment() { return std::make_unique<ShadowMap>(); }  //
//   given/
//
// One per program. A GL context is current whenever render() or the destructor runs.
#pragma once

#include <memory>
#include <string>

#include "core/settings.h"
#include "render/frame.h"
#include "scene/scene.h"

namespace penumbra {

// What the technique's `visibility` is an approximation of, hence which truth it is compared with.
enum class LightModel { point, square };

struct Assignment {
    virtual ~Assignment() = default;

    // The scene it opens with; --scene names another.
    virtual Scene scene() const = 0;

    // Declares every dial. Called once, before the first render().
    virtual void settings(Settings& settings) = 0;

    // What the settings do to the scene (a light's height, a plane's tilt, a moment in time), so
    // that truth and technique see the same. Called with the scene as opened whenever a setting
    // changed. With every setting at its default the scene must stay as it is.
    virtual void arrange(const Settings&, Scene&) const {}

    // Draws view.scene and hands over named images: at least "visibility" (one channel, 1 where the
    // camera sees no surface), "color" (three, linear) and "depth" (one, window depth).
    virtual void render(const View& view, Frame& frame) = 0;

    virtual LightModel lightModel() const { return LightModel::point; }
    // A technique that knows no parallel rays gets a light far away in the same direction.
    virtual bool takesDirectionalLights() const { return false; }
};

std::unique_ptr<Assignment> makeAssignment();

}  // namespace penumbra
