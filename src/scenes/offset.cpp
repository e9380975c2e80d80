#include "scenes/offset.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/error.hpp"
#include "geometry/quotation.hpp"

namespace rayaudit {
namespace {

using Kind = Offset::Kind;

std::optional<double> amount(std::string_view text) {
  double read = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, read);
  if (error != std::errc() || stopped != end || !std::isfinite(read) || read <= 0) return {};
  return read;
}

template <class N>
N largest(const Vec3<N>& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The spacing of numbers from x up to twice that.
template <class N>
N ulp(N x) {
  using Limits = std::numeric_limits<N>;
  if (x < Limits::min()) return Limits::denorm_min();
  return std::ldexp(N(1), std::ilogb(x) - (Limits::digits - 1));
}

template <class N>
N at_least(double x) {
  const N rounded = static_cast<N>(x);
  return rounded < x ? std::nextafter(rounded, std::numeric_limits<N>::infinity()) : rounded;
}

/// The number beside x on the side of w, so that the rounding of x + w takes nothing back.
template <class N>
N further(N x, N w) {
  return w == N(0) ? x : std::nextafter(x, std::copysign(std::numeric_limits<N>::infinity(), w));
}

/// As Pharr, Jakob & Humphreys, "Physically Based Rendering", 3rd ed., sec. 3.9.5; the normal has
/// length 1 but for rounding.
template <class N>
Vec3<N> beyond_proved(const Vec3<N>& point, const Vec3<N>& normal, double proved) {
  const N length = at_least<N>(proved * (1 + 16 * double{std::numeric_limits<N>::epsilon()}));
  const Vec3<N> w = length * normal, p = point + w;
  return {further(p.x, w.x), further(p.y, w.y), further(p.z, w.z)};
}

template <class N>
Ray<double> departing_in(const Departure& departure, const Vec3<double>& direction,
                         const Offset& offset) {
  Ray<N> ray = {in<N>(departure.point), in<N>(direction)};
  const Vec3<N> n = in<N>(departure.normal);
  const Vec3<N> beside = dot(n, ray.direction) < N(0) ? -n : n;
  switch (offset.kind) {
    case Kind::none:
      break;
    case Kind::t_min:
      ray.t_min = static_cast<N>(offset.amount);
      break;
    case Kind::normal:
      ray.origin = ray.origin + static_cast<N>(offset.amount) * ulp(largest(ray.origin)) * beside;
      break;
    case Kind::proved:
      if (std::isfinite(departure.proved))
        ray.origin = beyond_proved(ray.origin, beside, departure.proved);
      break;
  }
  return in<double>(ray);
}

const std::array usual = {Offset{Kind::none, 0, "none"}, Offset{Kind::t_min, 1e-4, "t_min=1e-4"},
                          Offset{Kind::t_min, 1e-3, "t_min=1e-3"},
                          Offset{Kind::normal, 16, "normal=16"}, Offset{Kind::proved, 0, "proved"}};

}  // namespace

Offset read_offset(std::string_view text) {
  if (text == "none") return usual.front();
  if (text == "proved") return usual.back();
  if (text == "normal") return {Kind::normal, 16, "normal=16"};
  for (const auto& [start, kind] : {std::pair{std::string_view("t_min="), Kind::t_min},
                                    std::pair{std::string_view("normal="), Kind::normal}})
    if (text.starts_with(start)) {
      const std::optional<double> read = amount(text.substr(start.size()));
      if (!read)
        throw Error("the offset " + quotation(text) + " must have a number above 0 after its `=`");
      return {kind, *read, std::string(text)};
    }
  throw Error("the offset " + quotation(text) +
              " is not known; there are `none`, `t_min=1e-3`, `normal=16` and `proved`");
}

std::span<const Offset> usual_offsets() { return usual; }

Ray<double> departing(const Departure& departure, const Vec3<double>& direction,
                      const Offset& offset, const Format& format) {
  return format == float_format ? departing_in<float>(departure, direction, offset)
                                : departing_in<double>(departure, direction, offset);
}

}  // namespace rayaudit
