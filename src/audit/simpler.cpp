#include "audit/simpler.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace rayaudit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest_small = 8;

/// The numbers of a case by what they are.
struct Numbers {
  std::vector<Vec3<double>*> points, vectors;  ///< the ray's own first
  std::vector<double*> lengths;

  explicit Numbers(Case& question)
      : points{&question.ray.origin}, vectors{&question.ray.direction} {
    std::visit(
        [&]<class S>(S& shape) {
          std::size_t i = 0;
          const auto add = [&](auto& part) {
            if constexpr (requires { part.x; })
              (S::kinds[i] == Part::point ? points : vectors).push_back(&part);
            else
              lengths.push_back(&part);
            ++i;
          };
          std::apply([&](auto&... part) { (add(part), ...); }, shape.parts());
        },
        question.shape);
  }
};

constexpr std::array components = {&Vec3<double>::x, &Vec3<double>::y, &Vec3<double>::z};
using Component = double Vec3<double>::*;

bool is_number(double x) { return std::isfinite(x) && x != 0; }

int significant_bits(double x) {
  if (!is_number(x)) return 0;
  int exponent = 0;
  const auto whole =
      static_cast<std::uint64_t>(std::ldexp(std::frexp(std::fabs(x), &exponent), 53));
  return 53 - std::countr_zero(whole);
}

bool is_small_whole(double x) { return std::fabs(x) <= largest_small && std::trunc(x) == x; }

using Round = double (*)(double);

/// x to so many significant bits, by a rounding to whole numbers.
double to_bits(double x, int bits, Round round) {
  if (!is_number(x)) return x;
  const int unit = std::ilogb(x) - bits + 1;
  return std::ldexp(round(std::ldexp(x, -unit)), unit);
}

bool fits(const Case& question, const Format& format) {
  bool all = true;
  const auto see = [&](double x) {
    all = all && (format != float_format || std::isnan(x) ||
                  static_cast<double>(static_cast<float>(x)) == x);
  };
  each_number(question, see);
  see(question.ray.t_min), see(question.ray.t_max);
  return all;
}

/// All steps away from one case.
class Steps {
 public:
  Steps(const Case& question, const Format& format)
      : question_(question), format_(format), least_(simplicity(question)) {}

  /// change(made, its numbers) tells whether it could be done exactly, where that is wanted.
  template <class Change>
  void add(const Change& change) {
    Case made = question_;
    Numbers numbers(made);
    if (!change(made, numbers) || !fits(made, format_)) return;
    if (const Simplicity is = simplicity(made); is < least_) all_.push_back({is, made});
  }

  void change_range();
  void change_number(double x, const auto& place);
  void change_numbers();
  void change_vectors();
  void change_axes();
  void move();
  void scale_all();
  void scale_vectors();
  void round_all();
  std::vector<Case> sorted();

 private:
  struct Step {
    Simplicity is;
    Case made;
  };
  const Case& question_;
  const Format& format_;
  Simplicity least_;
  std::vector<Step> all_;
};

void Steps::change_range() {
  const auto to_default = [this](bool start, bool end) {
    add([=](Case& made, Numbers&) {
      if (start) made.ray.t_min = 0;
      if (end) made.ray.t_max = infinity;
      return true;
    });
  };
  to_default(true, true), to_default(true, false), to_default(false, true);
  change_number(question_.ray.t_min, [](Case& c, Numbers&) -> double& { return c.ray.t_min; });
  change_number(question_.ray.t_max, [](Case& c, Numbers&) -> double& { return c.ray.t_max; });
}

/// All that may be done to one number x, which place(case, its numbers) leads to.
void Steps::change_number(double x, const auto& place) {
  if (!std::isfinite(x)) return;
  const auto become = [&](double y) {
    add([&](Case& made, Numbers& numbers) {
      place(made, numbers) = y;
      return true;
    });
  };
  become(0);
  if (x == 0) return;
  become(std::copysign(1, x)), become(std::fabs(x));
  for (const Round round : std::array<Round, 3>{std::nearbyint, std::floor, std::ceil})
    become(round(x));
  const int bits = significant_bits(x), exponent = std::ilogb(x);
  for (const int fewer : {1, 2, 3, 4, 6, 8, 12, 16, 20, 24, 32, 40, bits - 1})
    for (const Round round : std::array<Round, 2>{std::floor, std::ceil})
      if (fewer < bits) become(to_bits(x, fewer, round));
  for (const double few : {2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 0.5, 0.25, 0.75, 1.5, 2.5})
    become(std::copysign(few, x));
  // Any way from where it is to 0, and one step beyond: few rounds find how far it can go.
  for (int way = exponent; way != 0; way /= 2) become(std::ldexp(x, -way));
  become(std::ldexp(x, exponent < 0 ? -1 : 1));
}

