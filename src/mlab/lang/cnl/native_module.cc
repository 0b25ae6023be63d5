#include "mlab/lang/cnl/native_module.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include <fmt/core.h>

#include "mlab/base/hash.h"
#include "mlab/cell/keep_first.h"
#include "mlab/flow/module.h"
#include "mlab/lang/cnl/compile_folder.h"
#include "mlab/lang/cnl/compiler_flags.h"
#include "mlab/lang/cnl/compiler_messages.h"
#include "mlab/lang/cnl/generate.h"

namespace mlab::cnl {
namespace {

namespace fs = std::filesystem;

std::string cache_folder(const NativeOptions& options) {
  return options.cache_folder.empty() ? default_cache_folder() : options.cache_folder;
}

// Size and time of change: enough to see that a file is another one.
std::string state_of(const std::string& path) {
  std::error_code failure;
  const auto size = fs::file_size(path, failure);
  if (failure) return path + " is gone";
  const auto time = fs::last_write_time(path, failure).time_since_epoch().count();
  return fmt::format("{} {} {}", path, size, time);
}

std::uint64_t hash_of(const std::vector<std::string>& parts) {
  std::uint64_t h = base::hash_text("");
  for (const std::string& part : parts) h = base::combine_bits(h, base::hash_text(part));
  return h;
}

std::string read_text(const std::string& path) {
  const std::ifstream file(path, std::ios::binary);
  std::ostringstream out;
  out << file.rdbuf();
  return out.str();
}

/// One file's procedures on their way through the compiler.
class NativeBuild {
 public:
  NativeBuild(const Tree& tree, const NativeOptions& options, text::Diagnostics& diagnostics)
      : tree_(tree), options_(options), diagnostics_(diagnostics), folder_(cache_folder(options)) {
    const std::string text_name = stem_of(tree.source->name()) + ".cnl.cc";
    text_ = generate(tree, {text_name, true});
    flags_ = procedure_flags();
    flags_.insert(flags_.end(), {"-fPIC", "-fvisibility=hidden"});
    std::error_code failure;
    beside_ = fs::absolute(fs::path(tree.source->name()), failure).parent_path().string();
    if (options.project != ProjectPart::kNone) flags_.push_back("-iquote" + beside_);
    for (const std::string& folder : options.include_folders) flags_.push_back("-I" + folder);
    std::vector<std::string> parts = flags_;
    parts.push_back(text_);
    parts.push_back(options.version);
    parts.push_back(fmt::format("{}", flow::module_layout()));
    parts.push_back(state_of(find_program(options.compiler)));
    key_ = fmt::format("{}-{:016x}", stem_of(tree.source->name()), hash_of(parts));
  }

  bool check() {
    const std::optional<std::string> text_file = write_text();
    const bool accepted = text_file && run_compiler({"-fsyntax-only", *text_file});
    remove_own();
    return accepted;
  }

  std::optional<NativeModule> compiled() {
    NativeModule module;
    module.file = library_path();
    if (module.file.empty() || !fs::exists(module.file)) {
      if (!compile()) return std::nullopt;
      module.file = library_path();
      module.was_compiled = true;
    } else {
      report_compiler_messages(read_text(messages_of(module.file)), tree_, diagnostics_);
    }
    return module;
  }

 private:
  std::string in_folder(const std::string& name) const { return folder_ + "/" + name; }

  void remove_own() const {
    std::error_code ignored;
    fs::remove_all(own_, ignored);
  }

  std::optional<std::string> write_text() {
    own_ = make_compile_folder(folder_, key_);
    std::string path = own_ + "/text.cc";
    std::ofstream file(path, std::ios::binary);
    file << text_;
    file.close();
    if (file) return path;
    diagnostics_
        .error("cannot-write", {},
               fmt::format("cannot write `{}`, which is needed to compile procedures", path))
        .hints.emplace_back("set XDG_CACHE_HOME to a folder that can be written");
    return std::nullopt;
  }

  bool run_compiler(const std::vector<std::string>& last_words) {
    std::vector<std::string> words = {options_.compiler};
    words.insert(words.end(), flags_.begin(), flags_.end());
    words.insert(words.end(), last_words.begin(), last_words.end());
    CompilerFiles files{options_.include_folders, {}, options_.project};
    if (options_.project != ProjectPart::kNone) files.projects.push_back(beside_);
    CompilerRoom room{options_.wall, std::move(files), own_};
    const ProcessResult result = run_process(words, room, options_.limits);
    messages_ = result.output;
    const text::Place place{tree_.source, {0, 0}};
    switch (result.end) {
      case ProcessResult::End::kNotFound: {
        auto& diagnostic = diagnostics_.error(
            "no-compiler", place,
            fmt::format("procedures need a C++ compiler, and there is no `{}`", options_.compiler));
        diagnostic.hints.emplace_back("on Debian: apt-get install g++");
        return false;
      }
      case ProcessResult::End::kTimedOut:
        diagnostics_.error("compiler-limit", place,
                           fmt::format("the C++ compiler took longer than {} s", options_.limits.time));
        return false;
      case ProcessResult::End::kStopped:
        diagnostics_.error("compiler-failed", place, "the C++ compiler was stopped, because `mlab` ends");
        return false;
      case ProcessResult::End::kFailed:
        diagnostics_.error("compiler-failed", place,
                           fmt::format("cannot start `{}`: {}", options_.compiler, result.output));
        return false;
      default:
        break;
    }
    const std::size_t errors = report_compiler_messages(result.output, tree_, diagnostics_);
    if (result.end == ProcessResult::End::kExited && result.status == 0) return true;
    if (errors == 0) report_failure(result, place);
    return false;
  }

