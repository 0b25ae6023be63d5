// mlab_tables [--check] SOURCE: writes what follows from the descriptor tables into the files of the source
// tree.

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "mlab/tables/regions.h"

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFolders[] = {"docs", "editors", "fuzz", "proto", "web"};
const std::set<std::string, std::less<>> kSkipped = {"node_modules", "generated", "dist", "pictures",
                                                     "seeds"};
const std::set<std::string, std::less<>> kEndings = {".md", ".json", ".txt", ".proto", ".ts", ".tsx"};

std::vector<fs::path> files_with_tables(const fs::path& root) {
  std::vector<fs::path> out;
  for (const std::string_view folder : kFolders) {
    auto each = fs::recursive_directory_iterator(root / folder);
    for (; each != fs::recursive_directory_iterator(); ++each) {
      if (each->is_directory() && kSkipped.contains(each->path().filename().string()))
        each.disable_recursion_pending();
      if (each->is_regular_file() && kEndings.contains(each->path().extension().string()))
        out.push_back(each->path());
    }
  }
  return out;
}

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

bool write(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  return file.good();
}

// The number of files that were not as they should be, or -1 after saying what can't be done.
int refresh(const fs::path& root, bool only_checks) {
  int stale = 0;
  for (const fs::path& path : files_with_tables(root)) {
    const std::string name = path.lexically_relative(root).string();
    const std::string text = content_of(path);
    const auto fresh = mlab::tables::refreshed(text, mlab::tables::all_regions());
    if (!fresh) {
      fmt::print(stderr, "{}:{}: error: {}\n", name, fresh.error().line, fresh.error().message);
      return -1;
    }
    if (*fresh == text) continue;
    ++stale;
    if (!only_checks && !write(path, *fresh)) {
      fmt::print(stderr, "{}: error: can't be written\n", name);
      return -1;
    }
    fmt::print("{} {}\n", name, only_checks ? "is not as the tables in C++ say" : "written");
  }
  return stale;
}

}  // namespace

int main(int count, char** words) {
  const std::vector<std::string_view> arguments(words + 1, words + count);
  const bool only_checks = !arguments.empty() && arguments[0] == "--check";
  if (arguments.size() != (only_checks ? 2U : 1U) || !fs::is_directory(arguments.back())) {
    fmt::print(stderr, "usage: mlab_tables [--check] SOURCE   (the folder with docs/, web/, ...)\n");
    return 2;
  }
  const int stale = refresh(fs::path(arguments.back()), only_checks);
  if (stale < 0) return 2;
  if (only_checks && stale > 0) fmt::print("`tools/tables` writes them anew\n");
  return only_checks && stale > 0 ? 1 : 0;
}
