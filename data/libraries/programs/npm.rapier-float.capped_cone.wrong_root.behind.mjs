// @dimforge/rapier3d-compat 0.21.0, Shape.castRay
// build: npm install @dimforge/rapier3d-compat@0.21.0 && node FILE
// case: capped_cone 0x0p+0 -0x1p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x1p+0 ray 0x0p+0 0x0p+0 0x0p+0 0x1p-2 -0x1p-2 0x1p-2
// exact: hit (4 + 8 sqrt(2)) / 7 = 2.1876726427121086272...
// observed: hit 0.36125850677490234
// wrong by: rayaudit judge --format float --convention ray=line,extent=unbounded,stand=upright_y,t_min=0
import rapier from '@dimforge/rapier3d-compat'
await rapier.init()
const ray = new rapier.Ray({ x: 0.0, y: 0.0, z: 0.0 }, { x: 0.25, y: -0.25, z: 0.25 })
const shape = new rapier.Cone(1.0, 1.0)
const t = shape.castRay(ray, { x: 0, y: 0, z: 0 }, { x: 0, y: 0, z: 0, w: 1 }, 3.4028234663852886e38, false)
console.log(t < 0 ? 'miss' : `hit ${t}`)
