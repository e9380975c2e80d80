// build: npm install playcanvas@2.23.3 && node FILE
// says any: "@returns {boolean} True if there is an intersection.", and of the point: "If there is an intersection, the intersection point will be copied into here." (build/playcanvas.d.ts, BoundingSphere.intersectsRay)
import { BoundingSphere, Ray, Vec3 } from 'playcanvas'
const ray = new Ray(new Vec3(@ox@, @oy@, @oz@), new Vec3(@dx@, @dy@, @dz@))
const sphere = new BoundingSphere(new Vec3(@cx@, @cy@, @cz@), @r@)
const met = new Vec3()
console.log(sphere.intersectsRay(ray, met) ? `at ${met.x} ${met.y} ${met.z}` : 'miss')
