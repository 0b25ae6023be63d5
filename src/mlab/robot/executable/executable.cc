#include "mlab/robot/executable/executable.h"

#include <unistd.h>
#include <algorithm>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cnl/compiler_flags.h"
#include "mlab/lang/cnl/compiler_messages.h"
#include "mlab/lang/cnl/native_module.h"
#include "mlab/robot/executable/object_cache.h"
#include "mlab/text/shown.h"

namespace mlab::robot_build {
namespace {

namespace fs = std::filesystem;
using cnl::ProcessResult;

/// One executable on its way.
class ExecutableBuild {
 public:
  ExecutableBuild(const std::vector<CppFile>& files, const std::string& output, const Toolchain& toolchain,
                  const cell::Permission& permission, text::Diagnostics& sink,
                  const ProgressFunction& progress)
      : files_(files),
        output_(output),
        toolchain_(toolchain),
        permission_(permission),
        sink_(sink),
        progress_(progress),
        compiler_(cnl::find_program(toolchain.compiler)) {}

  std::optional<BuildReport> run() {
    if (!may_compile() || !has_all()) return std::nullopt;
    const std::string folder =
        (toolchain_.cache_folder.empty() ? cnl::default_cache_folder() : toolchain_.cache_folder) + "/robots";
    const ObjectCache cache(folder, compiler_, toolchain_.version, wall_, toolchain_.limits);
    compile_all(cache);
    BuildReport report;
    bool is_sound = true;
    for (std::size_t i = 0; i < files_.size(); ++i) {
      is_sound = judge(files_[i], objects_[i]) && is_sound;
      if (objects_[i].was_compiled)
        report.compiled.push_back(files_[i].name);
      else
        ++report.reused;
    }
    if (!is_sound || !link()) return std::nullopt;
    return report;
  }

 private:
  // All of it: the walls are the same for every file.
  bool may_compile() {
    for (const CppFile& file : files_) {
      std::vector<text::SourcePtr> sources;
      if (file.procedures) sources = cnl::code_sources(*file.procedures);
      // What we wrote ourselves out of a network has no code of others in it.
      for (std::size_t i = 0; i < std::max<std::size_t>(sources.size(), 1); ++i) {
        const auto wall = permission_.to_compile(sources.empty() ? file.text : sources[i]->text());
        if (!wall) {
          sink_.error("code-not-allowed", {}, wall.error());
          return false;
        }
        wall_ = *wall;
      }
    }
    return true;
  }

  bool has_all() {
    if (toolchain_.include_root.empty()) {
      sink_
          .error("no-headers", {},
                 "robot programs can't be compiled: the headers of missionlab are not there")
          .hints.emplace_back("install missionlab with its headers, or run it from its source tree");
      return false;
    }
    if (toolchain_.link_file.empty() || !read_link_file()) {
      sink_
          .error("no-libraries", {},
                 "robot programs can't be linked: the libraries of missionlab are not there")
          .hints.emplace_back("install missionlab with its libraries, or build it: ./mlab");
      return false;
    }
    if (compiler_.empty()) {
      sink_
          .error("no-compiler", {},
                 fmt::format("robot programs need a C++ compiler, and there is no `{}`", toolchain_.compiler))
          .hints = {"on Debian: apt-get install g++",
                    "a mission can name the configuration itself, which needs no compiler"};
      return false;
    }
    return true;
  }

  // A word in each line; what starts with `=` stands beside the file.
  bool read_link_file() {
    std::ifstream file(toolchain_.link_file);
    const fs::path folder = fs::path(toolchain_.link_file).parent_path();
    std::string line;
    while (std::getline(file, line)) {
      if (line.starts_with('=')) line = (folder / line.substr(1)).lexically_normal().string();
      if (line.ends_with(".a") && !line.starts_with('-') && !fs::exists(line)) return false;
      if (!line.empty()) link_words_.push_back(line);
    }
    return !link_words_.empty();
  }

  std::vector<std::string> flags_of(const CppFile& file) const {
    std::vector<std::string> flags = file.procedures ? cnl::procedure_flags() : cnl::compiler_flags();
    flags.push_back("-I" + toolchain_.include_root);
    if (file.procedures) {
      flags.push_back("-iquote" + folder_beside(file));
    } else {
      flags.emplace_back("-O1");  // it runs once
    }
    return flags;
  }

  // The author's own headers; empty: we wrote all of it.
  static std::string folder_beside(const CppFile& file) {
    if (!file.procedures) return "";
    std::error_code failure;
    return fs::absolute(fs::path(file.procedures->source->name()), failure).parent_path().string();
  }
  cnl::CompilerFiles files_for(const CppFile& file) const {
    cnl::CompilerFiles out{{toolchain_.include_root}, {}};
    if (file.procedures) out.projects.push_back(folder_beside(file));
    return out;
  }

