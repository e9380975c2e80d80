#pragma once

namespace rayaudit {

/// The other end of a ModuleChild: loads the module and answers what standard input asks, there and
/// back, until it ends.
void serve_module(const char* module);

}  // namespace rayaudit
