// cannon-es 0.20.0, World.raycastClosest
// build: npm install cannon-es@0.20.0 && node FILE
// case: sphere 0x1p+3 0x1p+1 0x1.cp+2 0x1.8p+2 ray 0x0p+0 0x0p+0 0x0p+0 0x1p+1 0x1p+1 0x1p+0 range 0x0p+0 0x1p+0
// exact: miss
// observed: at 0 0 0
// wrong by: rayaudit judge --format double --convention ray=segment,t_min=0,t_max=1
import { Body, RaycastResult, Sphere, Vec3, World } from 'cannon-es'
const from = new Vec3(0.0, 0.0, 0.0), to = from.vadd(new Vec3(2.0, 2.0, 1.0))
const world = new World(), met = new RaycastResult()
world.addBody(new Body({ mass: 0, shape: new Sphere(6.0), position: new Vec3(8.0, 2.0, 7.0) }))
const is_hit = world.raycastClosest(from, to, {}, met), { x, y, z } = met.hitPointWorld
console.log(is_hit ? `at ${x} ${y} ${z}` : 'miss')
