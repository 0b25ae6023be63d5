#include "layout.h"

#include <algorithm>
#include <array>

namespace mlab::repo {
namespace {

constexpr std::size_t kMaxLines = 600;
constexpr std::size_t kMaxReadmeLines = 30;
constexpr std::size_t kMaxPlainLines = 5;

// In two pieces, so that this file does not find itself.
constexpr std::array<std::string_view, 6> kMachineTraces = {
    "/wo"
    "rk/",
    "/ho"
    "me/",
    "deb.debian"
    ".org",
    "snapshot.debian"
    ".org",
    "registry.npmjs"
    ".org",
    "py"
    "pi.org",
};

// Whose last digit is another on ARM than on x86-64, in Debian 12's C library. What is not here of what
// robots compute with is the same on both: tools/agent_arm64 --try runs every mission on both.
constexpr std::array<std::string_view, 8> kUnequalFunctions = {"hypot", "cbrt",  "erf",    "erfc",
                                                               "exp2",  "acosh", "tgamma", "lgamma"};

bool is_source(const File& file) {
  constexpr std::array<std::string_view, 13> kSuffixes = {
      ".h", ".cc", ".cnl", ".sh", ".cmake", ".mdl", ".odl", ".txt", ".ts", ".tsx", ".css", ".mjs", ".proto"};
  return std::ranges::any_of(kSuffixes, [&](std::string_view suffix) { return file.ends_with(suffix); });
}

bool is_module_header(const File& file) {
  return file.ends_with(".h") && file.path.starts_with("src/mlab/");
}

/// The name of the type whose definition of several lines begins here; empty on every other line and on
/// specialisations.
std::string_view defined_type(std::string_view line) {
  for (const std::string_view keyword : {"class ", "struct ", "enum class "}) {
    if (!line.starts_with(keyword) || !line.ends_with('{')) continue;
    line.remove_prefix(keyword.size());
    const std::string_view name = line.substr(0, line.find_first_of(" {"));
    return name.find_first_of("<:") == std::string_view::npos ? name : std::string_view{};
  }
  return {};
}

/// True where a comment stands above the type that `lines[first]` opens, or somewhere inside it, or where it
/// is so short that its fields say it all.
bool is_commented(const std::vector<std::string_view>& lines, std::size_t first) {
  std::size_t above = first;
  while (above > 0 && lines[above - 1].starts_with("template")) --above;
  if (above > 0 && lines[above - 1].starts_with("//")) return true;
  std::size_t last = first + 1;
  for (; last < lines.size() && !lines[last].starts_with('}'); ++last) {
    if (lines[last].find("//") != std::string_view::npos) return true;
  }
  return last - first <= kMaxPlainLines;
}

}  // namespace

Findings machine_traces(const Tree& tree) {
  Findings findings;
  for (const File& file : tree) {
    const auto lines = file.lines();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const std::string_view trace : kMachineTraces) {
        if (lines[i].find(trace) != std::string_view::npos) {
          findings.push_back(
              {file.path, i + 1, "names `" + std::string(trace) + "`, which is this machine's business"});
        }
      }
    }
  }
  return findings;
}

Findings long_files(const Tree& tree) {
  Findings findings;
  for (const File& file : tree) {
    const std::size_t count = file.lines().size();
    if (is_source(file) && count > kMaxLines) {
      findings.push_back({file.path, count, "has more than 600 lines; which idea should it give up?"});
    }
  }
  return findings;
}

Findings uncommented_types(const Tree& tree) {
  Findings findings;
  for (const File& file : tree) {
    if (!is_module_header(file)) continue;
    const auto lines = file.lines();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::string_view name = defined_type(lines[i]);
      if (name.empty() || is_commented(lines, i)) continue;
      findings.push_back({file.path, i + 1, "no comment says what `" + std::string(name) + "` is"});
    }
  }
  return findings;
}

Findings modules_without_readme(const Tree& tree) {
  Findings findings;
  for (const File& file : tree) {
    constexpr std::string_view kBuildFile = "/CMakeLists.txt";
    if (!file.path.starts_with("src/mlab/") || !file.ends_with(kBuildFile)) continue;
    const std::string path = file.path.substr(0, file.path.size() - kBuildFile.size()) + "/README.md";
    const File* readme = find_file(tree, path);
    if (readme == nullptr) {
      findings.push_back(
          {path, 1, "is missing: what the module is for, where to start reading, what it must not know"});
    } else if (readme->lines().size() > kMaxReadmeLines) {
      findings.push_back({path, kMaxReadmeLines + 1, "is longer than 30 lines"});
    }
  }
  return findings;
}

Findings unguarded_headers(const Tree& tree) {
  Findings findings;
  for (const File& file : tree) {
    if (file.ends_with(".h") && !file.text.starts_with("#pragma once\n")) {
      findings.push_back({file.path, 1, "does not start with `#pragma once`"});
    }
  }
  return findings;
}

Findings unequal_arithmetic(const Tree& tree) {
  constexpr std::array<std::string_view, 4> kFolders = {"src/mlab/", "library/", "missions/",
                                                        "docs/examples/"};
  Findings findings;
  for (const File& file : tree) {
    const bool computes =
        std::ranges::any_of(kFolders, [&](auto folder) { return file.path.starts_with(folder); });
    if (!computes || file.ends_with("_test.cc") ||
        !(file.ends_with(".h") || file.ends_with(".cc") || file.ends_with(".cnl")))
      continue;
    const auto lines = file.lines();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const std::string_view function : kUnequalFunctions) {
        const std::string call = "std::" + std::string(function) + "(";
        if (lines[i].find(call) != std::string_view::npos)
          findings.push_back(
              {file.path, i + 1, "`" + call + "...)` is rounded otherwise on other processors"});
      }
    }
  }
  return findings;
}

}  // namespace mlab::repo
