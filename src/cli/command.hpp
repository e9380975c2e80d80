#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace rayaudit {

/// What the command line asks for; run, it tells the exit code.
using Command = std::function<int()>;

/// Each adds a command to the program; where the command line asks for it, `asked` becomes it.
void add_audit_command(CLI::App& program, Command& asked);
void add_check_command(CLI::App& program, Command& asked);
void add_cost_command(CLI::App& program, Command& asked);
void add_explain_command(CLI::App& program, Command& asked);
void add_ladder_command(CLI::App& program, Command& asked);
void add_scene_command(CLI::App& program, Command& asked);
void add_draw_command(CLI::App& program, Command& asked);
void add_truth_command(CLI::App& program, Command& asked);
void add_judge_command(CLI::App& program, Command& asked);
void add_diff_command(CLI::App& program, Command& asked);
void add_merge_command(CLI::App& program, Command& asked);
void add_list_command(CLI::App& program, Command& asked);
void add_serve_plugin_command(CLI::App& program, Command& asked);

}  // namespace rayaudit
