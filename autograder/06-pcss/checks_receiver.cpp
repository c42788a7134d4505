// Soft shadows: widths by similar triangles, and the receiver's plane and horizon.
#include "soft_checks.h"

namespace penumbra {
namespace {

// --- Task 1 ---

struct WidthRows {
    Rows scale, depths, search, penumbra;
};

WidthRows widthRows(unsigned seed) {
    Dice dice{std::mt19937(seed)};
    WidthRows rows;
    for (int i = 0; i < kRows; ++i) {
        const LightView view(dice);
        const double receiver = view.distance(dice(0.05, 1.2));  // beyond 1: behind the far plane
        const double blocker =
            i % 8 == 0 ? receiver : view.nearPlane + dice(0, 0.9) * (receiver - view.nearPlane);
        const double aspect = dice(0.5, 2);  // the window need not be square
        rows.scale.emplace_back(dvec4(view.scaleUv(), aspect * view.scaleUv(), 0, 0));
        rows.depths.emplace_back(dvec4(view.depth(receiver), view.depth(blocker), 0, 0));
        const double search = view.penumbraUv(receiver, view.nearPlane);
        const double penumbra = view.penumbraUv(receiver, blocker);
        rows.search.emplace_back(dvec4(search, aspect * search, 0, 0));
        rows.penumbra.emplace_back(dvec4(penumbra, aspect * penumbra, 0, 0));
    }
    return rows;
}

// Depths near 1 are rounded to 6e-8, and a difference of two keeps that error; S is at most 10.
const RowTolerance kWidths{.absolute = 2e-6,
                           .relative = 1e-5,
                           .components = 2,
                           .cause = "depths are rounded to 6e-8 and S is at most 10; else float32"};

TEST(Task1Penumbra, SearchWindowHoldsABlockerOnTheNearPlane) {
    const WidthRows rows = widthRows(11);
    const Rows searchWidthUv = evaluate({.chunk = "penumbra.glsl",
                                         .expression = "vec4(searchWidthUv(a.xy, b.x), 0.0, 0.0)",
                                         .inputs = {{"a", rows.scale}, {"b", rows.depths}}});
    EXPECT_ROWS_NEAR(searchWidthUv, rows.search, kWidths);
}

TEST(Task1Penumbra, PenumbraFollowsSimilarTriangles) {
    const WidthRows rows = widthRows(12);
    const Rows penumbraWidthUv =
        evaluate({.chunk = "penumbra.glsl",
                  .expression = "vec4(penumbraWidthUv(a.xy, b.x, b.y), 0.0, 0.0)",
                  .inputs = {{"a", rows.scale}, {"b", rows.depths}}});
    EXPECT_ROWS_NEAR(penumbraWidthUv, rows.penumbra, kWidths);
}

TEST(Task1Penumbra, WidthsAreNeverNegative) {
    Dice dice{std::mt19937(13)};
    Rows scale, depths;
    for (int i = 0; i < kRows; ++i) {
        const double receiver = dice(-0.1, 0.5);
        scale.emplace_back(dvec4(dice(0.01, 1), dice(0.01, 1), 0, 0));
        depths.emplace_back(dvec4(std::min(receiver, 0.0), receiver, receiver + dice(0, 0.5), 0));
    }
    const Rows widths =
        evaluate({.chunk = "penumbra.glsl",
                  .expression = "vec4(searchWidthUv(a.xy, b.x), penumbraWidthUv(a.xy, b.y, b.z))",
                  .inputs = {{"a", scale}, {"b", depths}}});
    EXPECT_ROWS_NEAR(widths, Rows(kRows, vec4(0.0f)),
                     {.components = 4,
                      .cause = "receivers before the near plane, blockers behind the receiver"});
}

// --- Task 2 ---

// A receiver on a tilted plane, and points beside, over and under that plane, in light view space:
// the light's centre is the origin, it looks along -z.
struct PlaneRows {
    Rows height, scale, offset, over;
};

PlaneRows planeRows(unsigned seed) {
    Dice dice{std::mt19937(seed)};
    PlaneRows rows;
    while (int(rows.over.size()) < kRows) {
        const LightView view(dice);
        const dvec2 tangents =
            view.tangents * dvec2(1, dice(0.5, 2));  // the map need not be square
        const auto point = [&] {
            const double z = view.distance(dice(0.02, 1));
            const dvec2 xy = z * tangents * dvec2(dice(-0.5, 0.5), dice(-0.5, 0.5));
            return dvec3(xy, -z);
        };
        const dvec3 receiver = point(), other = point();
        const dvec3 normal = glm::normalize(dvec3(dice(-1, 1), dice(-1, 1), dice(-0.4, 1)));
        const double height = glm::dot(normal, other - receiver);
        if (std::abs(height) < 0.02 * glm::length(other - receiver)) continue;
        const auto uvDepth = [&](dvec3 p) {
            return dvec3(0.5 + dvec2(p) / -p.z / tangents, view.depth(-p.z));
        };
        rows.height.emplace_back(
            dvec4(-glm::dot(normal, receiver), view.width * normal.x, view.width * normal.y, 0));
        rows.scale.emplace_back(dvec4(view.scaleUv() * view.tangents / tangents, 0, 0));
        rows.offset.emplace_back(dvec4(uvDepth(other) - uvDepth(receiver), 0));
        rows.over.emplace_back(height > 0 ? 1 : 0);
    }
    return rows;
}

TEST(Task2ReceiverPlane, TellsWhichPointsLieOverThePlane) {
    const PlaneRows rows = planeRows(21);
    const Rows overPlane =
        evaluate({.chunk = "receiver_plane.glsl",
                  .expression = "vec4(dot(receiverPlane(a.xyz, b.xy), c.xyz) > 0.0 ? 1.0 : 0.0)",
                  .inputs = {{"a", rows.height}, {"b", rows.scale}, {"c", rows.offset}}});
    EXPECT_ROWS_NEAR(overPlane, rows.over,
                     {.cause = "no point is nearer to the plane than 2 % of its distance"});
}

// A whole number of 64ths: sums and products of a few have no rounding.
double sixtyFourths(Dice& dice, double low, double high) {
    return std::round(64 * dice(low, high)) / 64;
}

TEST(Task2ReceiverPlane, ABlockerIsBeforeTheReceiverAndOverItsPlane) {
    Dice dice{std::mt19937(22)};
    Rows planes, offsets, truth;
    while (int(truth.size()) < kRows) {
        const vec4 plane(dice(-2, 2), dice(-2, 2), dice(-2, 1), dice(0, 0.02));
        const vec4 offset(dice(-0.05, 0.05), dice(-0.05, 0.05), dice(-0.1, 0.05), 0);
        const double bias = plane.w;
        const double nearer = -double(offset.z) - bias;
        const double over =
            glm::dot(dvec3(plane), dvec3(offset)) - bias * std::abs(double(plane.z));
        if (std::min(std::abs(nearer), std::abs(over)) < 1e-4) continue;
        planes.push_back(plane);
        offsets.push_back(offset);
        truth.emplace_back(nearer > 0 && over > 0 ? 1 : 0);
    }
    for (int i = 0; i < kRows; ++i) {  // on a border: no more than the bias
        const double bias = i % 3 == 0 ? 0 : sixtyFourths(dice, 0, 0.2), z = i % 2 == 0 ? -1 : 1;
        const double slope = sixtyFourths(dice, -2, 2), v = sixtyFourths(dice, -1, 1);
        const bool asNear = i % 4 < 2;
        const double depth = asNear ? -bias : -bias - 1.0 / 64;
        const double onPlane = bias - slope * v - z * depth;
        planes.emplace_back(dvec4(1, slope, z, bias));
        offsets.emplace_back(dvec4(asNear ? onPlane + 1 : onPlane, v, depth, 0));
        truth.emplace_back(0.0f);
    }
    const Rows isBlocker = evaluate({.chunk = "receiver_plane.glsl",
                                     .expression = "vec4(isBlocker(a.xyz, b.xyz, a.w) ? 1.0 : 0.0)",
                                     .inputs = {{"a", planes}, {"b", offsets}}});
    EXPECT_ROWS_NEAR(isBlocker, truth,
                     {.cause = "no row is nearer to either border than 1e-4, or it is "
                               "exactly on one, in numbers without rounding"});
}

TEST(Task2ReceiverPlane, TheHorizonCutsTheLight) {
    Dice dice{std::mt19937(23)};
    Rows heights, points, truth;
    while (int(truth.size()) < kRows) {
        const dvec3 height(dice(-1, 1), dice(-2, 2), dice(-2, 2));
        const dvec2 point(dice(-0.5, 0.5), dice(-0.5, 0.5));
        const double over = height.x + height.y * point.x + height.z * point.y;
        if (std::abs(over) < 1e-4) continue;
        heights.emplace_back(dvec4(height, 0));
        points.emplace_back(dvec4(point, 0, 0));
        truth.emplace_back(over > 0 ? 1 : 0);
    }
    for (int i = 0; i < kRows; ++i) {  // on the plane: not over it
        const dvec2 slope(sixtyFourths(dice, -2, 2), sixtyFourths(dice, -2, 2));
        const dvec2 point(sixtyFourths(dice, -0.5, 0.5), sixtyFourths(dice, -0.5, 0.5));
        heights.emplace_back(dvec4(-glm::dot(slope, point), slope, 0));
        points.emplace_back(dvec4(point, 0, 0));
        truth.emplace_back(0.0f);
    }
    const Rows isAboveHorizon =
        evaluate({.chunk = "receiver_plane.glsl",
                  .expression = "vec4(isAboveHorizon(a.xyz, b.xy) ? 1.0 : 0.0)",
                  .inputs = {{"a", heights}, {"b", points}}});
    EXPECT_ROWS_NEAR(isAboveHorizon, truth,
                     {.cause = "no row is nearer to the horizon than 1e-4, or it is "
                               "exactly on it, in numbers without rounding"});
}

TEST(Task2ReceiverPlane, NoFalseShadowOnAPlaneFrom10To89Degrees) {
    for (const char* scene : {"tilted@10", "tilted@60", "tilted@85", "tilted@89"})
        expectHorizonOnly(loadScene(scene), {"method=pcf", "pcf_radius=16", "kernel=grid"});
}

}  // namespace
}  // namespace penumbra
