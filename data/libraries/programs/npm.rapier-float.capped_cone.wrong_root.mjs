// @dimforge/rapier3d-compat 0.21.0, Shape.castRay
// build: npm install @dimforge/rapier3d-compat@0.21.0 && node FILE
// case: capped_cone 0x0p+0 -0x1.5ep+0 0x0p+0 0x0p+0 0x1.5ep+0 0x0p+0 0x1p+0 ray 0x0p+0 -0x1p+0 0x0p+0 0x0p+0 -0x1.8p-2 0x1p+0
// exact: hit 47 / 48 = 0.97916666666666666667...
// observed: hit 1.0470560789108276
// wrong by: rayaudit judge --format float --convention ray=line,extent=unbounded,stand=upright_y,t_min=0
import rapier from '@dimforge/rapier3d-compat'
await rapier.init()
const ray = new rapier.Ray({ x: 0.0, y: -1.0, z: 0.0 }, { x: 0.0, y: -0.375, z: 1.0 })
const shape = new rapier.Cone(1.3671875, 1.0)
const t = shape.castRay(ray, { x: 0, y: 0, z: 0 }, { x: 0, y: 0, z: 0, w: 1 }, 3.4028234663852886e38, false)
console.log(t < 0 ? 'miss' : `hit ${t}`)
