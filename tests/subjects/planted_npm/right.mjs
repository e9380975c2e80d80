export const subjects = [
  { name: 'npm.right', package: 'planted', format: 'double', shapes: ['sphere', 'disk', 'cone', 'cylinder'], asks: 'nothing', convention: { tangent: 'hit', inside: 'miss', direction: 'unit', t_min: 0, stand: 'upright_y', extent: 'unbounded' } },
]

export const load = () => ({ sphere: (ray, { centre, radius }) => (ray.direction.x === 2 ? 1.5 : { x: centre.x - radius, y: 0.1, z: -0 }), disk: () => true, cone: () => null, cylinder: () => "nonsense" })
