#pragma once

#include "subjects/convention.hpp"

/// The steps by which a case becomes the one that a subject is asked: each in the numbers of a
/// format that cases are drawn in, each leaving as it is what it has made already.
namespace rayaudit::posing {

/// The nearest number of the format.
double in_format(long double x, const Format& format);

/// The same world turned and moved so that a cylinder or cone, capped or not, stands with its base
/// at (0, 0, -h) and its top or apex at (0, 0, h), or so along y: with long doubles, each number
/// rounded once. It is turned by a rotation, no mirror: where the axis lies along a coordinate axis
/// coordinates only change places and signs, exactly. Numbers that leave the range of the format
/// are brought back by a power of two for the world, another for the direction, and the range with
/// them. A case with a number that is not finite, or without an axis, stays.
Case stood(const Case& question, Convention::Stand stand, const Format& format);

/// A cone that stands, scaled to height 1 and with the radius that the opening, a number of the
/// format, has: a double that has this opening again where it is worked out to more digits than
/// that. So base and apex are exact and the radius is to 2^-53: what is told of an angle in double
/// is right to that only, and a verdict with a margin below it proves nothing. A case with a number
/// that is not finite, or without a radius above 0, stays.
Case opened(const Case& question, Convention::Opening opening, const Format& format);

/// Is its direction the way between two points of the format?
bool is_between_points(const Ray<double>& ray, const Format& format);

/// The same, and its range from 0 to 1?
bool is_segment(const Ray<double>& ray, const Format& format);

/// The ray from the point of t_min to that of t_max, rounded: the difference is exact, for which
/// points are rounded further where they lie too far apart. Where the range goes on for long, it
/// ends beyond the shape, a power of two of directions away, so far that rounding hardly turns it.
/// A segment stays, and so does a case with a number that is not finite or without a direction.
Case cut(const Case& question, const Format& format);

}  // namespace rayaudit::posing
