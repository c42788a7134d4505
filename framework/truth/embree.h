// Embree 3.13 and 4 behind one set of calls: both call styles exist in one place only.
//
//   embree::FlushDenormals flush;                 // in every thread that traces
//   embree::intersect1(scene, rayHit);
//   embree::occluded16(valid, scene, rays);       // tfar < 0 where blocked
//
// Embree 4 has no stream calls and passes optional arguments where 3 passes a context, so only
// single rays and packets of 16 are used.
#pragma once

#if PENUMBRA_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#if defined(__SSE2__) || defined(_M_X64)
#include <xmmintrin.h>
#define PENUMBRA_HAS_MXCSR 1
#endif

namespace penumbra::embree {

inline void intersect1(RTCScene scene, RTCRayHit& rayHit) {
#if PENUMBRA_EMBREE_MAJOR >= 4
    rtcIntersect1(scene, &rayHit);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &rayHit);
#endif
}

// `valid` holds -1 for lanes in use, 0 for the others, and is aligned to 64 bytes as the rays are.
inline void occluded16(const int* valid, RTCScene scene, RTCRay16& rays) {
#if PENUMBRA_EMBREE_MAJOR >= 4
    rtcOccluded16(valid, scene, &rays);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded16(valid, scene, &context, &rays);
#endif
}

// Embree asks that denormal floats be flushed to zero (FTZ, DAZ) in each tracing thread; the
// caller's own mode comes back afterwards. Processors without the register flush by default or do
// not care.
class FlushDenormals {
public:
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;
#ifdef PENUMBRA_HAS_MXCSR
    FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040u); }
    ~FlushDenormals() { _mm_setcsr(before_); }

private:
    unsigned before_;
#else
    FlushDenormals() {}
    ~FlushDenormals() {}
#endif
};

}  // namespace penumbra::embree
