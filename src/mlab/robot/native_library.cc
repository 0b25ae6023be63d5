#include "mlab/robot/native_library.h"

#include "mlab/lang/cnl/native_module.h"

namespace mlab::robot {
namespace {

cnl::NativeOptions native_options(const ProgramSources& sources) {
  cnl::NativeOptions options;
  options.include_folders = {sources.include_root};
  options.version = sources.version;
  options.limits.ends = sources.ends;
  return options;
}

// Whether the code of a file can be compiled here; says why not.
bool can_compile(const cnl::Tree& tree, const ProgramSources& sources, text::Diagnostics& sink,
                 bool is_needed) {
  if (!sources.include_root.empty()) return true;
  const text::Place place{tree.source, {0, 0}};
  const char* message =
      "the procedures of this file can't be compiled: the headers of missionlab are not there";
  text::Diagnostic& d =
      is_needed ? sink.error("no-headers", place, message) : sink.warning("no-headers", place, message);
  d.hints.emplace_back("install missionlab with its headers, or run it from its source tree");
  return false;
}

}  // namespace

std::optional<flow::Library> library_with(std::span<const std::shared_ptr<const cnl::Tree>> files,
                                          const ProgramSources& sources, text::Diagnostics& sink) {
  flow::Library library = component_library();
  for (const auto& tree : files) {
    if (!cnl::has_procedures(*tree)) continue;
    if (!can_compile(*tree, sources, sink, true)) return std::nullopt;
    const std::optional<cnl::NativeModule> module = cnl::load_native(*tree, native_options(sources), sink);
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
    if (sources.checks_code && cnl::has_procedures(*tree) && can_compile(*tree, sources, sink, false)) {
      cnl::check_native(*tree, native_options(sources), sink);
    }
    const flow::Library& library = out->library;
    const cnl::Signatures& own = out->signatures.emplace_back(
        *tree, [&library](std::string_view name) { return library.find_type(name); });
    out->library.add(own.behaviors());
  }
  return out;
}

}  // namespace mlab::robot
