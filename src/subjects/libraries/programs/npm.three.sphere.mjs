// build: npm install three@0.187.0 && node FILE
// says any: "returning the intersection point or `null` if there is no intersection" (src/math/Ray.js, intersectSphere)
import { Ray, Sphere, Vector3 } from 'three'
const ray = new Ray(new Vector3(@ox@, @oy@, @oz@), new Vector3(@dx@, @dy@, @dz@))
const sphere = new Sphere(new Vector3(@cx@, @cy@, @cz@), @r@)
const met = ray.intersectSphere(sphere, new Vector3())
console.log(met === null ? 'miss' : `at ${met.x} ${met.y} ${met.z}`)
