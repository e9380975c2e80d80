// build: npm install three@0.187.0 && node FILE
// says any: "Returns `true` if this ray intersects with the given sphere." (src/math/Ray.js, intersectsSphere)
import { Ray, Sphere, Vector3 } from 'three'
const ray = new Ray(new Vector3(@ox@, @oy@, @oz@), new Vector3(@dx@, @dy@, @dz@))
const sphere = new Sphere(new Vector3(@cx@, @cy@, @cz@), @r@)
console.log(ray.intersectsSphere(sphere) ? 'yes' : 'miss')
