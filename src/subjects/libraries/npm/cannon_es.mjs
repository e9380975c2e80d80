// cannon-es: World.raycastClosest against a body that is a Sphere. Its Cylinder is a convex polyhedron
// ("The cylinder class extends ConvexPolyhedron", dist/cannon-es.js, 0.20.0), and its Plane is turned
// to a normal by a quaternion, which is rounded: neither is a shape of ours as it is asked.

export const subjects = [
  {
    name: 'npm.cannon_es', package: 'cannon-es', format: 'double', shapes: ['sphere'],
    asks: 'World.raycastClosest',
    // raycastClosest(from, to, ...): "Ray cast, and return information of the closest hit."
    convention: { ray: 'segment', t_min: 0, t_max: 1 },
  },
]

export async function load() {
  const { Body, RaycastResult, Sphere, Vec3, World } = await import('cannon-es')
  const world = new World(), met = new RaycastResult()
  return {
    sphere({ origin, direction }, { centre, radius }) {
      const from = new Vec3(origin.x, origin.y, origin.z)
      // Exactly: such rays are made for it, and another is a miss.
      const to = new Vec3(origin.x + direction.x, origin.y + direction.y, origin.z + direction.z)
      const position = new Vec3(centre.x, centre.y, centre.z)
      const body = new Body({ mass: 0, shape: new Sphere(radius), position })
      world.addBody(body)
      const is_hit = world.raycastClosest(from, to, {}, met)
      world.removeBody(body)
      return is_hit && met.hitPointWorld
    },
  }
}
