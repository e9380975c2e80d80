// build: npm install @babylonjs/core@9.34.0 && node FILE
// says any: "Checks if ray intersects a plane" and "@returns the distance away it was hit" (Culling/ray.core.d.ts, intersectsPlane)
import { Ray } from '@babylonjs/core/Culling/ray.js'
import { Plane } from '@babylonjs/core/Maths/math.plane.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
const ray = new Ray(new Vector3(@ox@, @oy@, @oz@), new Vector3(@dx@, @dy@, @dz@))
const plane = Plane.FromPositionAndNormal(new Vector3(@cx@, @cy@, @cz@), new Vector3(@nx@, @ny@, @nz@))
const t = ray.intersectsPlane(plane)
console.log(t === null ? 'miss' : `hit ${t}`)
