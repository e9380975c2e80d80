// @babylonjs/core 9.34.0, Ray.intersectsSphere and Ray.intersectsPlane
// build: npm install @babylonjs/core@9.34.0 && node FILE
// case: sphere 0x0p+0 0x0p+0 0x0p+0 0x1p+0 ray 0x1p+1 0x0p+0 0x0p+0 -0x1p-1 0x0p+0 0x0p+0
// exact: hit 2
// observed: miss
// wrong by: rayaudit judge --format double --convention ray=line,extent=unbounded,t_min=0
import { Ray } from '@babylonjs/core/Culling/ray.js'
import { BoundingSphere } from '@babylonjs/core/Culling/boundingSphere.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
const ray = new Ray(new Vector3(2.0, 0.0, 0.0), new Vector3(-0.5, 0.0, 0.0))
const sphere = new BoundingSphere(Vector3.Zero(), Vector3.Zero())
sphere.center = new Vector3(0.0, 0.0, 0.0)
sphere.radius = 1.0
console.log(ray.intersectsSphere(sphere) ? 'yes' : 'miss')
