// build: npm install @babylonjs/core@9.34.0 && node FILE
// says any: "@returns true if it hits the sphere" (Culling/ray.core.d.ts, intersectsSphere), and of the direction's length nothing is said ("@param direction direction")
import { Ray } from '@babylonjs/core/Culling/ray.js'
import { BoundingSphere } from '@babylonjs/core/Culling/boundingSphere.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
const ray = new Ray(new Vector3(@ox@, @oy@, @oz@), new Vector3(@dx@, @dy@, @dz@))
const sphere = new BoundingSphere(Vector3.Zero(), Vector3.Zero())
sphere.center = new Vector3(@cx@, @cy@, @cz@)
sphere.radius = @r@
console.log(ray.intersectsSphere(sphere) ? 'yes' : 'miss')
