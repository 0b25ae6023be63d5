#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mlab/designer/trial/marks.h"
#include "mlab/documents/state_folder.h"
#include "mlab/lang/cdl/configuration.h"

namespace mlab::designer {

/// Marks of the documents of one project, kept between sessions.
class MarkStore {
 public:
  /// @param folder   of the user's state; empty: nothing is kept
  /// @param project  where the project is on the machine
  MarkStore(const std::string& folder, std::string_view project) : folder_(folder, project) {}

  /// @return  why they could not be kept; empty: they are, and outlive this process
  std::string keep(const std::string& document, const Marks& marks) const;
  std::string drop(std::string_view document) const;
  /// Nothing: there are none, or they can't be read. Names are those of the text that they were kept with.
  std::optional<Marks> find(std::string_view document, const cdl::Environment& environment) const;

 private:
  documents::StateFolder folder_;
};

}  // namespace mlab::designer
