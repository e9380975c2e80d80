// Embree 3.13.5, rtcIntersect1
// build: c++ -O2 -std=c++17 FILE -lembree3 -o PROGRAM
// case: capped_cone 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+4 0x1p+0 ray 0x0p+0 0x0p+0 -0x1p+1 0x1p+0 0x0p+0 0x1p+0
// exact: miss
// observed: hit 2.592773199081421
// wrong by: rayaudit judge --format float --convention t_min=0
#include <embree3/rtcore.h>
#include <cmath>
#include <cstdio>
#include <cstring>
int main() {
  const RTCDevice device = rtcNewDevice("threads=1,max_isa=avx2");
  const RTCScene scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_CONE_LINEAR_CURVE);
  const float vertices[][4] = {{0.0f, 0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 16.0f, 0}};
  std::memcpy(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 16, 2), vertices, sizeof vertices);
  *static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, 4, 1)) = 0;
  *static_cast<char*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_FLAGS, 0, RTC_FORMAT_UCHAR, 1, 1)) = 0;
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcCommitScene(scene);
  RTCRayHit met = {};
  met.ray = {0.0f, 0.0f, -2.0f, 0, 1.0f, 0.0f, 1.0f, 0, INFINITY, ~0u, 0, 0};
  met.hit.geomID = met.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &met);
  if (met.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", met.ray.tfar);
}
