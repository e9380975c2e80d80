"""Spheres by the textbook: rayaudit audit --program 'python3 mine.py' --shape sphere"""
import math
import sys


def first_hit(centre, radius, origin, direction, t_min, t_max):
    v = [o - c for o, c in zip(origin, centre)]
    a = sum(d * d for d in direction)
    b = sum(x * d for x, d in zip(v, direction))
    c = sum(x * x for x in v) - radius * radius
    discriminant = b * b - a * c
    if a == 0 or not discriminant >= 0:
        return None
    root = math.sqrt(discriminant)
    return next((t for t in ((-b - root) / a, (-b + root) / a) if t_min < t < t_max), None)


# sphere CX CY CZ R ray OX OY OZ DX DY DZ [range TMIN TMAX]
for line in sys.stdin:
    words = line.split()
    if words[0] != "sphere":
        sys.exit("mine.py answers spheres only: --shape sphere")
    x = [float.fromhex(word) for word in words if word not in ("sphere", "ray", "range")]
    t = first_hit(x[0:3], x[3], x[4:7], x[7:10], *(x[10:] or [0, math.inf]))
    print(line.rstrip(), "miss" if t is None else "hit " + t.hex())
