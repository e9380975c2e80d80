// @babylonjs/core 9.34.0, Ray.intersectsSphere and Ray.intersectsPlane
// build: npm install @babylonjs/core@9.34.0 && node FILE
// case: disk 0x1.6697ap+1 0x1.f005cp+1 0x1.c357p+1 -0x1.6e3fa701097ep-1 0x1.5a5c869facf4p-1 -0x1.66a846dbde0ap-3 0x1p+0 unbounded ray 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0
// exact: miss
// observed: hit 0
// wrong by: rayaudit judge --format double --convention direction=unit,ray=line,extent=unbounded,t_min=0
import { Ray } from '@babylonjs/core/Culling/ray.js'
import { Plane } from '@babylonjs/core/Maths/math.plane.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
const ray = new Ray(new Vector3(0.0, 0.0, 0.0), new Vector3(1.0, 0.0, 0.0))
const plane = Plane.FromPositionAndNormal(new Vector3(2.801502227783203, 3.8751754760742188, 3.526092529296875), new Vector3(-0.7153293789640394, 0.6764871663967611, -0.17512565000993607))
const t = ray.intersectsPlane(plane)
console.log(t === null ? 'miss' : `hit ${t}`)