  void compile_all(const ObjectCache& cache) {
    objects_.resize(files_.size());
    std::atomic<std::size_t> next{0};
    std::size_t done = 0;
    std::mutex mutex;
    const auto work = [&] {
      for (std::size_t i = next++; i < files_.size(); i = next++) {
        {
          const std::scoped_lock lock(mutex);
          if (progress_) progress_(done, files_.size() + 1, files_[i].name);
        }
        objects_[i] = cache.get(files_[i].name, files_[i].text, flags_of(files_[i]), files_for(files_[i]));
        const std::scoped_lock lock(mutex);
        ++done;
      }
    };
    const unsigned count = std::clamp(std::thread::hardware_concurrency(), 1U, 16U);
    std::vector<std::jthread> threads;
    for (unsigned n = 1; n < count; ++n) threads.emplace_back(work);
    work();
  }

  bool judge(const CppFile& file, const ObjectCache::Object& object) {
    if (!object.failure.empty()) {
      sink_.error("cannot-write", {}, object.failure)
          .hints.emplace_back("set XDG_CACHE_HOME to a folder that can be written");
      return false;
    }
    const std::size_t errors =
        file.procedures ? cnl::report_compiler_messages(object.compiler.output, *file.procedures, sink_) : 0;
    if (!object.path.empty()) return true;
    if (errors == 0) report_failure(object.compiler, "compile " + file.name + ".cc");
    return false;
  }

  void report_failure(const ProcessResult& result, const std::string& what) {
    if (result.end == ProcessResult::End::kTimedOut ||
        (result.end == ProcessResult::End::kSignalled && result.status == SIGXCPU)) {
      sink_.error("compiler-limit", {}, fmt::format("it takes the C++ compiler too long to {}", what));
      return;
    }
    std::string_view words = result.output;
    if (const std::size_t at = words.find("error"); at != std::string_view::npos)
      words = words.substr(words.rfind('\n', at) + 1);
    sink_.error("compiler-failed", {}, fmt::format("the C++ compiler can't {}", what)).label =
        text::shown(words.substr(0, words.find('\n')), 300);
  }

  // Under another name first, so that a program that runs is not written over.
  bool link() {
    if (progress_) progress_(files_.size(), files_.size() + 1, "linking");
    const std::string own = fmt::format("{}.{}.new", fs::absolute(output_).string(), getpid());
    const std::string fresh = own + "/program";
    std::error_code failure;
    fs::create_directory(own, failure);
    std::vector<std::string> words = {compiler_, "-o", fresh};
    if (!cnl::find_program("mold").empty()) words.emplace_back("-fuse-ld=mold");
    for (const ObjectCache::Object& object : objects_) words.push_back(object.path);
    words.insert(words.end(), link_words_.begin(), link_words_.end());
    const ProcessResult result = cnl::run_process(words, {wall_, {link_files(), {}}, own}, toolchain_.limits);
    const bool is_linked = result.end == ProcessResult::End::kExited && result.status == 0;
    if (is_linked) publish(fresh, failure);
    std::error_code ignored;
    fs::remove_all(own, ignored);
    if (failure)
      sink_.error("cannot-write", {}, fmt::format("cannot write `{}`: {}", output_, failure.message()));
    else if (!is_linked)
      report_failure(result, "link " + output_);
    return is_linked && !failure;
  }

  // The linker may not change modes; what it wrote gets the one of a new file that is a program, as the
  // folder did.
  void publish(const std::string& fresh, std::error_code& failure) const {
    const fs::perms mode = fs::status(fs::path(fresh).parent_path(), failure).permissions() & fs::perms::all;
    if (!failure) fs::permissions(fresh, mode, failure);
    if (!failure) fs::rename(fresh, output_, failure);
  }

  // Objects, and libraries by their path.
  std::vector<std::string> link_files() const {
    std::vector<std::string> out;
    for (const ObjectCache::Object& object : objects_) out.push_back(object.path);
    for (const std::string& word : link_words_) {
      if (word.starts_with('/')) out.push_back(word);
    }
    return out;
  }

  const std::vector<CppFile>& files_;
  const std::string& output_;
  const Toolchain& toolchain_;
  const cell::Permission& permission_;
  cell::Wall wall_ = cell::Wall::kLandlock;
  text::Diagnostics& sink_;
  const ProgressFunction& progress_;
  std::string compiler_;
  std::vector<std::string> link_words_;
  std::vector<ObjectCache::Object> objects_;
};

}  // namespace

std::optional<BuildReport> build_executable(const std::vector<CppFile>& files, const std::string& output,
                                            const Toolchain& toolchain, const cell::Permission& permission,
                                            text::Diagnostics& sink, const ProgressFunction& progress) {
  return ExecutableBuild(files, output, toolchain, permission, sink, progress).run();
}

}  // namespace mlab::robot_build
