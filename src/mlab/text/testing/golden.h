#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/text/diagnostic.h"

// Test inputs that hold their own expected output, in comments at their end:
//
//     PP a 1
//     -- EXPECTED
//     -- bad.odl:1:7: error: expected the y coordinate of a point, found the end of the file
//     [expected-number]
//
// With MLAB_UPDATE_GOLDEN=1 in the environment a test writes what it got into the files; read the difference
// before you commit it.
namespace mlab::text::testing {

/// The files of a folder with this extension (`.odl`), sorted.
inline std::vector<std::filesystem::path> golden_files(const std::filesystem::path& folder,
                                                       std::string_view extension) {
  std::vector<std::filesystem::path> out;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == extension) out.push_back(entry.path());
  }
  std::ranges::sort(out);
  return out;
}

inline std::string read_all(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Gives what the file says before its expectation to `answer`, under the file's bare name, and compares.
inline void check_golden(const std::filesystem::path& path, std::string_view comment,
                         const std::function<std::string(const SourcePtr&)>& answer) {
  const std::string all = read_all(path);
  const std::string mark = std::string(comment) + " EXPECTED\n";
  const std::size_t end = std::min(all.find(mark), all.size());
  const std::string got =
      answer(std::make_shared<const Source>(path.filename().string(), all.substr(0, end)));
  std::string block = mark;
  for (std::size_t at = 0; at < got.size();) {
    const std::size_t line_end = std::min(got.find('\n', at), got.size());
    const std::string line = got.substr(at, line_end - at);
    block += line.empty() ? std::string(comment) + "\n" : std::string(comment) + " " + line + "\n";
    at = line_end + 1;
  }
  if (std::getenv("MLAB_UPDATE_GOLDEN") != nullptr) {  // NOLINT(concurrency-mt-unsafe): nobody sets it here
    std::ofstream(path, std::ios::binary) << all.substr(0, end) << block;
    return;
  }
  EXPECT_EQ(all.substr(end), block) << path;
}

/// The kinds of diagnostics that the sources of a folder and of those in it can say: the first string of
/// every `error("...", ` and its like. A test compares them with the kinds that the golden files show, so
/// that none stays without one.
inline std::set<std::string> kinds_said_in(const std::filesystem::path& folder,
                                           const std::vector<std::string>& calls) {
  std::set<std::string> out;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::filesystem::path& path = entry.path();
    if (path.extension() != ".cc" || path.string().ends_with("_test.cc")) continue;
    const std::string text = read_all(path);
    for (const std::string& call : calls) {
      for (std::size_t at = text.find(call); at != std::string::npos; at = text.find(call, at + 1)) {
        const std::size_t quote = text.find_first_not_of(" \n", at + call.size());
        if (quote == std::string::npos || text[quote] != '"') continue;
        out.insert(text.substr(quote + 1, text.find('"', quote + 1) - quote - 1));
      }
    }
  }
  return out;
}

/// The kinds in the expectations of golden files: what stands in brackets at the end of a line.
inline std::set<std::string> kinds_expected_in(const std::vector<std::filesystem::path>& files) {
  std::set<std::string> out;
  for (const auto& path : files) {
    const std::string text = read_all(path);
    for (std::size_t at = text.find("]\n"); at != std::string::npos; at = text.find("]\n", at + 1)) {
      const std::size_t begin = text.rfind('[', at);
      if (begin != std::string::npos) out.insert(text.substr(begin + 1, at - begin - 1));
    }
  }
  return out;
}

}  // namespace mlab::text::testing
