#include "mlab/designer/component_tests/loaded_tests.h"

#include <algorithm>
#include <filesystem>

#include "mlab/robot/program/configuration_file.h"

namespace mlab::designer {

const component_test::Test* LoadedFile::find(const std::string& name) const {
  const auto found = std::ranges::find_if(
      tests.tests, [&](const component_test::Test& test) { return test.lowered.test->name.text == name; });
  return found == tests.tests.end() ? nullptr : &*found;
}

LoadedFile& LoadedTests::of(const text::SourcePtr& source, std::uint64_t seal, const text::Files& files,
                            const std::stop_token& ends) {
  CachedFile& kept = kept_[source->name()];
  kept.used = ++asked_;
  if (kept.file && kept.seal == seal) return *kept.file;
  robot::ProgramSources sources = programs_;
  sources.folder = std::filesystem::path(source->name()).parent_path().string();
  sources.files = &files;
  sources.ends = ends;
  kept.file = std::make_unique<LoadedFile>();
  LoadedFile& out = *kept.file;
  out.tests = component_test::load(source, sources, out.problems);
  cdl::Environment environment = robot::library_environment();
  environment.files = &files;
  out.model = std::make_unique<Model>(source, environment);
  // What was given up is not what the text says.
  kept.seal = ends.stop_requested() ? 0 : seal;
  if (kept_.size() > kMostKept)
    kept_.erase(std::ranges::min_element(kept_, {}, [](const auto& one) { return one.second.used; }));
  return out;
}

}  // namespace mlab::designer
