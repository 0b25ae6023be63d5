#include "web_layering.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace mlab::repo {
namespace {

using Folders = std::set<std::string, std::less<>>;

constexpr std::string_view kRoot = "web/";

/// All that a folder may import by itself or through others; itself only where it stands in a circle.
Folders reachable(const std::string& folder, const WebArrows& arrows) {
  Folders found;
  std::vector<std::string> open{folder};
  while (!open.empty()) {
    const auto it = arrows.find(open.back());
    open.pop_back();
    if (it == arrows.end()) continue;
    for (const std::string& next : it->second) {
      if (found.insert(next).second) open.push_back(next);
    }
  }
  return found;
}

bool is_web_source(const File& file) {
  constexpr std::array<std::string_view, 4> kSuffixes = {".ts", ".tsx", ".css", ".mjs"};
  return file.path.starts_with(kRoot) &&
         std::ranges::any_of(kSuffixes, [&](std::string_view suffix) { return file.ends_with(suffix); });
}

/// The folder of a path in `web/`, as the table calls it; empty for `web/` itself.
std::string folder_of(std::string_view path) {
  path.remove_prefix(kRoot.size());
  if (path.starts_with("generated/")) return "generated";
  const std::size_t end = path.rfind('/');
  return end == std::string_view::npos ? std::string{} : std::string(path.substr(0, end));
}

/// A path between quotes of either kind that leads to another file: `"../x.ts"`. Whatever stands before it:
/// `from`, `import(`, `@import`, `new URL(`.
struct Quoted {
  std::string_view path;
  std::size_t end = 0;
};

std::optional<Quoted> next_quoted(std::string_view line, std::size_t from) {
  for (std::size_t at = line.find_first_of("\"'`", from); at != std::string_view::npos;
       at = line.find_first_of("\"'`", at + 1)) {
    const std::string_view rest = line.substr(at + 1);
    if (!rest.starts_with("./") && !rest.starts_with("../")) continue;
    const std::size_t length = rest.find(line[at]);
    if (length == std::string_view::npos) return std::nullopt;
    return Quoted{rest.substr(0, length), at + 1 + length + 1};
  }
  return std::nullopt;
}

/// Where a path that stands in `file` leads, from the root of the project.
std::string target_of(const File& file, std::string_view path) {
  path = path.substr(0, path.find('?'));
  const std::filesystem::path folder = std::filesystem::path(file.path).parent_path();
  return (folder / path).lexically_normal().generic_string();
}

/// What a line imports from other folders of `web/`.
Folders imported(const File& file, std::string_view line) {
  constexpr std::array<std::string_view, 5> kSuffixes = {".ts", ".tsx", ".css", ".mjs", ".js"};
  Folders found;
  std::size_t from = 0;
  while (const std::optional<Quoted> quoted = next_quoted(line, from)) {
    from = quoted->end;
    const std::string target = target_of(file, quoted->path);
    const bool is_source =
        std::ranges::any_of(kSuffixes, [&](std::string_view suffix) { return target.ends_with(suffix); });
    if (is_source && target.starts_with(kRoot)) found.insert(folder_of(target));
  }
  return found;
}

}  // namespace

