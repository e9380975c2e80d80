#include "cli/renderers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/exit_code.hpp"
#include "geometry/error.hpp"
#include "geometry/glob.hpp"
#include "reports/declared.hpp"

namespace rayaudit {
namespace {

constexpr std::string_view usual_subject = "textbook/float", usual_offset = "t_min=1e-4";

/// A name or glob, or nothing, and the offset that stands after it.
struct Wish {
  std::string pattern;
  Offset offset;
};

Wish read_wish(const std::string& text) {
  const std::size_t at = text.rfind('@');
  if (at == text.npos) return {text, read_offset(usual_offset)};
  return {text.substr(0, at), read_offset(std::string_view(text).substr(at + 1))};
}

std::vector<Wish> read_wishes(const SubjectChoice& choice) {
  std::vector<Wish> wishes;
  wishes.reserve(choice.names.size() + 1);
  for (const std::string& text : choice.names) wishes.push_back(read_wish(text));
  if (wishes.empty()) wishes.push_back({"", read_offset(usual_offset)});
  return wishes;
}

bool is_brought(const Subject& subject) { return !subject.brought_by.empty(); }

/// The subjects that a wish itself names, whatever else is brought along.
std::vector<const Subject*> chosen(const Wish& wish, SubjectChoice choice,
                                   const Subjects& subjects) {
  choice.names.clear();
  if (!wish.pattern.empty()) {
    choice.names = {wish.pattern};
  } else if (!choice.brings_any()) {
    choice.names = {std::string(usual_subject)};
  }
  std::vector<const Subject*> found = subjects.selected(choice);
  if (!wish.pattern.empty())
    found.erase(std::remove_if(found.begin(), found.end(),
                               [&](const Subject* each) {
                                 return is_brought(*each) && !matches(wish.pattern, each->name);
                               }),
                found.end());
  return found;
}

/// The first thing in a scene of a shape that a subject does not answer, or null.
const Primitive* unanswered(const Subject& subject, const Scene& scene) {
  const auto found =
      std::find_if(scene.primitives.begin(), scene.primitives.end(),
                   [&](const Primitive& each) { return !subject.answers(each.shape.index()); });
  return found == scene.primitives.end() ? nullptr : &*found;
}

/// Is a subject asked shapes and rays as a scene has them?
bool takes_scenes(const Convention& convention) {
  return convention.stand == Convention::Stand::anywhere && convention.extent == Extent::bounded &&
         !convention.segment && !convention.line;
}

/// Adds a wish's renderers that are not there yet and answer the scene's shapes.
void add(const Wish& wish, const std::vector<const Subject*>& subjects, const Scene& scene,
         std::vector<Renderer>& all) {
  for (const Subject* subject : subjects) {
    if (const Primitive* what = unanswered(*subject, scene)) {
      if (is_glob(wish.pattern)) continue;
      throw Error(fmt::format("subject `{}` does not answer the {} at {}", subject->name,
                              shape_names[what->shape.index()], told(what->place)));
    }
    if (!takes_scenes(subject->convention)) {
      if (is_glob(wish.pattern)) continue;
      throw Error(fmt::format("subject `{}` takes no scenes: it declares {}", subject->name,
                              declared(subject->convention)));
    }
    const Renderer renderer = {subject, wish.offset};
    if (std::none_of(all.begin(), all.end(),
                     [&](const Renderer& each) { return each.name() == renderer.name(); }))
      all.push_back(renderer);
  }
}

}  // namespace

std::string Renderer::name() const { return subject->name + "@" + offset.name; }

std::string Renderer::file_name() const {
  std::string text = subject->name + "-" + offset.name;
  std::replace(text.begin(), text.end(), '/', '-');
  return text;
}

std::vector<Renderer> renderers(const SubjectChoice& choice, const Subjects& subjects,
                                const Scene& scene) {
  std::vector<Renderer> all;
  bool is_any_brought = false;
  for (const Wish& wish : read_wishes(choice)) {
    const std::vector<const Subject*> found = chosen(wish, choice, subjects);
    for (const Subject* subject : found) is_any_brought |= is_brought(*subject);
    add(wish, found, scene, all);
  }
  if (choice.brings_any() && !is_any_brought) {
    const Wish brought = {"", read_offset(usual_offset)};
    add(brought, chosen(brought, choice, subjects), scene, all);
  }
  if (all.empty())
    throw NothingAudited("nothing to trace: no chosen subject answers every shape of the scene");
  return all;
}

}  // namespace rayaudit
