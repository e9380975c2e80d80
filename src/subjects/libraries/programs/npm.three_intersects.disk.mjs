// build: npm install three@0.187.0 && node FILE
// says any: "Returns `true` if this ray intersects with the given plane." (src/math/Ray.js, intersectsPlane)
import { Plane, Ray, Vector3 } from 'three'
const ray = new Ray(new Vector3(@ox@, @oy@, @oz@), new Vector3(@dx@, @dy@, @dz@))
const normal = new Vector3(@nx@, @ny@, @nz@).normalize()
const plane = new Plane().setFromNormalAndCoplanarPoint(normal, new Vector3(@cx@, @cy@, @cz@))
console.log(ray.intersectsPlane(plane) ? 'yes' : 'miss')
