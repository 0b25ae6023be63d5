#include "mlab/robot/native_library.h"

#include <fmt/core.h>

#include "mlab/lang/cnl/native_module.h"

namespace mlab::robot {
namespace {

cnl::NativeOptions native_options(const ProgramSources& sources, cell::Wall wall) {
  cnl::NativeOptions options;
  options.wall = wall;
  options.include_folders = {sources.include_root};
  options.version = sources.version;
  options.limits.ends = sources.ends;
  return options;
}

enum class Aim { kCheck, kRun };

// The walls that the code of a file is compiled in (and run); nothing, and why, where it may or can not be.
std::optional<cell::Wall> wall_for(const cnl::Tree& tree, const ProgramSources& sources,
                                   text::Diagnostics& sink, Aim aim) {
  const text::Place place{tree.source, {0, 0}};
  const auto say = [&](const char* kind, const std::string& why) -> text::Diagnostic& {
    const std::string message = fmt::format("the procedures of this file can't be compiled: {}", why);
    return aim == Aim::kRun ? sink.error(kind, place, message) : sink.warning(kind, place, message);
  };
  cell::Wall wall{};
  for (const text::SourcePtr& code : cnl::code_sources(tree)) {
    const auto given = aim == Aim::kRun ? sources.permission.to_run(code->text())
                                        : sources.permission.to_compile(code->text());
    if (!given) {
      say("code-not-allowed", given.error());
      return std::nullopt;
    }
    wall = *given;
  }
  if (!sources.include_root.empty()) return wall;
  say("no-headers", "the headers of missionlab are not there")
      .hints.emplace_back("install missionlab with its headers, or run it from its source tree");
  return std::nullopt;
}

}  // namespace

std::optional<flow::Library> library_with(std::span<const std::shared_ptr<const cnl::Tree>> files,
                                          const ProgramSources& sources, text::Diagnostics& sink) {
  flow::Library library = component_library();
  for (const auto& tree : files) {
    if (!cnl::has_procedures(*tree)) continue;
    const auto wall = wall_for(*tree, sources, sink, Aim::kRun);
    if (!wall) return std::nullopt;
    const std::optional<cnl::NativeModule> module =
        cnl::load_native(*tree, native_options(sources, *wall), sink);
    if (!module) return std::nullopt;
    library.add(module->behaviors);
  }
  return library;
}

std::unique_ptr<CheckedLibrary> checked_library_with(std::span<const std::shared_ptr<const cnl::Tree>> files,
                                                     const ProgramSources& sources, text::Diagnostics& sink) {
  auto out = std::make_unique<CheckedLibrary>();
  out->library = component_library();
  for (const auto& tree : files) {
    if (sources.checks_code && cnl::has_procedures(*tree)) {
      if (const auto wall = wall_for(*tree, sources, sink, Aim::kCheck))
        cnl::check_native(*tree, native_options(sources, *wall), sink);
    }
    const flow::Library& library = out->library;
    const cnl::Signatures& own = out->signatures.emplace_back(
        *tree, [&library](std::string_view name) { return library.find_type(name); });
    out->library.add(own.behaviors());
  }
  return out;
}

}  // namespace mlab::robot
