#include "mlab/designer/trial/compiler.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/configuration.h"
#include "mlab/lang/cdl/lower/lower.h"
#include "mlab/lang/cnl/native_module.h"
#include "mlab/robot/program/brought_code.h"
#include "mlab/robot/program/configuration_file.h"

namespace mlab::designer {
namespace {

constexpr std::size_t kMostMended = 20;        // problems for which mends are looked for
constexpr std::size_t kMostCheckedCodes = 32;  // that are remembered

/// What has no procedures of its own uses no C++. Otherwise all that the compiler would see.
std::string code_of(const cdl::Configuration& configuration, const text::Files& files) {
  const bool has_code = std::ranges::any_of(configuration.procedures,
                                            [](const auto& tree) { return cnl::has_procedures(*tree); });
  std::string out;
  if (!has_code) return out;
  for (const std::string& path : configuration.files) {
    if (path.ends_with(".cdl")) continue;
    const auto source = files.read(path);
    if (source) out += fmt::format("{} {}\n{}", path, (*source)->text().size(), (*source)->text());
  }
  return out;
}

}  // namespace

Compiler::Compiler(robot::ProgramSources programs, TakeCompiled found, TakeCode found_code)
    : programs_(std::move(programs)), found_(std::move(found)), found_code_(std::move(found_code)) {}

void Compiler::start(Task task) {
  const std::string document = task.document;
  configurations_.start(document, [this, task = std::move(task)](const LatestJobs::IsStale& is_stale) {
    compile(task, is_stale);
  });
}

robot::ProgramSources Compiler::programs_of(const Task& task, bool checks_code) const {
  robot::ProgramSources out = programs_;
  out.folder = std::filesystem::path(task.source->name()).parent_path().string();
  out.files = task.files.get();
  out.ends = ends_.get_token();
  out.checks_code = checks_code;
  return out;
}

void Compiler::compile(const Task& task, const LatestJobs::IsStale& is_stale) {
  const auto begin = std::chrono::steady_clock::now();
  cdl::Environment environment = robot::library_environment();
  environment.files = task.files.get();
  auto out = std::make_shared<Compiled>();
  out->source = task.source;
  const cdl::Configuration configuration = cdl::load(task.source, environment, out->problems);
  if (!out->problems.has_errors()) {
    const auto checked =
        robot::checked_library_with(configuration.procedures, programs_of(task, false), out->problems);
    cdl::check(configuration, checked->library, out->problems);
    out->code = code_of(configuration, *task.files);
  }
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
  out->took_ms = took.count();
  found_(task.document, out);
  if (!out->code.empty() && !is_stale()) {
    codes_.start(task.document,
                 [this, task, code = out->code](const LatestJobs::IsStale&) { check_code(task, code); });
  }

  auto mended = std::make_shared<Compiled>(*out);
  assist::Surroundings around;
  around.files = *task.files;
  around.programs = programs_of(task, false);
  around.checks_code = false;
  bool has_any = false;
  for (const text::Diagnostic& problem : mended->problems.items()) {
    if (mended->fixes.size() == kMostMended) break;
    if (is_stale()) return;
    mended->fixes.push_back(assist::fixes({task.source, assist::Language::kConfiguration}, problem, around));
    has_any = has_any || !mended->fixes.back().empty();
  }
  if (has_any) found_(task.document, mended);
}

void Compiler::check_code(const Task& task, const std::string& code) {
  std::shared_ptr<const CheckedCode> known;
  {
    const std::scoped_lock lock(mutex_);
    const auto found = checked_.find(code);
    if (found != checked_.end()) known = found->second;
  }
  if (!known) {
    auto made = std::make_shared<CheckedCode>();
    made->code = code;
    cdl::Environment environment = robot::library_environment();
    environment.files = task.files.get();
    text::Diagnostics said;
    const cdl::Configuration configuration = cdl::load(task.source, environment, said);
    robot::checked_library_with(configuration.procedures, programs_of(task, true), made->problems);
    known = made;
    const std::scoped_lock lock(mutex_);
    if (checked_.size() >= kMostCheckedCodes) checked_.clear();
    checked_[code] = made;
  }
  found_code_(task.document, known);
}

}  // namespace mlab::designer
