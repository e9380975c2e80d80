// three: Ray against Sphere and Plane. Quoted is what its source (src/math, 0.187.0) says.

// "The (normalized) direction of the ray." (Ray.js, direction)
// "a unit length normal vector and a constant" (Plane.js) make an endless plane.
const convention = { direction: 'unit', extent: 'unbounded', ray: 'line', t_min: 0 }
const made = { package: 'three', format: 'double', shapes: ['disk', 'sphere'], convention }

export const subjects = [
  { ...made, name: 'npm.three', asks: 'Ray.intersectSphere and Ray.distanceToPlane' },
  { ...made, name: 'npm.three_intersects', asks: 'Ray.intersectsSphere and Ray.intersectsPlane' },
]

export async function load({ name }) {
  const { Plane, Ray, Sphere, Vector3 } = await import('three')
  const ray = new Ray(), plane = new Plane(), ball = new Sphere(), normal = new Vector3(), at = new Vector3(), on = new Vector3()
  const set = ({ origin, direction }) => (ray.origin.copy(origin), ray.direction.copy(direction), ray)
  const sphere = ({ centre, radius }) => (ball.center.copy(centre), (ball.radius = radius), ball)
  const disk = (of) => plane.setFromNormalAndCoplanarPoint(normal.copy(of.normal).normalize(), on.copy(of.centre))
  if (name === 'npm.three_intersects')
    return {
      sphere: (along, of) => set(along).intersectsSphere(sphere(of)),
      disk: (along, of) => set(along).intersectsPlane(disk(of)),
    }
  return {
    // "returning the intersection point or `null` if there is no intersection" (Ray.js)
    sphere: (along, of) => set(along).intersectSphere(sphere(of), at),
    disk: (along, of) => set(along).distanceToPlane(disk(of)),
  }
}
