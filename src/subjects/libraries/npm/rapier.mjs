// rapier: castRay of Ball, Cylinder, Cone and HalfSpace, in floats. Quoted is what its declarations
// (dist, 0.21.0) say.

export const subjects = [
  {
    name: 'npm.rapier', package: '@dimforge/rapier3d-compat', format: 'float',
    shapes: ['disk', 'sphere', 'capped_cylinder', 'capped_cone'], asks: 'Shape.castRay',
    // "A ray. This is a directed half-line." (geometry/ray.d.ts)
    // "The cylinder's half height, along the `y` axis.", of the cone too (geometry/shape.d.ts)
    // "Creates a new halfspace delimited by an infinite plane." (geometry/shape.d.ts)
    convention: { stand: 'upright_y', extent: 'unbounded', ray: 'line', t_min: 0 },
  },
]

export async function load() {
  const rapier = (await import('@dimforge/rapier3d-compat')).default
  await rapier.init()
  const middle = { x: 0, y: 0, z: 0 }, unturned = { x: 0, y: 0, z: 0, w: 1 }
  // "If `false` then the ray will attempt to hit the boundary of a shape, even if its origin already
  // lies inside of a shape." (pipeline/world.d.ts, castRay)
  const solid = false
  // "origin + dir * timeOfImpact" (geometry/ray.d.ts); less than 0 where they do not meet.
  const farthest = 3.4028234663852886e38 // of a float; infinity would be one more that it can tell
  const hit = (shape, at, { origin, direction }) => {
    const t = shape.castRay(new rapier.Ray(origin, direction), at, unturned, farthest, solid)
    return t < 0 ? null : t
  }
  return {
    disk: (ray, { centre, normal }) => hit(new rapier.HalfSpace(normal), centre, ray),
    sphere: (ray, { centre, radius }) => hit(new rapier.Ball(radius), centre, ray),
    capped_cylinder: (ray, { top, radius }) => hit(new rapier.Cylinder(top.y, radius), middle, ray),
    capped_cone: (ray, { apex, radius }) => hit(new rapier.Cone(apex.y, radius), middle, ray),
  }
}
