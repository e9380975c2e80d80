// @babylonjs/core 9.34.0, Ray.intersectsSphere and Ray.intersectsPlane
// build: npm install @babylonjs/core@9.34.0 && node FILE
// case: sphere 0x1p+1 0x1p+0 0x0p+0 0x1p+0 ray 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+1 0x0p+0
// exact: miss
// observed: yes
// wrong by: rayaudit judge --format double --convention ray=line,extent=unbounded,t_min=0
import { Ray } from '@babylonjs/core/Culling/ray.js'
import { BoundingSphere } from '@babylonjs/core/Culling/boundingSphere.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
const ray = new Ray(new Vector3(0.0, 0.0, 0.0), new Vector3(0.0, 2.0, 0.0))
const sphere = new BoundingSphere(Vector3.Zero(), Vector3.Zero())
sphere.center = new Vector3(2.0, 1.0, 0.0)
sphere.radius = 1.0
console.log(ray.intersectsSphere(sphere) ? 'yes' : 'miss')
