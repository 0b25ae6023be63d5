#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "mlab/text/files.h"
#include "mlab/text/source.h"

namespace mlab::designer {

/// A test of a component as it stands in its file.
struct WrittenTest {
  std::string name;
  std::string component;   ///< what is tested, in its author's words, on one line
  text::Place place;       ///< of its name
  text::Place declared;    ///< of the first assemblage that it tests; nowhere: it tests none
  std::string assemblage;  ///< its name
};

/// A file with tests. Does not change.
struct TestFile {
  text::SourcePtr source;
  std::vector<WrittenTest> tests;
  std::set<std::string> used;  ///< names of the sources that it is made of, its own among them
  std::uint64_t seal = 0;      ///< another one as soon as one of these says something else
  bool brings_code = false;    ///< C++ has to be compiled and started for its tests
};

/// Nothing where the text has no tests. What else is wrong with it does not matter. For any thread.
std::optional<TestFile> test_file_of(const text::SourcePtr& source, const text::Files& files);

}  // namespace mlab::designer
