// build: npm install @dimforge/rapier3d-compat@0.21.0 && node FILE
// says inside: "If `false` then the ray will attempt to hit the boundary of a shape, even if its origin already lies inside of a shape. In other terms, [...] `false` implies that all shapes are hollow for this ray-cast." (pipeline/world.d.ts, castRay)
// says any: "The maximum time-of-impact that can be reported by this cast. This effectively limits the length of the ray to `ray.dir.norm() * maxToi`." (pipeline/world.d.ts, castRay)
import rapier from '@dimforge/rapier3d-compat'
await rapier.init()
const ray = new rapier.Ray({ x: @ox@, y: @oy@, z: @oz@ }, { x: @dx@, y: @dy@, z: @dz@ })
const shape = new rapier.HalfSpace({ x: @nx@, y: @ny@, z: @nz@ })
const t = shape.castRay(ray, { x: @cx@, y: @cy@, z: @cz@ }, { x: 0, y: 0, z: 0, w: 1 }, 3.4028234663852886e38, false)
console.log(t < 0 ? 'miss' : `hit ${t}`)
