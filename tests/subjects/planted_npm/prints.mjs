export const subjects = [
  { name: 'npm.prints', package: 'planted', format: 'double', shapes: ['sphere'], asks: 'nothing', convention: {} },
]

export const load = () => ({ sphere: () => (console.log("printed"), process.stdout.write("printed\n"), 2) })
