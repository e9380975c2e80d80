#pragma once

#include <boost/test/unit_test.hpp>

#include "tests/oracle/second_derivation/held.hpp"

/// Cases whose crossings are plain from a drawing, to hold the derivations themselves against.
namespace rayaudit::second {

struct Known {
  oracle::Kind kind;
  Rational t;
  Rational t_last = t;
};

struct Proved {
  std::string line;
  std::vector<Known> crossings;
};

inline std::vector<Proved> proved() {
  using enum oracle::Kind;
  const std::string disk = "disk 0 0 0 0 0 2 1 ray ";
  const std::string sphere = "sphere 0 0 0 1 ray ";
  const std::string cylinder = "cylinder 0 0 0 0 2 0 1 ray ";
  const std::string slanted = "cylinder 0 0 0 2 2 1 3 ray ";
  const std::string cone = "cone 0 0 0 0 2 0 1 ray ";
  const std::string can = "capped_cylinder 0 0 0 0 2 0 1 ray ";
  const std::string tent = "capped_cone 0 0 0 0 2 0 1 ray ";
  const Rational half(1, 2), third(1, 3);
  return {
      {disk + "0.5 0 3 0 0 -2", {{proper, 3 * half}}},
      {disk + "1 0 3 0 0 -1", {{rim, 3}}},
      {disk + "0x1.0000000000001p+0 0 3 0 0 -1", {}},
      {"disk 0 0 0 0 0 1 5 ray 3 4 1 0 0 -1", {{rim, 1}}},
      {disk + "0 0 1 1 0 0", {}},
      {disk + "-3 0 0 1 0 0", {{within, 2, 4}}},
      {disk + "0 0 0 1 0 0", {{within, 0, 1}}},
      {disk + "-3 0 0 1 0 0 range 0 3", {{within, 2, 3}}},
      {disk + "-3 1 0 1 0 0", {{within, 3}}},
      {disk + "-3 2 0 1 0 0", {}},
      {disk + "1 0 0 1 0 0", {{within, 0}}},
      {disk + "0 0 0 0 0 1", {{start, 0}}},
      {disk + "0 0 3 0 0 -1 range 0 3", {{end, 3}}},
      {sphere + "-3 0 0 2 0 0", {{proper, 1}}},
      {sphere + "0 0 0 0 0 3", {{proper, third}}},
      {sphere + "3 0 0 1 0 0", {}},
      {sphere + "-3 1 0 1 0 0", {{tangent, 3}}},
      {sphere + "-3 0x1.0000000000001p+0 0 1 0 0", {}},
      {sphere + "-1 0 0 1 0 0", {{start, 0}, {proper, 2}}},
      {sphere + "0 1 0 1 0 0", {{start, 0}}},
      {sphere + "-3 0 0 1 0 0 range 2 4", {{start, 2}, {end, 4}}},
      {sphere + "0 0 0 1 0 0 range -inf inf", {{proper, -1}}},
      {"sphere 0 0 0 0x1p-1074 ray 0x1p-1072 0 0 -1 0 0", {{proper, 3 * power_of_two(-1074)}}},
      {cylinder + "-3 1 0 1 0 0", {{proper, 2}}},
      {cylinder + "-3 1 1 1 0 0", {{tangent, 3}}},
      {cylinder + "-3 2 0 1 0 0", {{rim, 2}, {rim, 4}}},
      {cylinder + "-3 0 1 1 0 0", {{rim, 3}}},
      {cylinder + "-2 2.5 0 1 -0.5 0", {{rim, 1}, {proper, 3}}},
      {cylinder + "0 3 0 1 -2 0", {{proper, 1}}},
      {cylinder + "0 -1 0 0 1 0", {}},
      {cylinder + "1 -1 0 0 1 0", {{within, 1, 3}}},
      {cylinder + "1 3 0 0 -1 0 range -inf 2", {{within, 1, 2}}},
      {cylinder + "1 3 0 0 1 0", {}},
      {slanted + "-2 1 6.5 2 -1 -2", {{tangent, 2}}},
      {slanted + "4 -5 6.5 -1 2 -2", {{proper, 2}}},
      {cone + "-3 1 0 1 0 0", {{proper, 5 * half}}},
      {cone + "-3 1 0.5 1 0 0", {{tangent, 3}}},
      {cone + "-3 0 0 1 0 0", {{rim, 2}, {rim, 4}}},
      {cone + "-3 2 0 1 0 0", {{apex, 3}}},
      {cone + "-3 3 0 1 0 0", {}},
      {cone + "0 3 0 0 -1 0", {{proper, 1}}},
      {cone + "-0.25 3 0 0.25 -1 0", {{proper, 1}}},
      {cone + "0 2 0 0 -1 0", {{start, 0}}},
      {cone + "0 1 0 0 -1 0", {}},
      {cone + "0 0 0 -1 2 0", {{proper, half}}},
      {cone + "2 -2 0 -1 2 0", {{within, 1, 2}}},
      {cone + "-2 -2 0 1 2 0 range 0 1.5", {{within, 1, 3 * half}}},
      {can + "-3 1 0 1 0 0", {{proper, 2}}},
      {can + "0 1 0 0 1 0", {{proper, 1}}},
      {can + "0 3 0 1 -2 0", {{proper, half}}},
      {can + "-3 1 1 1 0 0", {{tangent, 3}}},
      {can + "-3 2 0 1 0 0", {{within, 2, 4}}},
      {can + "-3 0 1 1 0 0", {{within, 3}}},
      {can + "-3 0 1 1 1 0", {}},
      {can + "-3 -1 1 1 1 0", {{rim, 3}}},
      {can + "-2 3 0 1 -1 0", {{proper, 1}}},
      {can + "-2 1 0 1 1 0", {{rim, 1}}},
      {can + "0 3 0 0 -1 0 range 1 3", {{start, 1}, {end, 3}}},
      {can + "1 -1 0 0 1 0", {{within, 1, 3}}},
      {can + "2 -1 0 0 1 0", {}},
      {tent + "-3 1 0 1 0 0", {{proper, 5 * half}}},
      {tent + "0 1 0 0 -2 0", {{proper, half}}},
      {tent + "0 3 0 0 -1 0", {{proper, 1}}},
      {tent + "0 1 0 0 1 0", {{proper, 1}}},
      {tent + "-3 2 0 1 0 0", {{apex, 3}}},
      {tent + "-3 0 0 1 0 0", {{within, 2, 4}}},
      {tent + "2 -2 0 -1 2 0", {{within, 1, 2}}},
      {tent + "-2 1 0 1 -1 0", {{rim, 1}}},
      {tent + "-2 -1 0 1 1 0", {{proper, 1}}},
  };
}

/// Holds a derivation, and the oracle, against the proved cases of a shape.
inline void hold_proved(std::size_t shape, Derivation derive) {
  for (const Proved& one : proved()) {
    const Case question = read_case_line(one.line).question;
    if (question.shape.index() != shape) continue;
    const Crossings derived = derive(question);
    bool right = derived.size() == one.crossings.size();
    for (std::size_t i = 0; right && i < derived.size(); ++i) {
      const Known& known = one.crossings[i];
      right = derived[i].kind == known.kind && derived[i].t(known.t) == 0 &&
              derived[i].t_last(known.t_last) == 0;
    }
    BOOST_TEST(right, one.line << "\n  derived " << words(derived));
    const oracle::Truth truth = oracle::truth(question);
    BOOST_TEST(agree(truth, derived), one.line << "\n  oracle " << words(truth));
  }
}

}  // namespace rayaudit::second
