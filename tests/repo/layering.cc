#include "layering.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace mlab::repo {
namespace {

using Modules = std::set<std::string, std::less<>>;

/// Which modules each one may include by itself; what those may include follows. The picture in
/// docs/architecture.md shows the same.
const std::map<std::string, Modules, std::less<>> kArrows = {
    {"base", {}},
    {"geom", {"base"}},
    {"ways", {"geom"}},
    {"text", {"base"}},
    {"geography", {"geom", "text"}},
    {"tiles", {"text"}},
    {"documents", {"base", "text"}},
    {"cell", {"base", "text"}},
    {"dds", {"base", "text"}},
    {"keys", {"dds"}},
    {"mcap", {"base", "text"}},
    {"metrics", {"base"}},
    {"statistics", {"base"}},
    {"percept", {"ways"}},
    {"flow", {"percept", "text"}},
    {"robot/wire", {"flow"}},
    {"robot/process", {"flow", "robot/wire"}},
    {"robot/host", {"cell", "robot/wire", "text"}},
    {"schema", {"flow"}},
    {"overlay", {"geom", "text", "geography"}},
    {"mission", {"overlay", "percept"}},
    {"binding", {"percept", "overlay"}},
    {"vehicle", {"binding", "text"}},
    {"simulated_vehicle", {"vehicle", "sim"}},
    {"preflight", {"run", "vehicle"}},
    {"vehicles", {"agents", "preflight", "vehicle"}},
    {"mavlink", {"vehicle", "text"}},
    {"ros2", {"dds", "vehicle", "text"}},
    {"model_vehicles", {"vehicle", "mavlink", "lang/odl"}},
    {"sim", {"binding"}},
    {"recording", {"binding", "robot/wire", "text"}},
    {"lang/odl", {"text", "overlay"}},
    {"lang/envchange", {"text", "overlay"}},
    {"lang/mdl", {"text", "mission", "lang/odl"}},
    {"lang/cnl", {"cell", "text", "flow"}},
    {"lang/cdl", {"text", "flow", "lang/cnl"}},
    {"lang/cdl_historic", {"text", "flow", "lang/cdl"}},
    {"difference", {"text", "flow", "lang/cdl"}},
    {"git", {"text"}},
    {"export", {"flow", "lang/cdl"}},
    {"library", {"schema"}},
    {"robot/program", {"cell", "percept", "robot/host", "flow", "lang/cnl", "lang/cdl", "library"}},
    {"robot/runner", {"library", "robot/process"}},
    {"robot/remote", {"robot/program", "library"}},
    {"agents", {"robot/remote", "dds"}},
    {"robot/executable", {"cell", "robot/program", "robot/process"}},
    {"component_test", {"robot/program", "lang/cdl", "percept"}},
    {"fleet", {"robot/program", "mission", "binding"}},
    {"run", {"fleet"}},
    {"simulated", {"run"}},
    {"history", {"simulated", "vehicle", "lang/mdl", "lang/envchange", "mcap"}},
    {"page", {"statistics", "text"}},
    {"journal", {"history"}},
    {"comparison", {"history", "page"}},
    {"viewers", {"run", "text"}},
    {"study", {"history", "page", "lang/mdl", "lang/envchange"}},
    {"training", {"simulated"}},
    {"assist", {"run", "lang/mdl", "lang/odl", "lang/envchange"}},
    {"project", {"documents", "assist"}},
    {"lsp", {"documents", "assist"}},
    {"console/server", {"base", "metrics"}},
    {"console",
     {"cell", "comparison", "documents", "history", "journal", "metrics", "preflight", "simulated", "assist",
      "project", "tiles", "lang/mdl", "lang/odl", "lang/envchange", "console/server"}},
    {"designer", {"component_test", "console", "difference", "git", "lang/cdl", "lang/cdl_historic"}},
    {"python", {"cli", "study", "training", "history", "lang/mdl", "lang/envchange", "lang/cnl"}},
    {"tables", {"dds", "lang/mdl", "lang/cdl"}},
};

/// What the sources of a module use besides, and keep to themselves: neither its headers nor who stands above
/// it know of it.
const std::map<std::string, Modules, std::less<>> kKept = {
    {"model_vehicles", {"sim"}},
    {"simulated", {"sim"}},
    {"training", {"sim"}},
};

/// Whose messages a file of proto/mlab holds, by how its name begins.
constexpr std::array<std::pair<std::string_view, std::string_view>, 11> kMessages = {{
    {"history", "history"},
    {"viewers", "viewers"},
    {"journal", "journal"},
    {"robot", "robot/wire"},
    {"agent", "robot/remote"},
    {"presence", "agents"},
    {"vehicle", "vehicle"},
    {"percepts_file", "recording"},
    {"console", "console"},
    {"designer", "designer"},
    {"names", "project"},
}};

/// The module of a path such as `mlab/lang/odl/parser.h`; empty where it is none of ours. Messages belong to
/// who speaks by them: `mlab/console_map.pb.h`.
std::string module_of(std::string_view path) {
  constexpr std::string_view kRoot = "mlab/";
  if (!path.starts_with(kRoot)) return {};
  path.remove_prefix(kRoot.size());
  if (path.ends_with(".pb.h")) {
    const auto found =
        std::ranges::find_if(kMessages, [&](const auto& one) { return path.starts_with(one.first); });
    return found == kMessages.end() ? std::string(path) : std::string(found->second);
  }
  std::size_t end = path.find('/');
  if (path.starts_with("lang/") || path.starts_with("robot/") || path.starts_with("console/server/"))
    end = path.find('/', end + 1);
  return end == std::string_view::npos ? std::string{} : std::string(path.substr(0, end));
}

/// All that a module may include, itself too.
Modules reachable(const std::string& module) {
  Modules found{module};
  std::vector<std::string> open{module};
  while (!open.empty()) {
    const auto it = kArrows.find(open.back());
    open.pop_back();
    if (it == kArrows.end()) continue;
    for (const auto& next : it->second) {
      if (found.insert(next).second) open.push_back(next);
    }
  }
  return found;
}

/// All that a file of the module may include.
Modules allowed_in(const File& file, const std::string& module) {
  Modules allowed = reachable(module);
  const auto kept = kKept.find(module);
  if (kept != kKept.end() && !file.path.ends_with(".h"))
    allowed.insert(kept->second.begin(), kept->second.end());
  return allowed;
}

/// Code that only tests and fuzzers see: they put together what nobody else may.
bool is_for_tests(const File& file) {
  return file.path.ends_with("_test.cc") || file.path.find("/testing/") != std::string::npos ||
         file.path.starts_with("tests/") || file.path.starts_with("fuzz/") || file.path.starts_with("bench/");
}

/// The module that a source belongs to; empty where it belongs to none.
std::string module_with(const File& file) {
  constexpr std::string_view kSources = "src/";
  if (file.path.starts_with(kSources)) return module_of(std::string_view(file.path).substr(kSources.size()));
  // Its tests run robots in the simulator.
  return file.path.starts_with("library/") && !is_for_tests(file) ? "library" : "";
}

/// What stands between the quotes of an `#include "..."`; empty on every other line.
std::string_view included(std::string_view line) {
  constexpr std::string_view kInclude = "#include \"";
  if (!line.starts_with(kInclude)) return {};
  line.remove_prefix(kInclude.size());
  return line.substr(0, line.find('"'));
}

}  // namespace

