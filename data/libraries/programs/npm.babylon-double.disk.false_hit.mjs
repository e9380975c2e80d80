// @babylonjs/core 9.34.0, Ray.intersectsSphere and Ray.intersectsPlane
// build: npm install @babylonjs/core@9.34.0 && node FILE
// case: disk 0x0p+0 0x0p+0 0x0p+0 0x1.3395p+1 0x1.418p-5 -0x1.1cf8p+0 0x1p+0 unbounded ray 0x1.83088p-3 0x1.ce6p-3 0x1.a9e6p-2 -0x1p+0 0x0p+0 0x0p+0
// exact: miss
// observed: hit 0
// wrong by: rayaudit judge --format double --convention ray=line,extent=unbounded,t_min=0
import { Ray } from '@babylonjs/core/Culling/ray.js'
import { Plane } from '@babylonjs/core/Maths/math.plane.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
const ray = new Ray(new Vector3(0.1889810562133789, 0.22576904296875, 0.41591644287109375), new Vector3(-1.0, 0.0, 0.0))
const plane = Plane.FromPositionAndNormal(new Vector3(0.0, 0.0, 0.0), new Vector3(2.402984619140625, 0.03924560546875, -1.1131591796875))
const t = ray.intersectsPlane(plane)
console.log(t === null ? 'miss' : `hit ${t}`)
