#include "traces.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

#include "seen.h"

namespace mlab::network {
namespace {

namespace fs = std::filesystem;

}  // namespace

Traces::Traces(std::vector<fs::path> folders) : folders_(std::move(folders)), before_(look()) {}

std::vector<std::string> Traces::left() const {
  const std::set<std::string> now = look();
  std::vector<std::string> out;
  std::ranges::set_difference(now, before_, std::back_inserter(out));
  return out;
}

std::set<std::string> Traces::look() const {
  std::set<std::string> out;
  for (const Seen& one : children_of(::getpid())) out.insert(one.words());
  std::error_code failure;
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc/self/fd", failure)) {
    std::error_code gone;  // the one that this folder is read by
    const fs::path what = fs::read_symlink(entry.path(), gone);
    if (!gone && !what.string().starts_with("/proc/"))
      out.insert("open file " + entry.path().filename().string() + ": " + what.string());
  }
  for (const fs::path& folder : folders_) {
    for (fs::recursive_directory_iterator entry(folder, failure), end; !failure && entry != end;
         entry.increment(failure))
      out.insert("file " + entry->path().string());
  }
  return out;
}

}  // namespace mlab::network