Findings foreign_permissions(const Tree& tree) {
  constexpr std::string_view kMakes = "Permission::decide(";
  Findings findings;
  for (const File& file : tree) {
    const bool is_allowed = file.path == "src/mlab/cli/permission.cc" || is_for_tests(file);
    if (!file.is_cpp() || !file.path.starts_with("src/") || is_allowed) continue;
    const auto lines = file.lines();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (lines[i].find(kMakes) == std::string_view::npos) continue;
      findings.push_back({file.path, i + 1, "only src/mlab/cli/permission.cc decides what code may do"});
    }
  }
  return findings;
}

Findings upward_includes(const Tree& tree) {
  Findings findings;
  for (const File& file : tree) {
    if (!file.is_cpp()) continue;
    const std::string module = module_with(file);
    if (module.empty() || module == "cli") continue;
    if (!kArrows.contains(module)) {
      findings.push_back(
          {file.path, 1, "the module `" + module + "` has no place in tests/repo/layering.cc"});
      continue;
    }
    const Modules allowed = allowed_in(file, module);
    const auto lines = file.lines();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::string target = module_of(included(lines[i]));
      if (target.empty() || allowed.contains(target)) continue;
      findings.push_back(
          {file.path, i + 1, "`" + module + "` must not include `" + target + "`, which stands above it"});
    }
  }
  return findings;
}

Findings tests_in_the_product(const Tree& tree) {
  Findings findings;
  for (const File& file : tree) {
    if (!file.is_cpp() || is_for_tests(file)) continue;
    const auto lines = file.lines();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (included(lines[i]).find("testing/") == std::string_view::npos) continue;
      findings.push_back({file.path, i + 1, "what lies in `testing/` is for tests alone"});
    }
  }
  return findings;
}

}  // namespace mlab::repo