void Steps::change_numbers() {
  const auto each_vector = [this](auto Numbers::*list) {
    Case copy = question_;
    const Numbers numbers(copy);
    for (std::size_t i = 0; i < (numbers.*list).size(); ++i)
      for (const Component component : components)
        change_number((numbers.*list)[i]->*component,
                      [=](Case&, Numbers& of) -> double& { return (of.*list)[i]->*component; });
  };
  each_vector(&Numbers::points), each_vector(&Numbers::vectors);
  Case copy = question_;
  change_number(*Numbers(copy).lengths[0],
                [](Case&, Numbers& of) -> double& { return *of.lengths[0]; });
}

/// Points to the world origin; vectors, and axes, along one coordinate axis.
void Steps::change_vectors() {
  const auto along = [](const Vec3<double>& v, Component kept, double size) {
    Vec3<double> made = {0, 0, 0};
    made.*kept = std::copysign(size, v.*kept);
    return made;
  };
  const auto straighten = [&](const auto& which, const auto& from) {
    for (const Component kept : components)
      for (const bool unit : {true, false})
        add([&](Case&, Numbers& of) {
          const Vec3<double> start = from(of), v = which(of) - start;
          which(of) = start + along(v, kept, unit ? 1 : std::fabs(v.*kept));
          return true;
        });
  };
  const auto zero = [](Numbers&) { return Vec3<double>{0, 0, 0}; };
  Case copy = question_;
  const Numbers numbers(copy);
  for (std::size_t i = 0; i < numbers.vectors.size(); ++i)
    straighten([=](Numbers& of) -> Vec3<double>& { return *of.vectors[i]; }, zero);
  for (std::size_t i = 0; i < numbers.points.size(); ++i) {
    straighten([=](Numbers& of) -> Vec3<double>& { return *of.points[i]; }, zero);
    add([=](Case&, Numbers& of) {
      *of.points[i] = {0, 0, 0};
      return true;
    });
  }
  if (numbers.points.size() < 3) return;
  straighten([](Numbers& of) -> Vec3<double>& { return *of.points[2]; },
             [](Numbers& of) { return *of.points[1]; });
  for (const Component same : components)
    add([=](Case&, Numbers& of) {
      of.points[2]->*same = of.points[1]->*same;
      return true;
    });
}

/// All of a case at once, one coordinate axis after the other: flat in it, mirrored.
void Steps::change_axes() {
  for (const Component axis : components) {
    const auto change = [&](const auto& become) {
      add([&](Case&, Numbers& of) {
        for (auto* list : {&of.points, &of.vectors})
          for (Vec3<double>* each : *list) each->*axis = become(each->*axis);
        return true;
      });
    };
    change([](double) { return 0; });
    change([](double x) { return x == 0 ? 0 : -x; });
    add([&](Case&, Numbers& of) {
      for (Vec3<double>* each : of.points) each->*axis = 0;
      return true;
    });
    add([&](Case&, Numbers& of) {
      of.points[0]->*axis = of.vectors[0]->*axis = 0;
      return true;
    });
  }
}

/// Exactly, so that one of its points comes to the world origin, in all coordinates or one.
void Steps::move() {
  const auto shift = [](Numbers& of, std::size_t origin, Component axis) {
    const double by = of.points[origin]->*axis;
    return std::all_of(of.points.begin(), of.points.end(), [&](Vec3<double>* each) {
      const double was = each->*axis;
      each->*axis -= by;
      return each->*axis + by == was && was - each->*axis == by;
    });
  };
  Case copy = question_;
  for (std::size_t i = 0; i < Numbers(copy).points.size(); ++i) {
    add([&](Case&, Numbers& of) {
      return shift(of, i, components[0]) && shift(of, i, components[1]) &&
             shift(of, i, components[2]);
    });
    for (const Component axis : components)
      add([&](Case&, Numbers& of) { return shift(of, i, axis); });
  }
}

int exponent_of(const Vec3<double>& v) {
  const double size = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  return is_number(size) ? std::ilogb(size) : 0;
}

void scale(Vec3<double>& v, int e) {
  v = {std::ldexp(v.x, e), std::ldexp(v.y, e), std::ldexp(v.z, e)};
}

void scale_range(Ray<double>& ray, int e) {
  for (double* t : {&ray.t_min, &ray.t_max}) *t = std::ldexp(*t, e);
}

void scale_world(Numbers& of, int e) {
  for (Vec3<double>* each : of.points) scale(*each, e);
  *of.lengths[0] = std::ldexp(*of.lengths[0], e);
}

