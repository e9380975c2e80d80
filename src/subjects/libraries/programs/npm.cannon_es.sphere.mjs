// build: npm install cannon-es@0.20.0 && node FILE
// says any: "Ray cast, and return information of the closest hit." and "@return True if any body was hit." (dist/cannon-es.js, World.raycastClosest)
import { Body, RaycastResult, Sphere, Vec3, World } from 'cannon-es'
const from = new Vec3(@ox@, @oy@, @oz@), to = from.vadd(new Vec3(@dx@, @dy@, @dz@))
const world = new World(), met = new RaycastResult()
world.addBody(new Body({ mass: 0, shape: new Sphere(@r@), position: new Vec3(@cx@, @cy@, @cz@) }))
const is_hit = world.raycastClosest(from, to, {}, met), { x, y, z } = met.hitPointWorld
console.log(is_hit ? `at ${x} ${y} ${z}` : 'miss')
