// Fails: Task2Extrude.HugeAndTinyScenesArePushedAlike, Task2Extrude.TheSunPushesAlongItsRays, Task4ZFail.TheSunNeedsNoFarCap, Task7SeveralLights.EveryLightHasItsOwnShadow, Task7SeveralLights.LightEndsAtItsRangeAndItsPlane, Task8WholeShadow.BothMethodsCountAlike · the sun is taken to stand somewhere
vec4 extruded(vec3 p, vec4 light) { return vec4(p - light.xyz, 0.0); }
