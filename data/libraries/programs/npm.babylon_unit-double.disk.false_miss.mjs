// @babylonjs/core 9.34.0, Ray.intersectsSphere and Ray.intersectsPlane
// build: npm install @babylonjs/core@9.34.0 && node FILE
// case: disk 0x1p+0 0x0p+0 0x0p+0 0x1.8ce7d5e706e78p-1 0x1.42d90aec55cp-1 0x1.3793f20022p-5 0x1p+0 unbounded ray 0x0p+0 0x0p+0 0x0p+0 0x1.0e9bb859d6c4p-1 -0x1.5c5c3cf7b331cp-1 0x1.03ec6e3dc4dc8p-1
// exact: hit 122836335879339865837043449856 / 139494482884281577823327 = 880582.03693431681989...
// observed: miss
// wrong by: rayaudit judge --format double --convention direction=unit,ray=line,extent=unbounded,t_min=0
import { Ray } from '@babylonjs/core/Culling/ray.js'
import { Plane } from '@babylonjs/core/Maths/math.plane.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
const ray = new Ray(new Vector3(0.0, 0.0, 0.0), new Vector3(0.5285318002382908, -0.6803912212722909, 0.5076631975556944))
const plane = Plane.FromPositionAndNormal(new Vector3(1.0, 0.0, 0.0), new Vector3(0.7752062649264664, 0.6305621541495157, 0.03803441301084831))
const t = ray.intersectsPlane(plane)
console.log(t === null ? 'miss' : `hit ${t}`)
