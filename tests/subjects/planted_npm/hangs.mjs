export const subjects = [
  { name: 'npm.hangs', package: 'planted', format: 'double', shapes: ['sphere'], asks: 'nothing', convention: {} },
]

export const load = () => ({ sphere: ({ origin }) => { while (origin.x === 13); return 2 } })
