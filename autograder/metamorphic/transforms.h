// Scenes and their transforms: what a picture must not notice. Light and camera go along.
//
//   Scene scene = onGrid(loadScene("boxes"));
//   Scene far = moved(scene, {96, -64, 128});        // exact: every coordinate stays a float
//   Scene same = moved(far, {-96, 64, -128});        // == scene
#pragma once

#include "scene/scene.h"

namespace penumbra {

// Positions, the eye and the light's center at multiples of 1/1024, so that moving by whole numbers
// up to 8192 rounds nothing.
Scene onGrid(Scene scene);

Scene moved(Scene scene, glm::vec3 by);

// `rotation`: orthonormal, determinant 1. Nothing is rounded where its entries are 0, 1 and -1.
Scene turned(Scene scene, const glm::dmat3& rotation);
glm::dmat3 quarterTurns(int count);  // about y
glm::dmat3 obliqueTurn();            // 37 degrees about (1, 2, 3)

// Meshes in reverse order, the triangles of each likewise.
Scene reversed(Scene scene);

// All meshes in one.
Scene merged(Scene scene);

// A slab, or only the eight specks in its corners: with either, a light's view that is fitted to
// its blockers is the same.
Scene withSlab(Scene scene, const Box& slab);
Scene withSpecks(Scene scene, const Box& slab);

// Between light and scene: a thin slab as wide as the light, on the way from the middle to it,
// where the camera sees all of it or nothing (then its corners are fitted as it is).
Box slabBeforeTheLight(const Scene& scene);

// Two tall boxes far apart on a ground, under a light of width 1/2. `lowBox`: where a third one
// stands, or its specks, between the two and lower than they: the light's view does not change, and
// its penumbra does not come near theirs.
Scene twoBoxes();
Box lowBox();

// A light straight over a ground, a sheet halfway, and a camera that looks straight down and sees
// ground alone. Lengths are such that a step of the sheet moves its shadow by kStepPixels pixels of
// a picture of kStepPicture², and by whole texels of a map of 256² or a multiple:
//
//   light's view fitted to the receivers       16 texels of 256
//   and widened by half a light's parallax     14 texels of 256
//
//     light  --+--           width 1.5, height 8
//              |   camera    height 6, sees x from -7.25 to 3.25
//     sheet  ==|
//     ground -----------
Scene sheetScene(int steps);
inline constexpr int kStepPixels = 4;
inline constexpr int kStepPicture = 64;

}  // namespace penumbra
