// playcanvas: BoundingSphere and Plane against Ray. Quoted is what its declarations
// (build/playcanvas.d.ts, 2.23.3) say.

export const subjects = [
  {
    name: 'npm.playcanvas', package: 'playcanvas', format: 'double', shapes: ['disk', 'sphere'],
    asks: 'BoundingSphere.intersectsRay and Plane.intersectsRay',
    // "Ray to test against (direction must be normalized)" (BoundingSphere and Plane, intersectsRay)
    // "Test if a ray intersects with the infinite plane" (Plane, intersectsRay)
    convention: { direction: 'unit', extent: 'unbounded', ray: 'line', t_min: 0 },
  },
]

export async function load() {
  // The same in one file, which is read in a fraction of the time of a thousand.
  const { BoundingSphere, Plane, Ray, Vec3 } = await import('./node_modules/playcanvas/build/playcanvas.mjs')
  const ray = new Ray(), ball = new BoundingSphere(), plane = new Plane(), normal = new Vec3(), at = new Vec3()
  const set = ({ origin, direction }) => ray.set(origin, direction)
  const sphere = ({ centre, radius }) => (ball.center.copy(centre), (ball.radius = radius), ball)
  const disk = (of) => plane.setFromPointNormal(normal.copy(of.centre), new Vec3().copy(of.normal).normalize())
  return {
    // "If there is an intersection, the intersection point will be copied into here."
    sphere: (along, of) => sphere(of).intersectsRay(set(along), at) && at,
    disk: (along, of) => disk(of).intersectsRay(set(along), at) && at,
  }
}
