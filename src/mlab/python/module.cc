#include "mlab/python/bindings.h"

#include <dlfcn.h>

#include <filesystem>

#include "mlab/cli/commands.h"
#include "mlab/cli/permission.h"
#include "mlab/cli/places.h"
#include "mlab/cli/version.h"

namespace mlab::python {
namespace {

namespace fs = std::filesystem;

py::dict problem_of(const text::Diagnostic& one) {
  using namespace pybind11::literals;
  const text::SourcePtr& source = one.place.source;
  const text::LineColumn at =
      source ? source->line_column(one.place.span.begin) : text::LineColumn{.line = 0, .column = 0};
  return py::dict("file"_a = source ? py::cast(source->name()) : py::none(), "line"_a = at.line,
                  "column"_a = at.column, "severity"_a = std::string(text::name(one.severity)),
                  "kind"_a = one.kind, "message"_a = one.message, "hints"_a = one.hints,
                  "text"_a = text::render(one));
}

[[noreturn]] void raise_all(const py::list& problems) {
  py::module_::import("mlab._errors").attr("raise_error")(problems);
  throw std::logic_error("mlab._errors.raise_error has raised nothing");
}

// Where the module lies, in a build folder or an installation, what belongs to it is not far.
std::string prefix_of_module() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&prefix_of_module), &info) == 0) return "";
  std::error_code failure;
  fs::path folder = fs::canonical(info.dli_fname, failure).parent_path();
  for (; folder.has_relative_path(); folder = folder.parent_path()) {
    for (const char* const program : {"bin/mlab-robots", "libexec/mlab/mlab-robots", "bin/mlab"}) {
      if (fs::exists(folder / program, failure)) return folder.string();
    }
  }
  return "";
}

}  // namespace

void raise(const text::Diagnostics& problems) {
  raise_all(said_of(problems));
}

void raise(const text::Diagnostic& problem) {
  text::Diagnostics sink;
  sink.report(problem);
  raise(sink);
}

void raise(const std::string& sentence) {
  text::Diagnostic problem;
  problem.message = sentence;
  raise(problem);
}

py::list said_of(const text::Diagnostics& sink) {
  py::list out;
  for (const text::Diagnostic& one : sink.items()) out.append(problem_of(one));
  return out;
}

cell::Permission permission_for(const std::string& path, bool allows_native, bool has_cell) {
  cli::RunOptions options;
  options.allow_native = allows_native;
  options.no_cell = !has_cell;
  return cli::permission_to_run(options, cell::Grounds::People::kHere, fs::path(path).parent_path().string());
}

PYBIND11_MODULE(_core, module) {
  module.doc() = "The compiled half of mlab; what is documented, and to be used, is in `mlab` itself.";
  module.attr("version") = cli::kVersion;
  const std::string prefix = prefix_of_module();
  cli::set_prefix(prefix);
  module.attr("prefix") = prefix;
  module.attr("source") = fs::path(MLAB_SOURCE_INCLUDE).parent_path().string();
  bind_missions(module);
  bind_batches(module);
  bind_stages(module);
}

}  // namespace mlab::python
