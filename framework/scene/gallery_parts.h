// What the makers of built-in scenes share.
//
//   Scene scene = emptyScene();
//   const int clay = addMaterial(scene, "clay", {0.70f, 0.32f, 0.20f});
//   add(scene, "box", turned(box(…), pivot, angle));
#pragma once

#include "scene/random.h"
#include "scene/scene.h"

namespace penumbra {

inline constexpr float kGroundSize = 12.0f;

// Closed casters stand so far above the surface that carries them: on it, surface and caster would
// share points, and which of them blocks the other would be a matter of rounding. A millimetre of
// light shows in no picture.
inline constexpr float kStandingGap = 1e-3f;

// Seeds other than the reference draw from their range; seed 1 keeps the named value, so that the
// reference scene can be tuned without touching the generator.
class Variation {
public:
    explicit Variation(std::uint64_t seed) : reference_(seed == 1), random_(seed) {}
    float operator()(float reference, float spread) {
        const float drawn = random_.between(reference - spread, reference + spread);
        return reference_ ? reference : drawn;
    }

private:
    bool reference_;
    Random random_;
};

Scene emptyScene();  // material 0 is "ground"; the standard view, from above and the front
int addMaterial(Scene& scene, const char* name, glm::vec3 color, glm::vec3 emissive = glm::vec3(0));
void add(Scene& scene, const char* name, Mesh mesh);

// About the vertical axis through `pivot`, counter-clockwise seen from above; radians.
Mesh turned(Mesh mesh, glm::vec3 pivot, float angle);
Mesh moved(Mesh mesh, glm::vec3 by);

}  // namespace penumbra
