// How many shadow volumes a receiver lies in: what a stencil buffer should hold, as an integer.
//
//   VolumeCount truth = volumeCount(scene, scene.camera, receivers, light);
//   bool lit = truth.count.at(x, y) == 0.0f;          // where truth.decidable.at(x, y) == 1
//   int around = VolumesAround(scene, light).at(scene.camera.eye);   // > 0: z-pass needs help
#pragma once

#include <glm/glm.hpp>
#include <memory>

#include "core/image.h"
#include "scene/scene.h"
#include "truth/ray_tracer.h"

namespace penumbra {

// A receiver lies in a triangle's volume where the open segment from it to the light crosses that
// triangle, so the count is a number of crossings; no volume is ever built. It equals the count of
// the volumes around the eye plus what a view ray enters minus what it leaves.
enum class CountedTriangles {
    asNeeded,  // of a mesh for which facingTrianglesSuffice() (mesh_edges.h): those; else all
    all,       // volumes of single triangles, whatever the mesh
};

// Crossings by exact signs (orientation.h) of the float32 positions: two triangles that share an
// edge never both miss a segment, nor both catch it. A triangle whose plane holds the light has no
// volume. One whose plane holds the point, within float32 rounding (2^-20 of the coordinates), is
// the point's own facet and does not count: the point lies on its volume's cap.
// Holes of alpha masks are not seen: volumes are made of whole triangles.
class VolumesAround {
public:
    VolumesAround(const Scene& scene, const Light& light,
                  CountedTriangles counted = CountedTriangles::asNeeded);
    ~VolumesAround();
    VolumesAround(VolumesAround&&) noexcept;

    int at(glm::vec3 point) const { return besides(point, point); }
    // At a place beside a receiver, whose own facets do not count there either.
    int besides(glm::vec3 receiver, glm::vec3 place) const;
    // Just above a receiver's facet, on the side of its normal: where that side is averted from the
    // light, the facet's own volume, if it counts, is there, too.
    int above(glm::vec3 receiver, glm::vec3 facetNormal) const;

private:
    glm::dvec3 towardsLight(glm::dvec3 point) const;
    struct State;
    std::unique_ptr<State> state_;
};

struct VolumeCount {
    Image count;      // one channel, whole numbers: above the facet seen; 0 where none is seen
    Image decidable;  // 1 where a right technique must agree, else 0; 0 where no surface is seen
};

// `decidable` leaves out
// - receivers near a volume's side: their count turns when they move by `pixels` pixels within
//   their facet's plane, or up from it as far;
// - those within a 64th of a pixel of the background or of another plane: a rasteriser, which snaps
//   edges to fractions of a pixel, may see that one, or the rim of what lies behind it.
// Where facets meet in a hollow it leaves out a little too much; a volume thinner than `pixels`,
// such as that of a leaf with its edge to the light, may slip between the places that are tried.
VolumeCount volumeCount(const Scene& scene, const Camera& camera, const Receivers& receivers,
                        const Light& light, float pixels = 0.5f,
                        CountedTriangles counted = CountedTriangles::asNeeded);

}  // namespace penumbra
