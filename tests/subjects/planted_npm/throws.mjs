export const subjects = [
  { name: 'npm.throws', package: 'planted', format: 'double', shapes: ['sphere'], asks: 'nothing', convention: {} },
]

export const load = () => ({ sphere: ({ origin }) => { if (origin.x === 13) throw new Error("it is 13"); return 2 } })
