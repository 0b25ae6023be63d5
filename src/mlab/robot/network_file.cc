#include "mlab/robot/network_file.h"

#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cnl/check.h"
#include "mlab/lang/cnl/elaborate.h"
#include "mlab/lang/cnl/load.h"
#include "mlab/lang/cnl/native_module.h"
#include "mlab/lang/cnl/signatures.h"

namespace mlab::robot {
namespace {

cnl::NativeOptions native_options(const ProgramSources& sources) {
  cnl::NativeOptions options;
  options.include_folders = {sources.include_root};
  options.version = sources.version;
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

// The component library, and the file's own procedures behind it.
std::optional<flow::Library> library_of(const cnl::Tree& tree, const ProgramSources& sources,
                                        text::Diagnostics& sink) {
  flow::Library library = component_library();
  if (!cnl::has_procedures(tree)) return library;
  if (!can_compile(tree, sources, sink, true)) return std::nullopt;
  const std::optional<cnl::NativeModule> module = cnl::load_native(tree, native_options(sources), sink);
  if (!module) return std::nullopt;
  library.add(module->behaviors);
  return library;
}

struct Parsed {
  cnl::Tree tree;
  flow::Network network;
};

std::optional<Parsed> parse(const text::SourcePtr& source, text::Diagnostics& sink) {
  const std::size_t errors_before = sink.error_count();
  Parsed out;
  out.tree = cnl::load(source, sink);
  cnl::check_declarations(out.tree, sink);
  out.network = cnl::elaborate(out.tree, sink);
  out.network.name = std::filesystem::path(source->name()).stem().string();
  if (sink.error_count() > errors_before) return std::nullopt;
  return out;
}

}  // namespace

std::shared_ptr<const flow::Program> load_network(const std::string& path, const text::Place& place,
                                                  const ProgramSources& sources, text::Diagnostics& sink) {
  const std::filesystem::path file =
      std::filesystem::path(sources.folder) / path;  // an absolute path stays as it is
  text::Result<text::SourcePtr> source = text::read_source(file.string());
  if (!source) {
    text::Diagnostic problem = source.error();
    problem.place = place;
    sink.report(std::move(problem));
    return nullptr;
  }
  const std::optional<Parsed> parsed = parse(*source, sink);
  if (!parsed) return nullptr;
  const std::optional<flow::Library> library = library_of(parsed->tree, sources, sink);
  return library ? flow::build_program(parsed->network, *library, sink) : nullptr;
}

void check_network(const text::SourcePtr& source, const ProgramSources& sources, text::Diagnostics& sink) {
  const std::optional<Parsed> parsed = parse(source, sink);
  if (!parsed) return;
  // Nothing of the file is run: its C++ is read by the compiler, and the network is checked by what the
  // procedures say of themselves.
  if (cnl::has_procedures(parsed->tree) && can_compile(parsed->tree, sources, sink, false)) {
    cnl::check_native(parsed->tree, native_options(sources), sink);
  }
  if (parsed->network.nodes.empty()) return;  // a library of procedures
  flow::Library library = component_library();
  const cnl::Signatures own(parsed->tree, [&](std::string_view name) { return library.find_type(name); });
  library.add(own.behaviors());
  flow::build_program(parsed->network, library, sink);
}

}  // namespace mlab::robot