/// By powers of two, the world: with the direction of its ray, or with what t counts.
void Steps::scale_all() {
  const auto with_direction = [this](int e) {
    add([=](Case&, Numbers& of) {
      scale_world(of, e);
      scale(*of.vectors[0], e);
      return true;
    });
  };
  Case copy = question_;
  const double radius = *Numbers(copy).lengths[0];
  if (is_number(radius)) {
    const int to_one = -std::ilogb(radius);
    with_direction(to_one);
    add([=](Case& made, Numbers& of) {
      scale_world(of, to_one);
      scale_range(made.ray, to_one);
      return true;
    });
  }
  for (const int e : {1, -1}) with_direction(e);
}

/// By powers of two, the vectors.
void Steps::scale_vectors() {
  for (const int e : {-exponent_of(question_.ray.direction), 1, -1})
    add([=](Case& made, Numbers&) {
      scale(made.ray.direction, e);
      scale_range(made.ray, -e);
      return true;
    });
  Case copy = question_;
  const Numbers numbers(copy);
  if (numbers.vectors.size() < 2) return;
  for (const int e : {-exponent_of(*numbers.vectors[1]), 1, -1})
    add([=](Case&, Numbers& of) {
      scale(*of.vectors[1], e);
      return true;
    });
}

/// Numbers to few bits, or to whole numbers: every one, those of points or vectors, of one of them
/// or of one coordinate axis.
void Steps::round_all() {
  const auto round = [this](const auto& become) {
    const auto change = [&](double& x) { x = become(x); };
    const auto all = [&](Vec3<double>* v) { change(v->x), change(v->y), change(v->z); };
    for (const bool points : {true, false})
      for (const bool vectors : {true, false})
        add([&](Case&, Numbers& of) {
          if (points) std::for_each(of.points.begin(), of.points.end(), all);
          if (points) change(*of.lengths[0]);
          if (vectors) std::for_each(of.vectors.begin(), of.vectors.end(), all);
          return true;
        });
    Case copy = question_;
    for (auto list : {&Numbers::points, &Numbers::vectors})
      for (std::size_t i = 0; i < (Numbers(copy).*list).size(); ++i)
        add([&](Case&, Numbers& of) {
          all((of.*list)[i]);
          return true;
        });
    for (const Component axis : components)
      add([&](Case&, Numbers& of) {
        for (auto* list : {&of.points, &of.vectors})
          for (Vec3<double>* each : *list) change(each->*axis);
        return true;
      });
  };
  round([](double x) { return std::nearbyint(x); });
  for (const int bits : {1, 2, 3, 4, 6, 8, 12, 16, 20, 24, 32, 40})
    round([&](double x) { return to_bits(x, bits, std::nearbyint); });
}

std::vector<Case> Steps::sorted() {
  std::stable_sort(all_.begin(), all_.end(),
                   [](const Step& a, const Step& b) { return a.is < b.is; });
  std::vector<Case> cases;
  for (auto alike = all_.begin(); alike != all_.end();) {  // the first of those as simple
    const std::size_t before = cases.size();
    const Simplicity is = alike->is;
    for (; alike != all_.end() && alike->is == is; ++alike)
      if (std::find(cases.begin() + before, cases.end(), alike->made) == cases.end())
        cases.push_back(alike->made);
  }
  return cases;
}

}  // namespace

Simplicity simplicity(const Case& question) {
  Simplicity is;
  const auto count = [&](double x, double simple) {
    is.apart += x != simple;
    is.large += !is_small_whole(x) && x != simple;
    is.bits += significant_bits(x);
    is.size += is_number(x) ? std::abs(std::ilogb(x)) : 0;
    is.signs += std::signbit(x);
  };
  Case copy = question;
  const Numbers numbers(copy);
  for (const auto* list : {&numbers.points, &numbers.vectors})
    for (const Vec3<double>* each : *list) count(each->x, 0), count(each->y, 0), count(each->z, 0);
  for (const double* each : numbers.lengths) count(*each, 1);
  count(question.ray.t_min, 0), count(question.ray.t_max, infinity);
  if (numbers.points.size() > 2)
    for (const Component component : components)
      is.apart += numbers.points[1]->*component != numbers.points[2]->*component;
  return is;
}

std::vector<Case> simpler(const Case& question, const Format& format) {
  Steps steps(question, format);
  steps.change_range();
  steps.change_numbers();
  steps.change_vectors();
  steps.change_axes();
  steps.move();
  steps.scale_all();
  steps.scale_vectors();
  steps.round_all();
  return steps.sorted();
}

}  // namespace rayaudit
