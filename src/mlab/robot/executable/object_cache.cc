#include "mlab/robot/executable/object_cache.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "mlab/base/hash.h"
#include "mlab/cell/keep_first.h"
#include "mlab/lang/cnl/compile_folder.h"

namespace mlab::robot_build {
namespace {

namespace fs = std::filesystem;

// Size and time of change: enough to see that a file is another one.
std::string state_of(const std::string& path) {
  std::error_code failure;
  const auto size = fs::file_size(path, failure);
  if (failure) return path + " is gone";
  return fmt::format("{} {} {}", path, size, fs::last_write_time(path, failure).time_since_epoch().count());
}

std::string read_text(const std::string& path) {
  const std::ifstream file(path, std::ios::binary);
  std::ostringstream out;
  out << file.rdbuf();
  return out.str();
}

// The headers of a list of dependencies, as compilers write it.
std::vector<std::string> headers_of(const std::string& dependencies) {
  std::istringstream words(dependencies);
  std::vector<std::string> out;
  std::string word;
  while (words >> word) {
    if (word != "\\" && !word.ends_with(':')) out.push_back(word);
  }
  return out;
}

}  // namespace

ObjectCache::ObjectCache(std::string folder, std::string compiler, std::string version, cell::Wall wall,
                         cnl::ProcessLimits limits)
    : folder_(std::move(folder)),
      compiler_(std::move(compiler)),
      version_(std::move(version)),
      wall_(wall),
      limits_(std::move(limits)) {
  std::error_code ignored;  // what can't be written there is said where it is
  fs::create_directories(folder_, ignored);
}

// Ends with the state of all headers; which those are, the first compilation said.
std::string ObjectCache::path_of(const std::string& key) const {
  const std::vector<std::string> headers = headers_of(read_text(folder_ + "/" + key + ".d"));
  if (headers.empty()) return "";
  std::uint64_t h = base::hash_text("");
  for (const std::string& header : headers) h = base::combine_bits(h, base::hash_text(state_of(header)));
  return fmt::format("{}/{}-{:016x}.o", folder_, key, h);
}

// The text comes on its own, because its name would stand among the dependencies.
void ObjectCache::compile(const std::string& key, const std::string& text,
                          const std::vector<std::string>& flags, const cnl::CompilerFiles& readable,
                          Object& out) const {
  const std::string own = cnl::make_compile_folder(folder_, key);
  std::error_code failure;
  const std::string text_file = own + "/text.cc";
  const std::string object = own + "/code.o";
  const std::string dependencies = own + "/code.d";
  std::ofstream file(text_file, std::ios::binary);
  file << text;
  file.close();
  if (file) {
    std::vector<std::string> words = {compiler_};
    words.insert(words.end(), flags.begin(), flags.end());
    for (const char* word : {"-MMD", "-MT", "x", "-MF"}) words.emplace_back(word);
    words.insert(words.end(), {dependencies, "-c", text_file, "-o", object});
    out.compiler = cnl::run_process(words, {wall_, readable, own}, limits_);
    if (out.compiler.end == cnl::ProcessResult::End::kExited && out.compiler.status == 0) {
      std::string headers = read_text(dependencies);
      if (const std::size_t at = headers.find(text_file); at != std::string::npos)
        headers.erase(at, text_file.size());
      std::ofstream(dependencies, std::ios::binary | std::ios::trunc) << headers;
      fs::rename(dependencies, folder_ + "/" + key + ".d", failure);
      out.path = path_of(key);
      if (!out.compiler.output.empty())
        std::ofstream(out.path + ".txt", std::ios::binary) << out.compiler.output;
      if (!failure) failure = cell::keep_first(object, out.path);
      if (failure) out.failure = fmt::format("cannot write into `{}`: {}", folder_, failure.message());
    }
  } else {
    out.failure = fmt::format("cannot write `{}`", text_file);
  }
  fs::remove_all(own, failure);
}

ObjectCache::Object ObjectCache::get(const std::string& name, const std::string& text,
                                     const std::vector<std::string>& flags,
                                     const cnl::CompilerFiles& readable) const {
  std::uint64_t h = base::hash_text(text);
  for (const std::string& flag : flags) h = base::combine_bits(h, base::hash_text(flag));
  h = base::combine_bits(h, base::hash_text(version_));
  h = base::combine_bits(h, base::hash_text(state_of(compiler_)));
  const std::string key = fmt::format("{}-{:016x}", name, h);
  Object out;
  out.path = path_of(key);
  std::error_code failure;
  if (!out.path.empty() && fs::exists(out.path, failure)) {
    out.compiler.output = read_text(out.path + ".txt");
    return out;
  }
  out.was_compiled = true;
  out.path.clear();
  compile(key, text, flags, readable, out);
  return out;
}

}  // namespace mlab::robot_build
