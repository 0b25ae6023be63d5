#include "mlab/lang/cnl/compiler_room.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace mlab::cnl {
namespace {

namespace fs = std::filesystem;

// Where Linux has headers, libraries and the parts of compilers. Not all of /usr: other programs keep data
// there.
constexpr std::array kSystemFolders = {"/usr/include",
                                       "/usr/lib",
                                       "/usr/lib32",
                                       "/usr/lib64",
                                       "/usr/libx32",
                                       "/usr/libexec",
                                       "/usr/local/include",
                                       "/usr/local/lib",
                                       "/usr/local/lib64",
                                       "/usr/local/libexec",
                                       "/lib",
                                       "/lib32",
                                       "/lib64",
                                       "/libx32"};
constexpr std::array kSystemPrograms = {"/usr/bin", "/bin", "/usr/local/bin"};
constexpr std::array kSystemFiles = {"/etc/ld.so.cache", "/etc/alternatives"};

constexpr std::array kSourceEndings = {".h",   ".hh",  ".hpp", ".hxx", ".h++", ".inc", ".inl", ".ipp",
                                       ".tpp", ".def", ".cnl", ".c",   ".cc",  ".cpp", ".cxx"};

constexpr std::size_t kMostEntries = 10'000;

bool is_below(const fs::path& path, const fs::path& folder) {
  const auto [end, rest] = std::ranges::mismatch(folder, path);
  return end == folder.end();
}

bool holds_home(const fs::path& folder) {
  if (folder == folder.root_path()) return true;
  const char* home = std::getenv("HOME");  // NOLINT(concurrency-mt-unsafe): nothing sets variables
  std::error_code failure;
  return home != nullptr && *home == '/' && is_below(fs::weakly_canonical(home, failure), folder);
}

}  // namespace

bool is_source(std::string_view path) {
  const std::string ending = fs::path(path).extension().string();
  return std::ranges::find(kSourceEndings, ending) != kSourceEndings.end();
}

std::vector<std::string> project_files(const std::string& folder, ProjectPart part) {
  std::vector<std::string> out;
  std::error_code failure;
  const fs::path root = fs::canonical(folder.empty() ? fs::path(".") : fs::path(folder), failure);
  if (failure) return out;
  const bool is_home = holds_home(root);
  const bool only_sources = is_home || part == ProjectPart::kSources;
  fs::recursive_directory_iterator each(root, fs::directory_options::skip_permission_denied, failure);
  for (std::size_t seen = 0; !failure && each != fs::recursive_directory_iterator() && seen < kMostEntries;
       ++seen, each.increment(failure)) {
    std::error_code gone;
    const fs::path real = fs::canonical(each->path(), gone);
    const bool is_open = !gone && !each->path().filename().string().starts_with('.') && is_below(real, root);
    // Of a folder that is open as a whole nothing has to be named.
    if (!is_open || is_home || !only_sources) each.disable_recursion_pending();
    if (!is_open) continue;
    const bool is_file = fs::is_regular_file(real, gone);
    if (only_sources ? is_file && is_source(real.string()) : is_file || fs::is_directory(real, gone))
      out.push_back(real.string());
  }
  return out;
}

cell::Policy compiler_policy(const std::string& program, const CompilerFiles& files, const std::string& own) {
  cell::Policy out;
  out.readable.assign(kSystemFolders.begin(), kSystemFolders.end());
  out.readable.insert(out.readable.end(), kSystemFiles.begin(), kSystemFiles.end());
  out.readable.insert(out.readable.end(), files.folders.begin(), files.folders.end());
  for (const std::string& project : files.projects) {
    for (std::string& path : project_files(project, files.part)) out.readable.push_back(std::move(path));
  }
  out.executable.assign(kSystemFolders.begin(), kSystemFolders.end());
  out.executable.insert(out.executable.end(), kSystemPrograms.begin(), kSystemPrograms.end());
  // One from elsewhere has its parts beside it: /opt/gcc-13/bin/g++.
  std::error_code failure;
  const fs::path real = fs::canonical(program, failure);
  const fs::path folder = real.parent_path();
  if (!failure && std::ranges::find(kSystemPrograms, folder.string()) == kSystemPrograms.end()) {
    const bool has_prefix = folder.filename() == "bin" && !holds_home(folder.parent_path());
    out.executable.push_back(has_prefix ? folder.parent_path().string() : real.string());
  }
  out.writable = {own};
  out.may_start_processes = true;
  out.may_start_threads = true;
  out.open_files = 1024;
  return out;
}

}  // namespace mlab::cnl
