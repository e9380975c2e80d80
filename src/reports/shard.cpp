#include "reports/shard.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/digest.hpp"
#include "geometry/error.hpp"
#include "geometry/quotation.hpp"
#include "reports/exactly.hpp"

namespace rayaudit {
namespace {

using exactly::Json;
using exactly::read;
using exactly::written;

constexpr std::string_view first_line = "rayaudit shard 1\n";
constexpr std::size_t digest_digits = 16;

constexpr ReportOf<Run> of_shards[] = {
    {"shard", "for `rayaudit merge`: all that the cases of a shard told", write_shard}};

/// What a subject is held to be the same by.
Json told(const Subject& subject) {
  Json shapes = Json::array();
  for (std::size_t shape = 0; shape < shape_count; ++shape)
    if (subject.answers(shape)) shapes.push_back(shape_names[shape]);
  return {{"name", subject.name},
          {"format", subject.format.name},
          {"shapes", shapes},
          {"convention", written(subject.convention)},
          {"brought_by", subject.brought_by},
          {"made_of", subject.made_of}};
}

Json told(const Bound& bound) {
  const auto& [subject, shape, family, limits, proved, place] = bound;
  Json kept = Json::array();
  for (const auto& [quantity, most] : limits)
    kept.push_back({{"quantity", quantity->name}, {"most", written(most)}});
  return {{"subject", subject}, {"shape", shape},   {"family", family},
          {"limits", kept},     {"proved", proved}, {"place", place}};
}

Bound read_bound(const Json& from) {
  Bound bound = {from.at("subject"), from.at("shape"), from.at("family"), {},
                 from.at("proved"),  from.at("place")};
  for (const Json& limit : from.at("limits")) {
    const std::string name = limit.at("quantity");
    for (const Quantity& quantity : quantities())
      if (quantity.name == name)
        read(limit.at("most"), bound.limits.emplace_back(Limit{&quantity, 0}).most);
  }
  return bound;
}

template <class List>
Json list(const List& of) {
  Json all = Json::array();
  for (const auto& each : of) all.push_back(told(each));
  return all;
}

/// All of a plan that its shards have in common; a member that it gains does not compile here
/// until it is told.
Json settings(const Plan& plan, const std::string& version) {
  const auto& [subjects, families, shapes, cases, seed, difficulty, convention, bounds, thorough,
               drawn_in, causes, beside_textbook, threads, replay_of, shard, shards] = plan;
  Json of_subjects = Json::array(), of_families = Json::array(), of_shapes = Json::array();
  for (const Subject* subject : subjects) of_subjects.push_back(told(*subject));
  for (const Family* family : families) of_families.push_back(family->id);
  for (const std::size_t shape : shapes) of_shapes.push_back(shape_names[shape]);
  return {{"version", version},
          {"seed", seed},
          {"cases", cases},
          {"difficulty", written(difficulty)},
          {"shards", shards},
          {"thorough", thorough},
          {"causes", causes},
          {"beside_textbook", beside_textbook},
          {"drawn_in", drawn_in ? Json(drawn_in->name) : Json(nullptr)},
          {"subjects", of_subjects},
          {"families", of_families},
          {"shapes", of_shapes},
          {"convention", written(convention)},
          {"bounds", list(bounds)}};
}

template <class List, class Name>
std::size_t place_in(const List& all, const std::string& wanted, const Name& name_of) {
  const auto found = std::find_if(std::begin(all), std::end(all),
                                  [&](const auto& each) { return name_of(each) == wanted; });
  if (found == std::end(all)) throw Error("`" + wanted + "` is not known to this program");
  return static_cast<std::size_t>(found - std::begin(all));
}

const Subject* read_subject(const Json& from, const SubjectNamed& subject_named) {
  const std::string brought_by = from.at("brought_by");
  const std::string subject_name = from.at("name");
  const Subject* subject = subject_named(subject_name);
  if (subject == nullptr && !brought_by.empty())
    throw Error(
        fmt::format("subject `{}` is not here: it was brought by {}, which is to be given again",
                    subject_name, brought_by));
  if (subject == nullptr) throw Error(fmt::format("there is no subject `{}`", subject_name));
  Json here = told(*subject);
  here["brought_by"] = brought_by;  // from wherever
  if (here != from)
    throw Error(fmt::format(
        "subject `{}` is not what it was: format, shapes, conventions or what it is made of differ",
        subject_name));
  return subject;
}

Plan read_plan(const Json& from, const SubjectNamed& subject_named) {
  Plan plan;
  for (const Json& each : from.at("subjects"))
    plan.subjects.push_back(read_subject(each, subject_named));
  for (const std::string id : from.at("families"))
    plan.families.push_back(
        &families()[place_in(families(), id, [](const Family& each) { return each.id; })]);
  for (const std::string name : from.at("shapes"))
    plan.shapes.push_back(place_in(shape_names, name, [](std::string_view each) { return each; }));
  plan.cases = from.at("cases");
  plan.seed = from.at("seed");
  read(from.at("difficulty"), plan.difficulty);
  read(from.at("convention"), plan.convention);
  for (const Json& each : from.at("bounds")) plan.bounds.push_back(read_bound(each));
  plan.thorough = from.at("thorough");
  plan.causes = from.at("causes");
  plan.beside_textbook = from.at("beside_textbook");
  constexpr std::array formats = {float_format, double_format};
  if (const Json& format = from.at("drawn_in"); !format.is_null())
    plan.drawn_in =
        formats[place_in(formats, format, [](const Format& each) { return each.name; })];
  plan.shards = from.at("shards");
  return plan;
}

std::string digest(std::string_view payload) {
  Digest of;
  of.add(payload);
  return fmt::format("{:016x}\n", of.value());
}

/// The value that a file holds. Throws Error where it is no shard, or not as it was written.
Json read_file(std::string_view bytes, const std::string& name) {
  const std::size_t head = first_line.size() + digest_digits + 1;
  if (bytes.substr(0, first_line.size()) != first_line)
    throw Error(fmt::format("`{}` is no shard of an audit", name));
  if (bytes.size() < head ||
      digest(bytes.substr(head)) != bytes.substr(first_line.size(), digest_digits + 1))
    throw Error(fmt::format("`{}` is not whole, or was changed", name));
  try {
    return Json::from_cbor(bytes.substr(head));
  } catch (const Json::exception&) {
    throw Error(fmt::format("`{}` is not whole, or was changed", name));
  }
}

/// Texts that several shards have to say: each once, in the order of their coming.
void join(std::string& text, const std::string& other) {
  if (("; " + text + "; ").find("; " + other + "; ") == text.npos) text += "; " + other;
}

void join(Environment& all, const Environment& other) {
  const auto& [compiler, flags, processor, contraction, flush_to_zero, rounding, processors] =
      other;
  join(all.compiler, compiler);
  join(all.flags, flags);
  join(all.processor, processor);
  join(all.rounding, rounding);
  all.contraction |= contraction;
  all.flush_to_zero |= flush_to_zero;
  all.processors = std::max(all.processors, processors);
}

/// The first setting that two shards do not have in common, in words.
std::string what_differs(const std::string& ours, const std::string& theirs) {
  const Json a = Json::parse(ours), b = Json::parse(theirs);
  for (const auto& [key, value] : a.items())
    if (b.at(key) != value) {
      if (value.is_structured()) return fmt::format("its {} differ", key);
      return fmt::format("its {} is {}, not {}", key, b.at(key).dump(), value.dump());
    }
  return "its settings differ";
}

}  // namespace

std::string write_shard(const Run& run, const Look&) {
  Json tallies = Json::array();
  for (const Audit& audit : run.audits) tallies.push_back(written(audit.tally));
  const std::vector<std::uint8_t> cbor =
      Json::to_cbor({{"settings", settings(run.plan, run.version)},
                     {"shard", run.plan.shard},
                     {"command", run.command},
                     {"environment", written(run.environment)},
                     {"tallies", tallies}});
  const std::string payload(cbor.begin(), cbor.end());
  return std::string(first_line) + digest(payload) + payload;
}

Shard read_shard(std::string_view bytes, const std::string& name, const std::string& version,
                 const SubjectNamed& subject_named) {
  const Json from = read_file(bytes, name);
  try {
    const Json& common = from.at("settings");
    if (const std::string made_by = common.at("version"); made_by != version)
      throw Error(fmt::format("it was made by rayaudit {}, and this is {}", made_by, version));
    Shard shard;
    shard.name = name;
    shard.command = from.at("command");
    shard.plan = read_plan(common, subject_named);
    shard.settings = common.dump();
    shard.plan.shard = from.at("shard");
    read(from.at("environment"), shard.environment);
    exactly::read_list(from.at("tallies"), shard.tallies);
    if (shard.tallies.size() != planned(shard.plan).size() || shard.plan.shard >= shard.plan.shards)
      throw Error("its audits are not those of its plan");
    return shard;
  } catch (const Json::exception&) {
    throw Error(fmt::format("`{}` holds something else than a shard of this program's", name));
  } catch (const Error& why) {
    throw Error(fmt::format("`{}` is of no use here: {}", name, why.what()));
  }
}

std::span<const ReportOf<Run>> shard_reports() { return of_shards; }

void ShardSum::add(const Shard& shard) {
  if (names_.empty()) {
    names_.resize(shard.plan.shards);
    first_name_ = shard.name, settings_ = shard.settings, command_ = shard.command;
    environment_ = shard.environment;
    plan_ = shard.plan;
    plan_.shard = 0, plan_.shards = 1;
    audits_ = planned(plan_);
  }
  if (shard.settings != settings_)
    throw Error(fmt::format("`{}` is no shard of the same run as `{}`: {}", shard.name, first_name_,
                            what_differs(settings_, shard.settings)));
  std::string& name = names_[shard.plan.shard];
  if (!name.empty())
    throw Error(fmt::format("`{}` and `{}` are both shard {} of {}", name, shard.name,
                            shard.plan.shard + 1, names_.size()));
  name = shard.name;
  join(environment_, shard.environment);
  for (std::size_t i = 0; i < audits_.size(); ++i) audits_[i].tally.merge(shard.tallies[i]);
}

void ShardSum::require_all() const {
  std::string missing;
  std::size_t count = 0;
  for (std::size_t i = 0; i < names_.size(); ++i)
    if (names_[i].empty() && ++count <= 10)
      missing += fmt::format("{}{}", missing.empty() ? "" : ", ", i + 1);
  if (count == 0) return;
  throw Error(fmt::format("shard{} {}{} of {} {} missing", count == 1 ? "" : "s", missing,
                          count > 10 ? ", ..." : "", names_.size(), count == 1 ? "is" : "are"));
}

}  // namespace rayaudit
