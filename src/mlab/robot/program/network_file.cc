#include "mlab/robot/program/network_file.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "mlab/lang/cnl/check.h"
#include "mlab/lang/cnl/elaborate.h"
#include "mlab/lang/cnl/load.h"
#include "mlab/robot/program/brought_code.h"

namespace mlab::robot {
namespace {

std::optional<NetworkFile> parse(const text::SourcePtr& source, const ProgramSources& sources,
                                 text::Diagnostics& sink) {
  const std::size_t errors_before = sink.error_count();
  NetworkFile out;
  const text::Files files = files_of(sources);
  out.tree = std::make_shared<const cnl::Tree>(cnl::load(source, sink, nullptr, files));
  cnl::check_declarations(*out.tree, sink);
  out.network = cnl::elaborate(*out.tree, sink);
  out.network.name = std::filesystem::path(source->name()).stem().string();
  if (sink.error_count() > errors_before) return std::nullopt;
  return out;
}

}  // namespace

std::optional<NetworkFile> read_network(const std::string& path, const text::Place& place,
                                        const ProgramSources& sources, text::Diagnostics& sink) {
  const text::SourcePtr source = read_program(path, place, sources, sink);
  if (!source) return std::nullopt;
  std::optional<NetworkFile> out = parse(source, sources, sink);
  if (!out) return std::nullopt;
  const std::span<const std::shared_ptr<const cnl::Tree>> files(&out->tree, 1);
  auto library = describe_library(files);
  auto program = flow::build_program(out->network, library->library, sink);
  if (!program) return std::nullopt;
  auto built =
      make_runnable(std::move(program), out->network, files, std::move(library), place, sources, sink);
  if (!built) return std::nullopt;
  out->built = std::move(*built);
  return out;
}

void check_network(const text::SourcePtr& source, const ProgramSources& sources, text::Diagnostics& sink) {
  const std::optional<NetworkFile> parsed = parse(source, sources, sink);
  if (!parsed) return;
  // Nothing of the file is run: its C++ is read by the compiler, and the network is checked by what the
  // procedures say of themselves.
  const auto checked = checked_library_with({&parsed->tree, 1}, sources, sink);
  if (parsed->network.nodes.empty()) return;  // a library of procedures
  flow::build_program(parsed->network, checked->library, sink);
}

}  // namespace mlab::robot
