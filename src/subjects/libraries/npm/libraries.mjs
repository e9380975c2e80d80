// The libraries that are asked, each by the module of its name beside this one. A new one is that
// module, a line here, and its package in package.json.
//
// A module exports `subjects`, what is told of it: name, format, the shapes it answers, its
// convention in the words of --convention, the package, and which functions of it are asked; and
// `load`, which loads the package and gives a function for each shape: of a ray and that shape, its
// answer. A library that takes no range for t is asked the half-line, whatever the ray has: { ray:
// 'line', t_min: 0 }. Nothing is loaded before it is asked, so that no library keeps another from answering.
export default ['babylon', 'cannon_es', 'jolt', 'playcanvas', 'rapier', 'three']
