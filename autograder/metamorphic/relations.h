// Relations between two pictures of one technique: a scene and its transform. They need no truth,
// and a driver's accident shows where two drivers keep them differently. Each is a statement about
// `visibility`; unless a plan allows a number of pixels and says why, it holds bit for bit.
//
//   scale         scene, camera and light times 2^10, and times 2^-10. A power of two changes
//                 exponents alone, so products, quotients, roots of squares and sums keep their
//                 digits: bit for bit, unless a length hides in the technique.
//   translation   all moved by (96, -64, 128), ten times the scene's size. Coordinates lie on a
//                 grid of 1/1024 and stay exact; what a technique computes from them loses seven
//                 binary digits, so samples near edges may fall on the other side.
//   texels        a sheet moved so that its shadow moves by 4 pixels and by whole texels of the map
//                 (transforms.h): the picture is the same, 4 pixels further. Depth, distance to the
//                 sheet and place within a texel do not change, so neither may the shadow.
//                 Only a flat sheet parallel to a flat map can do this under a point light; maps
//                 that are fitted to blockers move along with them instead, by a fraction.
//   half turn     about y by 180 degrees. (x, y, z) -> (-x, y, -z) changes signs alone, and
//                 rounding to nearest knows no sign: bit for bit, unless something is laid out from
//                 a lower corner.
//   quarter turn  about y by 90 degrees: exact as well, but sums of three products have their terms
//                 in another order and round otherwise.
//   turn          by 37 degrees about (1, 2, 3): positions are rounded, too, and what lies along
//                 the axes (boxes around, grids) is another.
//   blocker       a box whose penumbra stays apart from all others never brightens.
//   any blocker   nor does a slab before the light, which shadows others' shadows: true of what
//                 knows all blockers of a ray. One map of the nearest depths forgets those behind
//                 the slab, and what they would do to a penumbra (docs/metamorphic.md has figures).
//                 Of both: the pictures compared hold the blocker or its corners, so that no view
//                 is fitted anew, and only pixels where the camera sees the same surface count.
//   limit         along the plan's steps to a hard shadow pictures come ever nearer to rays to the
//                 light's center; the last equals them wherever their picture is all lit or all
//                 dark within two pixels, and the surface one facet within one. Pixels counted:
//                 those that do not.
//   order         meshes and triangles in reverse order. Depth tests, sums of integers and minima
//                 do not ask who came first.
//   driver        llvmpipe's picture and softpipe's (asked for in runs on softpipe alone).
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/grading_session.h"
#include "metamorphic/difference.h"
#include "metamorphic/plan.h"

namespace penumbra {

const std::vector<std::string>& relationNames();

struct Outcome {
    std::string relation, method, scene;
    Difference measured;
    const Allowance* allowance = nullptr;  // of the plan
    std::string trouble = "";              // why nothing was measured, or not only pixels count

    bool holds() const;
};

struct RelationsRequest {
    VariantProgram program;
    const MetamorphicPlan& plan;
    std::string driver = "llvmpipe";         // or softpipe: Mesa's rasterisers without a GPU
    std::string only = "", onlyMethod = "";  // relation, method; "" = all
    std::vector<std::string> scenes = {};    // other than the plan's
    glm::ivec2 size{64, 64};                 // of all relations but `texels`
    bool excepted = false;                   // relations that the plan leaves out, too
};

// Throws Error where the driver is not there: each frame says what drew it.
std::vector<Outcome> tryRelations(const RelationsRequest& request);

}  // namespace penumbra
