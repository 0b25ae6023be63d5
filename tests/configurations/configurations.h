#pragma once

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "mlab/base/testing/source_folder.h"
#include "mlab/designer/edit/spread.h"
#include "mlab/lang/cdl_historic/import.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/text/diagnostic.h"
#include "mlab/text/testing/golden.h"

// All configurations that there are to be looked at, by names such as `missions/rover/ranger.cdl`.
namespace mlab::configurations {

inline const std::filesystem::path kSource = base::source_folder();

/// Historic configurations, which lie beside the project and may be missing.
inline std::filesystem::path corpus() {
  const char* named = std::getenv("MLAB_CORPUS");  // NOLINT(concurrency-mt-unsafe): nobody sets it here
  return (named != nullptr ? std::filesystem::path(named) : kSource / "../shared/corpus") / "configurations";
}
inline bool has_corpus() {
  return std::filesystem::is_directory(corpus());
}

using Visit = std::function<void(const text::SourcePtr& source, const std::string& name)>;

/// Those of the project, as they are written.
inline void for_each_own(const Visit& visit) {
  namespace fs = std::filesystem;
  const auto folder = [&](const fs::path& path) {
    for (const fs::path& file : text::testing::golden_files(path, ".cdl")) {
      const std::string text = text::testing::read_all(file);
      visit(std::make_shared<const text::Source>(file.filename().string(), text),
            fs::relative(file, kSource).string());
    }
  };
  for (const char* path : {"src/mlab/lang/cdl/testdata", "library/assemblages", "library/robots"})
    folder(kSource / path);
  for (const auto& entry : fs::directory_iterator(kSource / "missions")) {
    if (entry.is_directory()) folder(entry.path());
  }
}

/// Historic ones of a folder, imported and laid out.
/// @param name  stands in front of theirs
/// @param said  gets what the import said of each, with its text, by its name
inline void for_each_imported(
    const std::filesystem::path& folder, const std::string& name, const Visit& visit,
    const std::function<void(const std::string& name, const std::string& text)>& said = {}) {
  static const cdl_historic::Vocabulary kVocabulary(robot::component_library(),
                                                    robot::library_environment().built_in);
  for (const std::filesystem::path& path : text::testing::golden_files(folder, ".cdl")) {
    text::Diagnostics sink;
    const std::string file = path.filename().string();
    const auto historic = std::make_shared<const text::Source>(file, text::testing::read_all(path));
    const std::string text = designer::spread_out(cdl_historic::import_as_text(historic, kVocabulary, sink),
                                                  robot::library_environment());
    const std::string imported = name + "/" + file;
    if (said) said(imported, text::render(sink) + text);
    visit(std::make_shared<const text::Source>(file, text), imported);
  }
}

}  // namespace mlab::configurations
