export const subjects = [
  { name: 'npm.unloadable', package: 'planted', format: 'double', shapes: ['sphere'], asks: 'nothing', convention: {} },
]

export const load = () => import('no_such_package')
