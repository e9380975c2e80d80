#include <functional>
#include <random>

#include "oracle/truth.hpp"
#include "tests/families/drawn.hpp"
#include "tests/oracle/closed.hpp"
#include "tests/oracle/dyadic.hpp"

using namespace rayaudit;
using oracle::Truth;

namespace {

constexpr std::size_t count = 500 / one_in;  ///< cases of every family, shape and format

/// A case that must have the same truth, every t multiplied by a power of two.
struct Image {
  Case question;
  int t_exponent = 0;
};
/// Nothing where the numbers of the case do not allow it.
using Images = std::vector<Image>;

bool follows(const Real& t, const Real& image, int t_exponent) {
  // Both are within 2^-63 of what they stand for.
  const Dyadic moved = times_power(exactly(t), t_exponent);
  return agree(exactly(image), moved, 62);
}

bool follows(const Truth& truth, const Image& image) {
  const Truth seen = oracle::truth(image.question);
  if (seen.invalid != oracle::Invalid::no || seen.count != truth.count) return false;
  for (int i = 0; i < truth.count; ++i) {
    const auto &is = truth.listed[i], &will_be = seen.listed[i];
    if (is.kind != will_be.kind || !follows(is.t, will_be.t, image.t_exponent) ||
        !follows(is.t_last, will_be.t_last, image.t_exponent))
      return false;
  }
  return true;
}

/// Requires truth to follow every image that transformed(question, engine) has, on every family and
/// shape; at least a share of all cases must have one.
template <class T>
void require_followed(double least_share, T&& transformed,
                      const std::function<bool(const Family&, std::size_t)>& applies = {}) {
  std::mt19937_64 engine(23);
  std::size_t asked = 0, imaged = 0;
  each_drawing([&](const Family& family, std::size_t shape, const Format& format) {
    if (family.id == "invalid" || (applies && !applies(family, shape))) return;
    require_each(family, shape, format, closed_too(drawn(family, shape, format, {}, 5, count)),
                 [&](const Case& question) {
                   const Truth truth = oracle::truth(question);
                   const Images images = transformed(question, engine);
                   ++asked;
                   imaged += images.empty() ? 0 : 1;
                   return std::all_of(images.begin(), images.end(),
                                      [&](const Image& image) { return follows(truth, image); });
                 });
  });
  const double part = static_cast<double>(imaged) / static_cast<double>(asked);
  BOOST_TEST(part >= least_share, "only " << part << " of the cases were transformed");
}

int between(std::mt19937_64& engine, int least, int most) {
  return least + static_cast<int>(engine() % static_cast<unsigned>(most - least + 1));
}

/// One of the 48 ways to permute the axes and turn some of them round.
struct Symmetry {
  int order, mirrors;

  void operator()(Vec3<double>& v) const {
    constexpr std::array<std::array<int, 3>, 6> orders = {
        {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
    const std::array<double, 3> old = {v.x, v.y, v.z};
    const auto at = [&](int i) {
      const double x = old[orders[order][i]];
      return (mirrors >> i & 1) != 0 ? -x : x;
    };
    v = {at(0), at(1), at(2)};
  }
  void operator()(double&) const {}
};

/// Calls visit(kind, part) for the origin and every parameter of the shape.
template <class V>
void each_placed(Case& question, V&& visit) {
  visit(Part::point, question.ray.origin);
  std::visit(
      [&](auto& shape) {
        std::apply(
            [&](auto&... part) {
              std::size_t i = 0;
              (visit(shape.kinds[i++], part), ...);
            },
            shape.parts());
      },
      question.shape);
}

/// Multiplies by powers of two, and notes where that is not exact.
struct Scaling {
  bool exact = true;

  void operator()(double& x, int e) {
    const double before = x;
    x = std::ldexp(x, e);
    exact = exact && (std::isinf(before) || std::ldexp(x, -e) == before);
  }
  void operator()(Vec3<double>& v, int e) { (*this)(v.x, e), (*this)(v.y, e), (*this)(v.z, e); }
};

/// The case with all lengths, the direction and a normal multiplied by powers of two.
Images scaled(Case question, int lengths, int direction, int normal) {
  Scaling scale;
  each_placed(question,
              [&](Part kind, auto& part) { scale(part, kind == Part::vector ? normal : lengths); });
  scale(question.ray.direction, direction);
  scale(question.ray.t_min, lengths - direction);
  scale(question.ray.t_max, lengths - direction);
  if (!scale.exact) return {};
  return {{question, lengths - direction}};
}

/// An exponent of every size: mostly small, often far out.
int exponent(std::mt19937_64& engine) {
  const int most = between(engine, 0, 1) == 0 ? 10 : 300;
  return between(engine, -most, most);
}

}  // namespace

BOOST_AUTO_TEST_CASE(truth_follows_axes_that_are_permuted_and_mirrored) {
  std::array<bool, 48> seen = {};
  int next = 0;
  require_followed(1, [&](const Case& question, std::mt19937_64&) {
    Images images;
    for (int i = 0; i < 5; ++i, next = (next + 1) % 48) {
      const Symmetry symmetry = {next / 8, next % 8};
      seen[next] = true;
      Case turned = question;
      each_placed(turned, [&](Part, auto& part) { symmetry(part); });
      symmetry(turned.ray.direction);
      images.push_back({turned});
    }
    return images;
  });
  BOOST_TEST(std::count(seen.begin(), seen.end(), true) == 48);
}

BOOST_AUTO_TEST_CASE(truth_stays_where_lengths_and_direction_grow_alike) {
  require_followed(0.9, [](const Case& question, std::mt19937_64& engine) {
    const int e = exponent(engine);
    return scaled(question, e, e, 0);
  });
}

BOOST_AUTO_TEST_CASE(t_grows_with_the_lengths) {
  require_followed(0.9, [](const Case& question, std::mt19937_64& engine) {
    return scaled(question, exponent(engine), 0, 0);
  });
}

BOOST_AUTO_TEST_CASE(t_shrinks_as_the_direction_grows) {
  require_followed(0.9, [](const Case& question, std::mt19937_64& engine) {
    return scaled(question, 0, exponent(engine), 0);
  });
}

BOOST_AUTO_TEST_CASE(t_grows_with_lengths_and_direction_apart) {
  require_followed(0.9, [](const Case& question, std::mt19937_64& engine) {
    const int lengths = exponent(engine);
    return scaled(question, lengths, exponent(engine), 0);
  });
}

BOOST_AUTO_TEST_CASE(the_length_and_the_side_of_a_normal_are_of_no_account) {
  const auto is_disk = [](const Family&, std::size_t shape) { return shape == 0; };
  require_followed(
      0.9,
      [](const Case& question, std::mt19937_64& engine) {
        Images images = scaled(question, 0, 0, exponent(engine));
        for (int i = static_cast<int>(images.size()); i-- > 0;) {
          Case turned = images[i].question;
          auto& normal = std::get<Disk<double>>(turned.shape).normal;
          normal = -normal;
          images.push_back({turned});
        }
        return images;
      },
      is_disk);
}

BOOST_AUTO_TEST_CASE(the_ends_of_a_cylinder_are_alike) {
  const auto is_cylinder = [](const Family&, std::size_t shape) { return shape == 2; };
  require_followed(
      1,
      [](Case question, std::mt19937_64&) {
        const auto swap_ends = [](auto& cylinder) { std::swap(cylinder.base, cylinder.top); };
        if (auto* open = std::get_if<Cylinder<double>>(&question.shape))
          swap_ends(*open);
        else
          swap_ends(std::get<CappedCylinder<double>>(question.shape));
        return Images{{question}};
      },
      is_cylinder);
}

namespace {

/// Moves points, and notes where that is not exact.
struct Move {
  Vec3<double> by;
  bool exact = true;

