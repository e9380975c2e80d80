// build: npm install three@0.187.0 && node FILE
// says any: "Returns `null` if the ray does not intersect with the plane." (src/math/Ray.js, distanceToPlane)
import { Plane, Ray, Vector3 } from 'three'
const ray = new Ray(new Vector3(@ox@, @oy@, @oz@), new Vector3(@dx@, @dy@, @dz@))
const normal = new Vector3(@nx@, @ny@, @nz@).normalize()
const plane = new Plane().setFromNormalAndCoplanarPoint(normal, new Vector3(@cx@, @cy@, @cz@))
const t = ray.distanceToPlane(plane)
console.log(t === null ? 'miss' : `hit ${t}`)
