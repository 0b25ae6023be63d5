#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <stop_token>
#include <string>

#include "mlab/component_test/component_test.h"
#include "mlab/designer/drawing/model.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/text/files.h"

namespace mlab::designer {

/// A file's tests, ready to run.
struct LoadedFile {
  component_test::Tests tests;
  text::Diagnostics problems;
  /// Of the same text, for where a page runs in a test.
  std::unique_ptr<Model> model;
  std::map<std::string, cdl::Robot> robots;  ///< of tests that were asked for; `model` points at them

  /// Null where there is none of the name.
  const component_test::Test* find(const std::string& name) const;
};

/// Makes tests ready to run, and keeps those of some files, so that stepping through a test compiles nothing.
/// For one thread.
class LoadedTests {
 public:
  explicit LoadedTests(robot::ProgramSources programs) : programs_(std::move(programs)) {}

  /// Valid until the next call.
  /// @param seal  TestFile::seal
  LoadedFile& of(const text::SourcePtr& source, std::uint64_t seal, const text::Files& files,
                 const std::stop_token& ends);

 private:
  static constexpr std::size_t kMostKept = 8;

  const robot::ProgramSources programs_;
  struct CachedFile {
    std::uint64_t seal = 0;
    std::uint64_t used = 0;  ///< when it was asked for last
    std::unique_ptr<LoadedFile> file;
  };
  std::map<std::string, CachedFile> kept_;  // by the source's name
  std::uint64_t asked_ = 0;
};

}  // namespace mlab::designer
