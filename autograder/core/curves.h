// Where a curve teaches more than a point: sweeps that an assignment's grader measures as its
// checks do, with render(), evaluate() and truths.h, in autograder/NN-name/curves.cpp.
//
//   CURVE(bias) {                                     // bias.svg, for handout and zoo
//       Curve curve{.title = …, .says = …, .x = {"constant bias [texels]"}, .panels = …};
//       for (…) curve.panels[0].series[0].points.emplace_back(texels, acneShare(render(…)));
//       EXPECT_VALUE(acneAtTheMark, Equal, 0, "why");  // a fact, held by ./course test
//       return curve;
//   }
//
// N.grade --curves --solution --out DIR measures and draws them all.
#pragma once

#include "core/checks.h"
#include "core/plot.h"
#include "core/variant.h"

namespace penumbra {

// Called by CURVE before main().
bool registerCurve(const char* name, Curve (*measure)());

struct CurveOptions {
    std::string only;  // a name, or a pattern as for checks
    std::filesystem::path out;
    std::filesystem::path truthCache;  // empty = none
};

// Writes <name>.svg for every curve that could be measured, and curves.json. 0: every fact holds;
// 1: one does not, or a frame did not come. Throws Error for the grader's own trouble.
int drawCurves(const Place& place, const Variant& variant, const CurveOptions& options);

}  // namespace penumbra

// Underscores of the name become hyphens in the file's.
#define CURVE(name)                                        \
    static ::penumbra::Curve measure_##name();             \
    [[maybe_unused]] static const bool registered_##name = \
        ::penumbra::registerCurve(#name, measure_##name);  \
    static ::penumbra::Curve measure_##name()