  // It failed without a word about a line of code.
  void report_failure(const ProcessResult& result, const text::Place& place) {
    const auto says = [&](const char* words) { return result.output.find(words) != std::string::npos; };
    if (says("CPU time limit") ||
        (result.end == ProcessResult::End::kSignalled && result.status == SIGXCPU)) {
      diagnostics_.error(
          "compiler-limit", place,
          fmt::format("the C++ compiler needed more than {} s", options_.limits.processor_time));
      return;
    }
    if (says("out of memory") || says("memory exhausted") || says("Killed")) {
      diagnostics_.error(
          "compiler-limit", place,
          fmt::format("the C++ compiler needed more than {} MB", options_.limits.memory >> 20));
      return;
    }
    auto& diagnostic = diagnostics_.error("compiler-failed", place, "the C++ compiler failed");
    // The assembler and the linker say where first, and then what.
    const std::size_t what = result.output.find("Error: ");
    const std::size_t line = what == std::string::npos ? 0 : what;
    diagnostic.label = result.output.substr(line, result.output.find('\n', line) - line);
  }

  // The library's name ends with the state of everything it was made from; what that is, the first
  // compilation said.
  std::string library_path() const {
    std::istringstream words(read_text(in_folder(key_ + ".d")));
    std::vector<std::string> states;
    std::string word;
    while (words >> word) {
      if (word != "\\" && !word.ends_with(':')) states.push_back(state_of(word));
    }
    return states.empty() ? "" : in_folder(fmt::format("{}-{:016x}.so", key_, hash_of(states)));
  }

  // What the compiler warned of, for those who get the library from the cache: the same file is told the
  // same, whoever compiled it.
  static std::string messages_of(const std::string& library) { return library + ".txt"; }

  bool compile() {
    const std::optional<std::string> text_file = write_text();
    const bool done = text_file && compile(*text_file);
    remove_own();
    return done;
  }

  bool compile(const std::string& text_file) {
    const std::string library = own_ + "/code.so";
    const std::string dependencies = own_ + "/code.d";
    const bool accepted =
        run_compiler({"-shared", text_file, "-o", library, "-MMD", "-MF", dependencies, "-MT", "x"});
    bool done = accepted;
    if (accepted) {
      drop_own_text(dependencies, text_file);
      std::error_code failure;
      fs::rename(dependencies, in_folder(key_ + ".d"), failure);
      if (!failure && !messages_.empty())
        std::ofstream(messages_of(library_path()), std::ios::binary) << messages_;
      if (!failure) failure = cell::keep_first(library, library_path());
      done = !failure;
      if (failure)
        diagnostics_.error("cannot-write", {},
                           fmt::format("cannot write into `{}`: {}", folder_, failure.message()));
    }
    return done;
  }

  // The generated text is in the key already, and its file is about to go.
  static void drop_own_text(const std::string& dependencies, const std::string& text_file) {
    std::string text = read_text(dependencies);
    if (const std::size_t at = text.find(text_file); at != std::string::npos)
      text.erase(at, text_file.size());
    std::ofstream(dependencies, std::ios::binary) << text;
  }

  const Tree& tree_;
  const NativeOptions& options_;
  text::Diagnostics& diagnostics_;
  std::string folder_;
  std::string text_;
  std::vector<std::string> flags_;
  std::string key_;       ///< names what it is made from: text, compiler, version
  std::string messages_;  ///< what the compiler said last
  std::string own_;       ///< folder of this compilation
  std::string beside_;    ///< folder of the author's file
};

}  // namespace

std::string default_cache_folder() {
  // NOLINTBEGIN(concurrency-mt-unsafe): nobody sets them here
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache == '/')
    return std::string(cache) + "/mlab";
  if (const char* home = std::getenv("HOME"); home && *home == '/') return std::string(home) + "/.cache/mlab";
  // NOLINTEND(concurrency-mt-unsafe)
  std::error_code failure;
  return (fs::temp_directory_path(failure) / fmt::format("mlab-{}", getuid())).string();
}

bool has_procedures(const Tree& tree) {
  const std::vector<const Procedure*> all = items_of<Procedure>(tree);
  return std::ranges::any_of(all, [](const Procedure* p) { return !p->is_external; });
}

std::vector<text::SourcePtr> code_sources(const Tree& tree) {
  std::vector<text::SourcePtr> out = {tree.source};
  const auto add = [&](const text::SourcePtr& source) {
    if (source && std::ranges::find(out, source) == out.end()) out.push_back(source);
  };
  for (const Procedure* procedure : items_of<Procedure>(tree)) add(procedure->name.place.source);
  for (const Init* init : items_of<Init>(tree)) add(init->code.place.source);
  return out;
}

bool check_native(const Tree& tree, const NativeOptions& options, text::Diagnostics& diagnostics) {
  return !has_procedures(tree) || NativeBuild(tree, options, diagnostics).check();
}

std::optional<NativeModule> compile_native(const Tree& tree, const NativeOptions& options,
                                           text::Diagnostics& diagnostics) {
  if (!has_procedures(tree)) return NativeModule{};
  return NativeBuild(tree, options, diagnostics).compiled();
}

}  // namespace mlab::cnl
