#include <embree3/rtcore.h>

#include <initializer_list>
#include <limits>

#include "rayaudit/plugin.h"

/// Embree as a plugin: those of its primitives that are shapes of ours, each alone in a scene. What
/// is relied on is quoted from the section of its API manual (the man pages of 3.13.5) that says
/// so.
namespace {

struct Vertex {
  float x, y, z, radius;
};
struct Vector {
  float x, y, z;
};

Vertex vertex(const rayaudit_vec3& at, double radius) {
  return {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z),
          static_cast<float>(radius)};
}
Vector vector(const rayaudit_vec3& of) {
  return {static_cast<float>(of.x), static_cast<float>(of.y), static_cast<float>(of.z)};
}

/// A scene of one primitive, which is another for every case; it stays as long as the process. With
/// AVX2 and no more, so that any processor that has it answers the same.
class Scene {
 public:
  explicit Scene(RTCGeometryType type, RTCDevice device = rtcNewDevice("threads=1,max_isa=avx2"))
      : scene_(rtcNewScene(device)), geometry_(rtcNewGeometry(device, type)) {
    // "avoids optimizations that reduce arithmetic accuracy" (rtcSetSceneFlags)
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
  }

  /// The values that make the primitive.
  template <class T>
  T* buffer(RTCBufferType type, RTCFormat format, std::size_t count) {
    return static_cast<T*>(rtcSetNewGeometryBuffer(geometry_, type, 0, format, sizeof(T), count));
  }
  void attach() {
    rtcCommitGeometry(geometry_);
    rtcAttachGeometry(scene_, geometry_);
  }

  /// The first hit on what the buffers hold now, of which these have changed.
  rayaudit_answer hit(const rayaudit_ray& ray, std::initializer_list<RTCBufferType> changed) {
    for (const RTCBufferType type : changed) rtcUpdateGeometryBuffer(geometry_, type, 0);
    rtcCommitGeometry(geometry_);
    rtcCommitScene(scene_);
    const auto [ox, oy, oz] = vector(ray.origin);
    const auto [dx, dy, dz] = vector(ray.direction);
    const auto near = static_cast<float>(ray.t_min), far = static_cast<float>(ray.t_max);
    RTCRayHit met = {};
    // "The ray direction does not have to be normalized, and only the parameter range specified by
    // the tnear/tfar interval is considered valid" (RTCRay): t is in units of the direction.
    met.ray = {ox, oy, oz, near, dx, dy, dz, 0, far, ~0u, 0, 0};
    met.hit.geomID = met.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_, &context, &met);
    if (met.hit.geomID == RTC_INVALID_GEOMETRY_ID) return rayaudit_miss();
    return rayaudit_hit(
        met.ray.tfar);  // "the hit distance is written into the tfar" (rtcIntersect1)
  }

 private:
  RTCScene scene_;
  RTCGeometry geometry_;
};

/// "the point is rendered as a normal oriented disc" (RTC_GEOMETRY_TYPE_*_POINT)
struct Disks {
  Scene scene{RTC_GEOMETRY_TYPE_ORIENTED_DISC_POINT};
  Vertex* centre = scene.buffer<Vertex>(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 1);
  Vector* normal = scene.buffer<Vector>(RTC_BUFFER_TYPE_NORMAL, RTC_FORMAT_FLOAT3, 1);

  Disks() { scene.attach(); }
  rayaudit_answer hit(const rayaudit_ray& ray, const rayaudit_disk& disk) {
    *centre = vertex(disk.centre, disk.radius);
    *normal = vector(disk.normal);
    return scene.hit(ray, {RTC_BUFFER_TYPE_VERTEX, RTC_BUFFER_TYPE_NORMAL});
  }
};

/// "a real geometric surface is rendered" (RTC_GEOMETRY_TYPE_*_POINT)
struct Spheres {
  Scene scene{RTC_GEOMETRY_TYPE_SPHERE_POINT};
  Vertex* centre = scene.buffer<Vertex>(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 1);

  Spheres() { scene.attach(); }
  rayaudit_answer hit(const rayaudit_ray& ray, const rayaudit_sphere& sphere) {
    *centre = vertex(sphere.centre, sphere.radius);
    return scene.hit(ray, {RTC_BUFFER_TYPE_VERTEX});
  }
};

/// "rendered using capped cones" (changelog), with the radii of its two ends. It has a cap where
/// its flags, which "determine if a neighboring segment exists" (RTCCurveFlags), name no neighbour
/// to "properly attach to" (RTC_GEOMETRY_TYPE_CURVE).
template <int neighbours>
struct Curves {
  Scene scene{RTC_GEOMETRY_TYPE_CONE_LINEAR_CURVE};
  Vertex* ends = scene.buffer<Vertex>(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 2);

  Curves() {
    *scene.buffer<unsigned>(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, 1) = 0;
    *scene.buffer<unsigned char>(RTC_BUFFER_TYPE_FLAGS, RTC_FORMAT_UCHAR, 1) = neighbours;
    scene.attach();
  }
  rayaudit_answer hit(const rayaudit_ray& ray, const rayaudit_cylinder& cylinder) {
    ends[0] = vertex(cylinder.base, cylinder.radius);
    ends[1] = vertex(cylinder.top, cylinder.radius);
    return scene.hit(ray, {RTC_BUFFER_TYPE_VERTEX});
  }
  rayaudit_answer hit(const rayaudit_ray& ray, const rayaudit_cone& cone) {
    ends[0] = vertex(cone.base, cone.radius);
    ends[1] = vertex(cone.apex, 0);
    return scene.hit(ray, {RTC_BUFFER_TYPE_VERTEX});
  }
};

using Open = Curves<RTC_CURVE_FLAG_NEIGHBOR_LEFT | RTC_CURVE_FLAG_NEIGHBOR_RIGHT>;
using Capped = Curves<0>;

/// The batch of a primitive that stands for a shape, which is a member of what a case is.
template <class Primitive, auto shape>
void batch(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  static Primitive primitive;
  for (std::size_t i = 0; i < count; ++i)
    answers[i] = primitive.hit(cases[i].ray, cases[i].is.*shape);
}

/// "The ray segment must be in the range [0, inf], thus ranges that start behind the ray origin are
/// not allowed" (RTCRay). Of hits exactly at its ends "the implementation makes no guarantees"
/// (rtcIntersect1), and of other touches the manual says nothing: either is right.
constexpr rayaudit_convention declared() {
  rayaudit_convention made = {};
  made.t_min = 0, made.t_max = std::numeric_limits<double>::infinity();
  return made;
}

using Shapes = decltype(rayaudit_case::is);
const rayaudit_subject subjects[] = {{.name = "embree",
                                      .format = "float",
                                      .convention = declared(),
                                      .disk = batch<Disks, &Shapes::disk>,
                                      .sphere = batch<Spheres, &Shapes::sphere>,
                                      .cylinder = batch<Open, &Shapes::cylinder>,
                                      .cone = batch<Open, &Shapes::cone>,
                                      .capped_cylinder = batch<Capped, &Shapes::capped_cylinder>,
                                      .capped_cone = batch<Capped, &Shapes::capped_cone>,
                                      .about = "Embree " RTC_VERSION_STRING ", rtcIntersect1"}};

}  // namespace

RAYAUDIT_PLUGIN(subjects)
