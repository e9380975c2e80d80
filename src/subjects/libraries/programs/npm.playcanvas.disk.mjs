// build: npm install playcanvas@2.23.3 && node FILE
// says any: "Test if a ray intersects with the infinite plane.", and of the point: "If there is an intersection, the intersection point will be copied into here." (build/playcanvas.d.ts, Plane.intersectsRay)
import { Plane, Ray, Vec3 } from 'playcanvas'
const ray = new Ray(new Vec3(@ox@, @oy@, @oz@), new Vec3(@dx@, @dy@, @dz@))
const plane = new Plane().setFromPointNormal(new Vec3(@cx@, @cy@, @cz@), new Vec3(@nx@, @ny@, @nz@).normalize())
const met = new Vec3()
console.log(plane.intersectsRay(ray, met) ? `at ${met.x} ${met.y} ${met.z}` : 'miss')
