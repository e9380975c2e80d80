// build: npm install jolt-physics@1.1.0 && node FILE
// says any: "Direction and length of the ray (anything beyond this length will not be reported as a hit)" (Jolt/Physics/Collision/RayCast.h)
import load from 'jolt-physics'
const jolt = await load()
const scale = 2 ** Math.ceil(Math.log2(2 * (Math.hypot(@ox@ - @cx@, @oy@ - @cy@, @oz@ - @cz@) + @r@) / Math.hypot(@dx@, @dy@, @dz@))) // beyond the shape
const shape = new jolt.SphereShape(@r@)
const body = new jolt.TransformedShape()
body.mShape = shape
body.SetWorldTransform(new jolt.RVec3(@cx@, @cy@, @cz@), new jolt.Quat(0, 0, 0, 1), new jolt.Vec3(1, 1, 1))
const ray = new jolt.RRayCast(new jolt.RVec3(@ox@, @oy@, @oz@), new jolt.Vec3(@dx@ * scale, @dy@ * scale, @dz@ * scale))
const settings = new jolt.RayCastSettings(), hit = new jolt.CastRayClosestHitCollisionCollector()
settings.mTreatConvexAsSolid = false
settings.SetBackFaceMode(jolt.EBackFaceMode_CollideWithBackFaces)
body.CastRay(ray, settings, hit, new jolt.ShapeFilter())
console.log(hit.HadHit() ? `hit ${hit.mHit.mFraction * scale}` : 'miss')
