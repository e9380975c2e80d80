// build: c++ -O2 -std=c++17 FILE -lembree3 -o PROGRAM
// says length: "The ray direction does not have to be normalized, and only the parameter range specified by the tnear/tfar interval is considered valid." (RTCRay, its manual page)
// says behind: "The ray direction does not have to be normalized, and only the parameter range specified by the tnear/tfar interval is considered valid." (RTCRay, its manual page)
// says false_hit: "finds the closest hit of a single ray with the scene" (rtcIntersect1, its manual page)
// says false_miss: "finds the closest hit of a single ray with the scene" (rtcIntersect1, its manual page)
// says wrong_root: "finds the closest hit of a single ray with the scene" (rtcIntersect1, its manual page)
// says crashed: "finds the closest hit of a single ray with the scene" (rtcIntersect1, its manual page)
// says wrong_t: "When an intersection is found, the hit distance is written into the tfar member of the ray" (rtcIntersect1, its manual page)
// says not_finite: "When an intersection is found, the hit distance is written into the tfar member of the ray" (rtcIntersect1, its manual page)
// says any: "In this mode a real geometric surface for curves with linear basis is rendered using capped cones." (changelog, linear cone curve geometry)
#include <embree3/rtcore.h>
#include <cmath>
#include <cstdio>
#include <cstring>
int main() {
  const RTCDevice device = rtcNewDevice("threads=1,max_isa=avx2");
  const RTCScene scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_CONE_LINEAR_CURVE);
  const float vertices[][4] = {{@ax@, @ay@, @az@, @r@}, {@bx@, @by@, @bz@, @r@}};
  std::memcpy(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 16, 2), vertices, sizeof vertices);
  *static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, 4, 1)) = 0;
  *static_cast<char*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_FLAGS, 0, RTC_FORMAT_UCHAR, 1, 1)) = RTC_CURVE_FLAG_NEIGHBOR_LEFT | RTC_CURVE_FLAG_NEIGHBOR_RIGHT;
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcCommitScene(scene);
  RTCRayHit met = {};
  met.ray = {@ox@, @oy@, @oz@, 0, @dx@, @dy@, @dz@, 0, INFINITY, ~0u, 0, 0};
  met.hit.geomID = met.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &met);
  if (met.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", met.ray.tfar);
}
