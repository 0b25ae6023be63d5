#include "mlab/robot/program/brought_code.h"

#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <expected>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/lang/cnl/check.h"
#include "mlab/lang/cnl/native_module.h"
#include "mlab/lang/cnl/parser.h"
#include "mlab/robot/wire/framing.h"
#include "mlab/robot/wire/network_wire.h"
#include "mlab/robot/wire/shared_cycle.h"
#include "mlab/text/shown.h"

namespace mlab::robot {
namespace {

constexpr std::uint32_t kMostState = 1U << 24;  // [bytes] of one node; more is nonsense

cnl::NativeOptions native_options(const ProgramSources& sources, cell::Wall wall) {
  cnl::NativeOptions options;
  options.wall = wall;
  options.include_folders = {sources.include_root};
  options.version = sources.version;
  if (sources.came_from_elsewhere)
    options.project = cnl::ProjectPart::kNone;
  else if (sources.permission.others_write_files())
    options.project = cnl::ProjectPart::kSources;
  options.limits.ends = sources.ends;
  return options;
}

// The walls within which the code of a file is compiled; nothing, and why, where it can't be.
std::optional<cell::Wall> wall_to_compile(const cnl::Tree& tree, const ProgramSources& sources,
                                          text::Diagnostics& sink, text::Severity severity) {
  const text::Place place{tree.source, {0, 0}};
  const auto say = [&](const char* kind, const std::string& why) -> text::Diagnostic& {
    const std::string message = fmt::format("the procedures of this file can't be compiled: {}", why);
    return severity == text::Severity::kError ? sink.error(kind, place, message)
                                              : sink.warning(kind, place, message);
  };
  std::optional<cell::Wall> out;
  for (const text::SourcePtr& code : cnl::code_sources(tree)) {
    const auto wall = sources.permission.to_compile(code->text());
    if (!wall) {
      say("code-not-allowed", wall.error());
      return std::nullopt;
    }
    out = *wall;
  }
  if (!sources.include_root.empty()) return out;
  say("no-headers", "the headers of missionlab are not there")
      .hints.emplace_back("install missionlab with its headers, or run it from its source tree");
  return std::nullopt;
}

std::expected<cell::Wall, std::string> wall_to_run(ProcedureFiles files, const ProgramSources& sources) {
  std::expected<cell::Wall, std::string> out = sources.permission.wall_of_ours();
  for (const auto& tree : files) {
    for (const text::SourcePtr& code : cnl::code_sources(*tree)) {
      out = sources.permission.to_run(code->text());
      if (!out) return out;
    }
  }
  return out;
}

/// A program and all that it points into.
struct Mirror {
  std::unique_ptr<DescribedLibrary> library;
  std::shared_ptr<const flow::Program> program;
};

std::shared_ptr<const flow::Program> kept(std::unique_ptr<DescribedLibrary> library,
                                          std::shared_ptr<const flow::Program> program) {
  const auto mirror = std::make_shared<const Mirror>(std::move(library), std::move(program));
  return {mirror, mirror->program.get()};
}

std::set<const flow::Behavior*> brought_behaviors(const DescribedLibrary& library) {
  std::set<const flow::Behavior*> out;
  for (const cnl::Signatures& one : library.signatures)
    out.insert(one.behaviors().begin(), one.behaviors().end());
  return out;
}

// By index of the network's nodes: whose code runs there.
std::vector<std::string> codes_of(const flow::Network& network, const DescribedLibrary& library) {
  const std::set<const flow::Behavior*> brought = brought_behaviors(library);
  std::vector<std::string> out;
  for (const flow::Node& node : network.nodes) {
    const flow::Behavior* behavior =
        node.kind == flow::Node::Kind::kBehavior ? library.library.find(node.behavior).behavior : nullptr;
    out.push_back(brought.contains(behavior) ? fmt::format("procedure `{}` ({}) at node `{}`", behavior->name,
                                                           behavior->file, node.name)
                                             : "");
  }
  return out;
}

std::optional<wire::Load> compiled(const flow::Network& network, ProcedureFiles files,
                                   const ProgramSources& sources, text::Diagnostics& sink) {
  wire::Load load;
  robot_wire::encode(network, *load.mutable_network());
  load.set_layout(robot_wire::shared_layout());
  for (const auto& tree : files) {
    if (!cnl::has_procedures(*tree)) continue;
    const auto wall = wall_to_compile(*tree, sources, sink, text::Severity::kError);
    if (!wall) return std::nullopt;
    const std::optional<cnl::NativeModule> module =
        cnl::compile_native(*tree, native_options(sources, *wall), sink);
    if (!module) return std::nullopt;
    load.add_libraries(module->file);
  }
  return load;
}

bool is_alignment(std::uint32_t value) {
  return value != 0 && value <= flow::Frame::kAlignment && (value & (value - 1)) == 0;
}

// What the process said of its code's sizes; it is not trusted to say anything sensible. What it leaves out
// shows when the layouts are compared. False: nothing can have such sizes.
bool adopt(const wire::Loaded& loaded, DescribedLibrary& library) {
  for (const wire::CompiledType& type : loaded.types()) {
    if (type.size() == 0 || type.size() > kMostState || !is_alignment(type.alignment())) return false;
    for (cnl::Signatures& one : library.signatures) one.set_type(type.name(), type.size(), type.alignment());
  }
  for (const wire::CompiledBehavior& behavior : loaded.behaviors()) {
    if (behavior.state_size() > kMostState || !is_alignment(behavior.state_alignment())) return false;
    for (cnl::Signatures& one : library.signatures)
      one.set_state(behavior.name(), behavior.state_size(), behavior.state_alignment(),
                    behavior.has_header());
  }
  return true;
}

// Of all nodes together [bytes], with what a process said of its code.
std::uint64_t state_size(const flow::Network& network, const DescribedLibrary& library) {
  std::uint64_t out = 0;
  for (const flow::Node& node : network.nodes) {
    if (const flow::Behavior* behavior = library.library.find(node.behavior).behavior; behavior != nullptr)
      out += behavior->state_size;
  }
  return out;
}

// The program once more, in this process, of what `hosted` computes.
std::expected<BuiltProgram, std::string> mirrored(const flow::Network& network,
                                                  std::unique_ptr<DescribedLibrary> library,
                                                  const wire::Loaded& loaded,
                                                  robot_host::HostedProgram hosted) {
  if (!adopt(loaded, *library) || state_size(network, *library) > robot_wire::kMaxFrame)
    return std::unexpected("describes other procedures than the text");
  text::Diagnostics said;  // what there was to say of the network was said when it was built first
  auto program = flow::build_program(network, library->library, said);
  if (!program || program->layout_hash() != loaded.frame_layout() ||
      program->frame_size() != loaded.frame().size() || program->frame_size() > robot_wire::kMaxFrame)
    return std::unexpected("has built another program");
  hosted.frame_layout = program->layout_hash();
  hosted.frame_size = program->frame_size();
  hosted.codes = codes_of(network, *library);
  // What outputs of brought procedures are before they fire, their types' own constructors say.
  flow::Frame initial = program->make_frame();
  std::memcpy(initial.data(), loaded.frame().data(), initial.size());
  BuiltProgram out;
  out.program = kept(std::move(library), flow::with_initial_frame(*program, std::move(initial)));
  out.hosted = std::make_shared<const robot_host::HostedProgram>(std::move(hosted));
  return out;
}

}  // namespace

std::unique_ptr<DescribedLibrary> describe_library(ProcedureFiles files) {
  auto out = std::make_unique<DescribedLibrary>();
  out->library = component_library();
  for (const auto& tree : files) {
    const flow::Library& library = out->library;
    const cnl::Signatures& own = out->signatures.emplace_back(
        *tree, [&library](std::string_view name) { return library.find_type(name); });
    out->library.add(own.behaviors());
  }
  return out;
}

void check_code(ProcedureFiles files, const ProgramSources& sources, text::Diagnostics& sink) {
  for (const auto& tree : files) {
    if (!cnl::has_procedures(*tree)) continue;
    if (const auto wall = wall_to_compile(*tree, sources, sink, text::Severity::kWarning))
      cnl::check_native(*tree, native_options(sources, *wall), sink);
  }
}

std::unique_ptr<DescribedLibrary> checked_library_with(ProcedureFiles files, const ProgramSources& sources,
                                                       text::Diagnostics& sink) {
  if (sources.checks_code) check_code(files, sources, sink);
  return describe_library(files);
}

std::string runner_path() {
  namespace fs = std::filesystem;
  std::error_code failure;
  const fs::path folder = fs::read_symlink("/proc/self/exe", failure).parent_path();
  for (const fs::path& path : {folder / "mlab-robots", folder.parent_path() / "libexec/mlab/mlab-robots"}) {
    if (access(path.c_str(), X_OK) == 0) return path.string();
  }
  return "";
}

std::optional<BuiltProgram> host_network(const flow::Network& network, ProcedureFiles files,
                                         std::unique_ptr<DescribedLibrary> library, const text::Place& place,
                                         const ProgramSources& sources, text::Diagnostics& sink) {
  const auto refuse = [&](const std::string& why) -> std::optional<BuiltProgram> {
    const char* const what = files.empty() ? "robots of this program can't have processes of their own"
                                           : "the procedures that are brought along can't run";
    sink.error("cannot-load", place, fmt::format("{}: {}", what, why));
    return std::nullopt;
  };
  robot_host::HostedProgram hosted;
  const auto wall = wall_to_run(files, sources);
  if (!wall) {
    sink.error("code-not-allowed", place, wall.error());
    return std::nullopt;
  }
  hosted.load = compiled(network, files, sources, sink);
  if (!hosted.load) return std::nullopt;
  const std::string runner = sources.runner.empty() ? runner_path() : sources.runner;
  if (runner.empty()) return refuse("`mlab-robots` is not beside this program");
  hosted.is_for_one_robot = sources.in_own_processes;
  hosted.limits = sources.limits;
  hosted.limits.ends = sources.ends;
  hosted.launch = robot_host::launch_of(runner, *wall, hosted.limits);
  for (const std::string& file : hosted.load->libraries()) hosted.launch.policy.readable.push_back(file);
  const auto started = robot_host::start_hosted(hosted, nullptr);
  if (!started) return refuse(fmt::format("the process that loads them {}", started.error()));
  auto out = mirrored(network, std::move(library), started->loaded, std::move(hosted));
  if (!out) return refuse(fmt::format("their process {}", out.error()));
  return std::move(*out);
}

std::expected<BuiltProgram, std::string> host_revealed(const wire::Revealed& revealed,
                                                       robot_host::HostedProgram hosted) {
  std::vector<std::shared_ptr<const cnl::Tree>> files;
  text::Diagnostics said;
  for (const wire::Declarations& one : revealed.procedures()) {
    const auto source = std::make_shared<const text::Source>(one.file(), one.text());
    files.push_back(std::make_shared<const cnl::Tree>(cnl::parse(source, said)));
    cnl::check_declarations(*files.back(), said);
  }
  if (said.has_errors())
    return std::unexpected(fmt::format("reveals procedures that are none: {}", said.items()[0].message));
  return mirrored(robot_wire::decode(revealed.network()), describe_library(files), revealed.loaded(),
                  std::move(hosted));
}

std::optional<BuiltProgram> make_runnable(std::shared_ptr<const flow::Program> program,
                                          const flow::Network& network, ProcedureFiles files,
                                          std::unique_ptr<DescribedLibrary> library, const text::Place& place,
                                          const ProgramSources& sources, text::Diagnostics& sink) {
  const std::vector<std::string> codes = codes_of(network, *library);
  const bool brings_none = std::ranges::all_of(codes, &std::string::empty);
  if (sources.permission.is_to_run()) {
    if (!brings_none) return host_network(network, files, std::move(library), place, sources, sink);
    if (sources.in_own_processes)
      return host_network(network, {}, describe_library({}), place, sources, sink);
  }
  if (!sources.permission.is_to_run() && sources.checks_code) check_code(files, sources, sink);
  BuiltProgram out;
  out.program = brings_none && library->signatures.empty() ? std::move(program)
                                                           : kept(std::move(library), std::move(program));
  out.is_described_only = !brings_none;
  return out;
}

}  // namespace mlab::robot
