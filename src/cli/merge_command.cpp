#include <algorithm>

#include "cli/audit_end.hpp"
#include "cli/command.hpp"
#include "cli/command_text.hpp"
#include "cli/names.hpp"
#include "cli/option.hpp"
#include "cli/whole_file.hpp"
#include "reports/shard.hpp"

namespace rayaudit {
namespace {

struct MergeOptions {
  std::vector<std::string> files;
  SubjectChoice subjects;
  AuditEnd end;
};

ShardSum sum_of(const std::vector<std::string>& files, Subjects& subjects) {
  const auto subject_named = [&](const std::string& name) { return subjects.find(name); };
  ShardSum sum;
  for (const std::string& path : files) {
    const WholeFile file = read_whole(path);
    sum.add(read_shard(file.text, file.name, RAYAUDIT_VERSION, subject_named));
  }
  sum.require_all();
  return sum;
}

int merge(const MergeOptions& options) {
  Subjects subjects(options.subjects);
  ShardSum sum = sum_of(options.files, subjects);
  const ReadyEnd end = ready(options.end, sum.plan());
  conclude(sum.plan(), sum.audits());
  return told(end, {RAYAUDIT_VERSION, sum.plan(), sum.audits(), sum.environment(), sum.command(),
                    options.end.fail_on});
}

}  // namespace

void add_merge_command(CLI::App& program, Command& asked) {
  const auto options = std::make_shared<MergeOptions>();
  CLI::App* command =
      program.add_subcommand("merge", "Put the shards of an audit together: the same as one run");
  command->add_option("FILE", options->files, "what `audit --shard i/n --report shard=FILE` wrote")
      ->type_name("")
      ->required();
  add_bringers(*command, options->subjects, "to be named again where the shards had it");
  add_program_format(*command, options->subjects);
  add_audit_end(*command, options->end);
  command->footer(
      "Plugins and programs of the shards are to be named again.\n"
      "Whatever the shards, and wherever they ran, the reports are those of one run to the byte.\n"
      "Bounds are the shards': each is run with the same --bounds, and here they are judged. (Of "
      "a\n"
      "subject in a process of its own that crashes or hangs too often, each shard gives up by\n"
      "itself: then more is asked than one run would ask.)\n\n"
      "Examples:\n"
      "  rayaudit audit --cases 1e7 --shard 1/2 --report shard=1.shard\n"
      "  rayaudit audit --cases 1e7 --shard 2/2 --report shard=2.shard\n"
      "  rayaudit merge 1.shard 2.shard --report table --report junit=audit.xml\n");
  command->callback([=, &asked] {
    options->end.command = command_text(*command);
    asked = [options] { return merge(*options); };
  });
}

}  // namespace rayaudit