  double moved(double x, double step) {
    const double sum = x + step;
    exact = exact && (Dyadic(sum) - Dyadic(x) - Dyadic(step)).sign() == 0;
    return sum;
  }
  void operator()(Part kind, Vec3<double>& p) {
    if (kind == Part::point) p = {moved(p.x, by.x), moved(p.y, by.y), moved(p.z, by.z)};
  }
  void operator()(Part, double&) {}
};

Images moved(Case question, const Vec3<double>& by) {
  Move move{by};
  each_placed(question, move);
  if (!move.exact) return {};
  return {{question}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(truth_stays_where_everything_moves_by_whole_numbers) {
  const auto has_few_bits = [](const Family& family, std::size_t) {
    return family.strength == Strength::degenerate || family.id == "lattice";
  };
  require_followed(
      0.3,
      [](const Case& question, std::mt19937_64& engine) {
        const auto step = [&] { return static_cast<double>(between(engine, -1000, 1000)); };
        const double x = step(), y = step(), z = step();
        return moved(question, {x, y, z});
      },
      has_few_bits);
}

BOOST_AUTO_TEST_CASE(truth_stays_where_the_lattice_moves_far) {
  require_followed(
      1,
      [](const Case& question, std::mt19937_64& engine) {
        const auto step = [&] { return std::ldexp(between(engine, -1000, 1000), 20); };
        const double x = step(), y = step(), z = step();
        return moved(question, {x, y, z});
      },
      [](const Family& family, std::size_t) { return family.id == "lattice"; });
}

BOOST_AUTO_TEST_CASE(t_shrinks_where_the_origin_walks_along_the_ray) {
  require_followed(
      0.9,
      [](const Case& question, std::mt19937_64&) {
        // One step back along the ray: every t is one more.
        Case image = question;
        Move move{-question.ray.direction};
        move(Part::point, image.ray.origin);
        image.ray.t_min = move.moved(image.ray.t_min, 1);
        if (std::isfinite(image.ray.t_max)) image.ray.t_max = move.moved(image.ray.t_max, 1);
        const Truth truth = oracle::truth(question), seen = oracle::truth(image);
        if (!move.exact) return Images{};
        bool same = truth.count == seen.count;
        for (int i = 0; same && i < truth.count; ++i) {
          const Dyadic later = exactly(truth.listed[i].t) + Dyadic(1);
          same = truth.listed[i].kind == seen.listed[i].kind &&
                 size(exactly(seen.listed[i].t) - later) <=
                     times_power(size(later) + Dyadic(1) + size(later - Dyadic(1)), -62);
        }
        if (!same) BOOST_ERROR("one step back: " << case_line(question));
        return Images{{question}};
      },
      [](const Family& family, std::size_t) { return family.id == "lattice"; });
}
