#include "audit/along.hpp"

#include "oracle/truth.hpp"

namespace rayaudit {

std::vector<Along> along(const Case& question) {
  const oracle::Truth truth = oracle::truth(question);
  if (truth.invalid != oracle::Invalid::no) return {};
  std::vector<Along> all;
  for (const oracle::Crossing& crossing : truth.crossings())
    all.push_back({nearest<double>(crossing.t), nearest<double>(crossing.t_last),
                   oracle::name(crossing.kind)});
  const oracle::Roots roots = oracle::roots(question);
  for (const oracle::Root& root : roots.roots())
    if (root.standing != oracle::Standing::acceptable)
      all.push_back(
          {nearest<double>(root.t), nearest<double>(root.t), oracle::name(root.standing)});
  return all;
}

}  // namespace rayaudit
