// @babylonjs/core 9.34.0, Ray.intersectsSphere and Ray.intersectsPlane
// build: npm install @babylonjs/core@9.34.0 && node FILE
// case: disk 0x1p+0 0x0p+0 0x0p+0 0x1.f5dfcp+0 0x1.768p-2 0x1.33284p+1 0x1p+0 unbounded ray 0x0p+0 0x0p+0 0x0p+0 0x1.186cp-1 -0x1.7014p-3 -0x1.ae24p-2
// exact: hit 4210024448 / 5319 = 791506.7584132355706...
// observed: miss
// wrong by: rayaudit judge --format double --convention ray=line,extent=unbounded,t_min=0
import { Ray } from '@babylonjs/core/Culling/ray.js'
import { Plane } from '@babylonjs/core/Maths/math.plane.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
const ray = new Ray(new Vector3(0.0, 0.0, 0.0), new Vector3(0.547698974609375, -0.17972564697265625, -0.4200592041015625))
const plane = Plane.FromPositionAndNormal(new Vector3(1.0, 0.0, 0.0), new Vector3(1.9604454040527344, 0.36572265625, 2.3996658325195312))
const t = ray.intersectsPlane(plane)
console.log(t === null ? 'miss' : `hit ${t}`)
