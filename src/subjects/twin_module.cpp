#include <string>
#include <vector>

#include "routines/routines.hpp"
#include "subjects/module.hpp"
#include "subjects/subject_of.hpp"
#include "subjects/twin.hpp"

/// The routines once more, under the flags of the module that this source is compiled into. All of
/// it is templates and inline: what it shared with the program would have the program's flags.
namespace rayaudit {
namespace {

template <class Routine, class N, class S>
void answer(const Case* cases, std::size_t count, Answer* answers) {
  answer_batch<Routine, N, S>({cases, count}, {answers, count});
}

template <class Routine, class N, std::size_t shape>
constexpr ModuleBatch batch_of() {
  if constexpr (takes_shape<Routine, N, shape>)
    return answer<Routine, N, std::variant_alternative_t<shape, Shape>>;
  else
    return nullptr;
}

template <class Routine, class N, std::size_t... shape>
ModuleSubject twin_of(const std::string& name, std::index_sequence<shape...>) {
  return {name.c_str(), format_of<N>.name.data(), {batch_of<Routine, N, shape>()...}};
}

struct Twins {
  std::vector<std::string> names;
  std::vector<ModuleSubject> subjects;
  Module module = {};

  Twins() {
    names.reserve(2 * std::tuple_size_v<Routines>);  // they are pointed at
    each_twin(Routines{}, [this]<class Routine, class N>() {
      names.push_back(twin_name<Routine, N>(RAYAUDIT_TWIN));
      subjects.push_back(
          twin_of<Routine, N>(names.back(), std::make_index_sequence<shape_count>{}));
    });
    module = {module_version, sizeof(Case), sizeof(Answer),
              static_cast<std::uint32_t>(subjects.size()), subjects.data()};
  }
};

}  // namespace
}  // namespace rayaudit

extern "C" [[gnu::visibility("default")]] const rayaudit::Module* rayaudit_module() {
  static const rayaudit::Twins twins;
  return &twins.module;
}
