#pragma once

/// Embree 3 (Debian 12) and Embree 4 (Debian 13, Ubuntu 24.04) under the same names: four calls that differ in how a
/// query says that its rays are coherent.

#ifdef LICHTRAUM_EMBREE_4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace lichtraum::bench {

enum class Coherence { incoherent, coherent };

class EmbreeQuery {
 public:
#ifdef LICHTRAUM_EMBREE_4
  explicit EmbreeQuery(Coherence coherence) {
    rtcInitIntersectArguments(&closest_);
    rtcInitOccludedArguments(&any_);
    if (coherence == Coherence::coherent) closest_.flags = any_.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  }
  void closest(RTCScene scene, RTCRayHit& query) { rtcIntersect1(scene, &query, &closest_); }
  void closest(int const* valid, RTCScene scene, RTCRayHit16& query) {
    rtcIntersect16(valid, scene, &query, &closest_);
  }
  void any(RTCScene scene, RTCRay& query) { rtcOccluded1(scene, &query, &any_); }
  void any(int const* valid, RTCScene scene, RTCRay16& query) { rtcOccluded16(valid, scene, &query, &any_); }

 private:
  RTCIntersectArguments closest_;
  RTCOccludedArguments any_;
#else
  explicit EmbreeQuery(Coherence coherence) {
    rtcInitIntersectContext(&context_);
    if (coherence == Coherence::coherent) context_.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  }
  void closest(RTCScene scene, RTCRayHit& query) { rtcIntersect1(scene, &context_, &query); }
  void closest(int const* valid, RTCScene scene, RTCRayHit16& query) {
    rtcIntersect16(valid, scene, &context_, &query);
  }
  void any(RTCScene scene, RTCRay& query) { rtcOccluded1(scene, &context_, &query); }
  void any(int const* valid, RTCScene scene, RTCRay16& query) { rtcOccluded16(valid, scene, &context_, &query); }

 private:
  RTCIntersectContext context_;
#endif
};

}  // namespace lichtraum::bench
