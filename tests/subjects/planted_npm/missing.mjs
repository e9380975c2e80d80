export const subjects = [
  { name: 'npm.missing', package: 'nowhere', format: 'double', shapes: ['sphere'], asks: 'nothing', convention: {} },
]

export const load = () => ({})
