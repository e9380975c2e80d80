// jolt: CastRay of a TransformedShape, which is what NarrowPhaseQuery.CastRay asks of each body, for
// SphereShape and CylinderShape, in floats. Quoted is the C++ that it is made of
// (Jolt/Physics/Collision/RayCast.h), where its own declarations say nothing. Its cone, a
// TaperedCylinderShape, is not asked: it has no ray cast but that of all convex shapes, by GJK, and "If
// objects are closer than this distance, they are considered to be colliding (used for GJK) (unit: meter)"
// is said of 1.0e-4 (Jolt/Physics/PhysicsSettings.h).

export const subjects = [
  {
    name: 'npm.jolt', package: 'jolt-physics', format: 'float',
    shapes: ['sphere', 'capped_cylinder'], asks: 'TransformedShape.CastRay',
    convention: { stand: 'upright_y', ray: 'line', t_min: 0 },
  },
]

/** A power of two that makes a direction long enough to reach beyond what lies so far. */
function reaching(direction, far) {
  const length = Math.hypot(direction.x, direction.y, direction.z)
  return 2 ** Math.min(Math.max(Math.ceil(Math.log2(far / length)), -300), 300)
}

const distance = (a, b) => Math.hypot(a.x - b.x, a.y - b.y, a.z - b.z)

export async function load() {
  const jolt = await (await import('jolt-physics')).default()
  const standing = new jolt.TransformedShape(), cast = new jolt.RRayCast()
  const collector = new jolt.CastRayClosestHitCollisionCollector()
  const any = new jolt.ShapeFilter(), unturned = new jolt.Quat(0, 0, 0, 1), unscaled = new jolt.Vec3(1, 1, 1)
  const position = new jolt.RVec3(0, 0, 0), origin = new jolt.RVec3(0, 0, 0), direction = new jolt.Vec3(0, 0, 0)
  const settings = new jolt.RayCastSettings()
  // "When true, a ray starting inside a convex shape will generate a hit at fraction 0."
  settings.mTreatConvexAsSolid = false
  settings.SetBackFaceMode(jolt.EBackFaceMode_CollideWithBackFaces)

  /** The hit on a shape of that reach about its middle. */
  function hit(shape, middle, reach, ray) {
    // "Direction and length of the ray (anything beyond this length will not be reported as a hit)"
    const scale = reaching(ray.direction, 2 * (distance(ray.origin, middle) + reach))
    shape.AddRef()
    standing.mShape = shape
    position.Set(middle.x, middle.y, middle.z)
    standing.SetWorldTransform(position, unturned, unscaled)
    origin.Set(ray.origin.x, ray.origin.y, ray.origin.z)
    direction.Set(scale * ray.direction.x, scale * ray.direction.y, scale * ray.direction.z)
    cast.mOrigin = origin
    cast.mDirection = direction
    collector.Reset()
    standing.CastRay(cast, settings, collector, any)
    standing.mShape = nothing
    shape.Release()
    return collector.HadHit() ? collector.mHit.mFraction * scale : null
  }

  const nothing = new jolt.SphereShape(1)
  nothing.AddRef()
  const middle = { x: 0, y: 0, z: 0 }, no_radius = 0
  return {
    sphere: (ray, { centre, radius }) => hit(new jolt.SphereShape(radius), centre, radius, ray),
    capped_cylinder: (ray, { top, radius }) =>
      hit(new jolt.CylinderShape(top.y, radius, no_radius), middle, top.y + radius, ray),
  }
}
