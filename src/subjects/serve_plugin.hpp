#pragma once

namespace rayaudit {

/// The other end of a PluginChild: loads the plugin and answers what standard input asks, there and
/// back, until it ends.
void serve_plugin(const char* plugin);

}  // namespace rayaudit
