// @dimforge/rapier3d-compat 0.21.0, Shape.castRay
// build: npm install @dimforge/rapier3d-compat@0.21.0 && node FILE
// case: capped_cone 0x0p+0 -0x1.4p-7 0x0p+0 0x0p+0 0x1.4p-7 0x0p+0 0x1p-5 ray 0x1.4p-5 -0x1p-7 0x0p+0 0x0p+0 0x0p+0 0x1p+0
// exact: miss
// observed: hit 0.017216864973306656
// wrong by: rayaudit judge --format float --convention ray=line,extent=unbounded,stand=upright_y,t_min=0
import rapier from '@dimforge/rapier3d-compat'
await rapier.init()
const ray = new rapier.Ray({ x: 0.0390625, y: -0.0078125, z: 0.0 }, { x: 0.0, y: 0.0, z: 1.0 })
const shape = new rapier.Cone(0.009765625, 0.03125)
const t = shape.castRay(ray, { x: 0, y: 0, z: 0 }, { x: 0, y: 0, z: 0, w: 1 }, 3.4028234663852886e38, false)
console.log(t < 0 ? 'miss' : `hit ${t}`)