const WebArrows& web_arrows() {
  static const WebArrows kWebArrows = {
      {"generated", {}},
      {"tools", {}},
      {"tests", {"tools"}},

      // Free of any framework.
      {"core/tables", {}},
      {"core", {"generated", "core/tables"}},
      {"core/map", {"core"}},
      {"core/map/tools", {"core/map"}},

      // What both pages are made of.
      {"ui/styles", {}},
      {"ui/words", {"core"}},
      {"ui/controls", {"ui/words"}},
      {"ui/commands", {"ui/controls"}},
      {"ui/files", {"ui/controls"}},
      {"ui/text", {"core"}},
      {"ui/names", {"ui/controls"}},
      {"ui/time", {"ui/controls"}},

      // The operator console: what every panel may ask, panels, what shows them.
      {"console/session", {"core/map", "ui/commands"}},
      {"console/time", {"console/session", "ui/files", "ui/time"}},
      {"console/breakpoints", {"console/time"}},
      {"console/map_editing", {"console/session"}},
      {"console/command", {"console/map_editing", "ui/text"}},
      {"console/overlay", {"console/map_editing"}},
      {"console/world", {"console/map_editing"}},
      {"console/measuring", {"core/map/tools", "console/session"}},
      {"console/preflight", {"console/session"}},
      {"console/mission", {"console/preflight", "console/vehicles"}},
      {"console/vehicles", {"console/session"}},
      {"console/robots", {"console/mission", "console/vehicles"}},
      {"console/failsafes", {"console/session"}},
      {"console/machines", {"console/session"}},
      {"console/selection", {"console/failsafes", "console/robots", "console/time"}},
      {"console/log", {"console/time"}},
      {"console/questions", {"console/log", "console/mission"}},
      {"console/calls", {"console/log"}},
      {"console/clients", {"console/session"}},
      {"console/editor", {"console/session", "ui/files", "ui/names", "ui/text"}},
      {"console/plots", {"console/time"}},
      {"console/settings", {"console/calls"}},
      {"console/start", {"console/session", "ui/files"}},
      {"console/teleoperation", {"console/session"}},
      {"console/extensions",
       {"console/breakpoints", "console/command", "console/editor", "console/failsafes", "console/log",
        "console/machines", "console/measuring", "console/mission", "console/overlay", "console/plots",
        "console/robots", "console/selection", "console/settings", "console/teleoperation", "console/world"}},
      {"console/actions", {"console/extensions", "console/time"}},
      {"console/shell", {"console/actions", "console/clients", "console/start"}},
      {"console/styles", {}},
      {"console", {"console/calls", "console/questions", "console/shell", "console/styles", "ui/styles"}},
      {"console/gallery", {"core/map"}},

      // The designer: what the page knows, what a page looks like, what is seen of it, what is done with it.
      {"designer/session", {"ui/commands"}},
      {"designer/names", {"designer/session", "ui/names"}},
      {"designer/drawing", {"designer/session"}},
      {"designer/states", {"designer/drawing"}},
      {"designer/arrange", {"designer/states"}},
      {"designer/compare", {"designer/states"}},
      {"designer/sight", {"designer/arrange", "designer/compare"}},
      {"designer/running", {"designer/session"}},
      {"designer/views", {"designer/sight", "designer/running", "designer/compare"}},
      {"designer/palette", {"designer/views"}},
      {"designer/tour", {"designer/sight"}},
      {"designer/exports", {"designer/sight", "ui/files"}},
      {"designer/actions", {"designer/exports", "designer/names", "designer/palette", "designer/tour"}},
      {"designer/canvas", {"designer/actions"}},
      {"designer/problems", {"designer/session"}},
      {"designer/text", {"designer/names", "designer/problems", "ui/text"}},
      {"designer/details", {"designer/actions", "designer/text"}},
      {"designer/dialogs", {"designer/actions"}},
      {"designer/differences", {"designer/actions", "ui/files"}},
      {"designer/files", {"designer/actions", "ui/files"}},
      {"designer/styles", {}},
      {"designer",
       {"designer/canvas", "designer/details", "designer/dialogs", "designer/differences", "designer/files",
        "designer/styles", "ui/styles"}},

      // The page of `mlab edit`: the only one that knows both.
      {"edit/run", {"console/breakpoints", "designer/running", "designer/sight"}},
      {"edit/tests", {"edit/run"}},
      {"edit/panes", {"console/selection", "designer/details", "edit/run"}},
      {"edit", {"designer", "edit/panes", "edit/tests"}},
  };
  return kWebArrows;
}

Findings web_imports(const Tree& tree, const WebArrows& arrows) {
  Findings findings;
  for (const File& file : tree) {
    if (!is_web_source(file)) continue;
    const std::string folder = folder_of(file.path);
    if (folder.empty()) continue;
    if (!arrows.contains(folder)) {
      findings.push_back(
          {file.path, 1, "the folder `" + folder + "` has no place in tests/repo/web_layering.cc"});
      continue;
    }
    Folders allowed = reachable(folder, arrows);
    allowed.insert(folder);
    const auto lines = file.lines();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const std::string& target : imported(file, lines[i])) {
        if (allowed.contains(target)) continue;
        findings.push_back({file.path, i + 1, "`" + folder + "` must not import `" + target + "`"});
      }
    }
  }
  return findings;
}

std::set<std::string> web_circles(const WebArrows& arrows) {
  std::set<std::string> found;
  for (const auto& [folder, known] : arrows) {
    if (reachable(folder, arrows).contains(folder)) found.insert(folder);
  }
  return found;
}

}  // namespace mlab::repo
