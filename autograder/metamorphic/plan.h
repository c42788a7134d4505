// What the relations of relations.h are tried on: autograder/NN-name/metamorphic.json beside each
// grader. Nothing else here knows a technique.
//
//   {"scenes": ["boxes"],
//    "methods": [{"name": "PCSS", "settings": "map_size=256",
//                 "limit": ["light_size=0.25", "light_size=0.001"]}],
//    "allow":  [{"relation": "quarter turn", "pixels": 6, "cause": "sums in another order: …"}],
//    "except": [{"relation": "texels", "cause": "its rays are not parallel"}],
//    "mistakes": [{"relation": "scale", "mistake": "bias-in-world-units"}]}
//
// "one_mesh": true has a scene's meshes in one that reaches out of the picture. Where a light's
// view is fitted to meshes by their bounding boxes, a turn makes these larger; one that is clipped
// is fitted by its triangles.
//
// A method is settings that differ from the defaults, name=value,name=value; `limit`, more of them
// that lead step by step to a hard shadow ("" = it is one). `allow`, `except` and `mistakes` hold
// for all methods, or "method": "PCSS"; the first two for all drivers, or "driver": "softpipe".
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace penumbra {

struct MetamorphicMethod {
    std::string name;
    std::vector<std::string> settings;            // name=value
    std::vector<std::vector<std::string>> limit;  // of settings
};

// So many pixels may differ by more than rounding does, or (`pixels` < 0) the relation is not asked
// for. Without one, pictures are equal bit for bit.
struct Allowance {
    std::string relation, method, driver, cause;  // method, driver "": all
    int pixels = 0;
};

struct BreakingMistake {
    std::string relation, mistake, method;
};

struct MetamorphicPlan {
    std::vector<std::string> scenes;
    bool oneMesh = false;
    std::vector<MetamorphicMethod> methods;
    std::vector<Allowance> allowances;
    std::vector<BreakingMistake> mistakes;

    // Null where pictures are to be equal.
    const Allowance* allowance(const std::string& relation, const std::string& method,
                               const std::string& driver) const;
};

// Throws Error for a file that is missing, is no JSON, or names a relation or method that there is
// not.
MetamorphicPlan loadMetamorphicPlan(const std::filesystem::path& file);

}  // namespace penumbra
