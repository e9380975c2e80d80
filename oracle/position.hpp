#pragma once

#include "oracle/truth.hpp"

/// What the judge asks about the place of an answer: by the same fields as the truth, and where
/// double-word numbers do not tell, by exact numbers.
namespace rayaudit::oracle {

/// Where a point lies beside a surface.
struct Position {
  int sign_of_field;  ///< exactly that of F, or of the cap's field, at the point: -1, 0, 1
  Real distance;      ///< |F| / |grad F|, the distance to first order; NaN where grad F is 0
};

/// The position of a finite point beside a patch of the shape of a valid case, the one of that
/// number in a Crossing.
Position position(const Shape& shape, const Vec3<Real>& point, int patch = 0);

/// How the t of a crossing answers to the numbers of its case.
struct Sensitivity {
  Real forced;      ///< sum |x_j dt/dx_j| over every number of the case; infinite at a double root
  int sign_before;  ///< the sign of the patch's field just before the crossing
};
Sensitivity sensitivity(const Case& question, const Crossing& crossing);

/// The exact projection ((p - o).d) / (d.d) of a finite point, to 2^-bits of itself.
Real projection(const Ray<double>& ray, const Vec3<Real>& point, int bits);

}  // namespace rayaudit::oracle
