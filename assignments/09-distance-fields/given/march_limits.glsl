// What a march may do, and what it found.
struct Limits {
    float highest;        // ratios above it are of no interest
    float lowest;         // nor is what lies below this one: the march ends
    float stepCap;        // 0 … 1: how short a step may become, as a share of the distance
    float smallestStep;   // > 0                                                            [world]
    int maxSteps;         // look-ups, at least 1
};

struct Approach {
    float ratio;          // smallest distance / t on the ray, at most limits.highest
    float t;              // where that was; `reach` where nothing came nearer than `highest`
    float steps;          // look-ups
};
