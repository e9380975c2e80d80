// playcanvas 2.23.3, BoundingSphere.intersectsRay and Plane.intersectsRay
// build: npm install playcanvas@2.23.3 && node FILE
// case: sphere 0x0p+0 0x1p+1 0x0p+0 0x1.8p+1 ray 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0
// exact: hit 5, at 0 5 0
// observed: at 0 1 0
// wrong by: rayaudit judge --format double --convention direction=unit,ray=line,extent=unbounded,t_min=0
import { BoundingSphere, Ray, Vec3 } from 'playcanvas'
const ray = new Ray(new Vec3(0.0, 0.0, 0.0), new Vec3(0.0, 1.0, 0.0))
const sphere = new BoundingSphere(new Vec3(0.0, 2.0, 0.0), 3.0)
const met = new Vec3()
console.log(sphere.intersectsRay(ray, met) ? `at ${met.x} ${met.y} ${met.z}` : 'miss')
