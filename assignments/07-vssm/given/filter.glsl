// Visibility over a window: each cell has its own estimate, and its own part of the light.
#include "windows.glsl"

float visibilityInWindow(Receiver receiver, vec2 widthUv) {
    float inverse = 1.0 / float(shadow.filterCells), lit = 0.0;
    Window window = windowAround(receiver.uvDepth.xy, widthUv, inverse);
    for (int j = 0; j < shadow.filterCells; ++j) {
        Side left = sideOf(window, 0, j);
        for (int i = 0; i < shadow.filterCells; ++i) {
            Side right = sideOf(window, i + 1, j);
            vec2 middle = cellMiddle(i, j, inverse), offsetUv = middle * widthUv;
            float share = litShare(receiver.uvDepth.xy + offsetUv, widthUv * inverse,
                                   meanVarianceBetween(window, left, right), blockedBelow(receiver, offsetUv));
            lit += share * shareAboveHorizon(receiver, middle, inverse);
            left = right;
        }
    }
    return lit * inverse * inverse;
}
