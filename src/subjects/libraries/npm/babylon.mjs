// babylon: Ray against BoundingSphere and Plane. Quoted is what its declarations (Culling/ray.core.d.ts
// and Maths/math.plane.js, 9.34.0) say.

// "Checks if ray intersects a plane", and "If the ray hits a sphere": of a direction's length they say
// nothing. It is also asked with directions of length 1, as its own CreateNewFromTo makes them.
const half = { extent: 'unbounded', ray: 'line', t_min: 0 }
const made = {
  package: '@babylonjs/core', format: 'double', shapes: ['disk', 'sphere'],
  asks: 'Ray.intersectsSphere and Ray.intersectsPlane',
}

export const subjects = [
  { ...made, name: 'npm.babylon', convention: half },
  { ...made, name: 'npm.babylon_unit', convention: { ...half, direction: 'unit' } },
]

export async function load() {
  const { Ray } = await import('@babylonjs/core/Culling/ray.js')
  const { BoundingSphere } = await import('@babylonjs/core/Culling/boundingSphere.js')
  const { Plane } = await import('@babylonjs/core/Maths/math.plane.js')
  const { Vector3 } = await import('@babylonjs/core/Maths/math.vector.js')
  const ray = new Ray(Vector3.Zero(), Vector3.Zero())
  const ball = new BoundingSphere(Vector3.Zero(), Vector3.Zero())
  const vector = ({ x, y, z }) => new Vector3(x, y, z)
  const set = ({ origin, direction }) =>
    (ray.origin.copyFrom(vector(origin)), ray.direction.copyFrom(vector(direction)), ray)
  const sphere = ({ centre, radius }) =>
    (ball.center.copyFrom(vector(centre)), (ball.radius = radius), ball)
  return {
    // "@returns true if it hits the sphere"
    sphere: (along, of) => set(along).intersectsSphere(sphere(of)),
    // "@returns the distance away it was hit"
    disk: (along, { centre, normal }) =>
      set(along).intersectsPlane(Plane.FromPositionAndNormal(vector(centre), vector(normal))),
  }
}
