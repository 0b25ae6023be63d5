#include "mlab/cell/bubblewrap.h"

#include <filesystem>
#include <system_error>

namespace mlab::cell {
namespace {

namespace fs = std::filesystem;

// Under the name that it goes by, and under the one that links lead to.
void bind(std::vector<std::string>& words, const char* how, const std::string& path) {
  std::error_code failure;
  const std::string real = fs::canonical(path, failure).string();
  if (failure) return;
  words.insert(words.end(), {how, real, real});
  if (const std::string named = fs::absolute(path, failure).lexically_normal().string(); named != real)
    words.insert(words.end(), {how, real, named});
}

}  // namespace

std::vector<std::string> bubblewrap_words(const std::string& bwrap, const Policy& policy, int filter) {
  std::vector<std::string> out = {bwrap, "--unshare-all", "--die-with-parent", "--cap-drop", "ALL"};
  for (const std::string& path : policy.readable) bind(out, "--ro-bind", path);
  for (const std::string& path : policy.executable) bind(out, "--ro-bind", path);
  for (const std::string& path : policy.writable) bind(out, "--bind", path);
  for (const char* word :
       {"--dev-bind", "/dev/null", "/dev/null", "--remount-ro", "/", "--chdir", "/", "--seccomp"}) {
    out.emplace_back(word);
  }
  out.push_back(std::to_string(filter));
  out.emplace_back("--");
  return out;
}

}  // namespace mlab::cell
