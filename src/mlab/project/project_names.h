#pragma once

#include <cstdint>
#include <expected>
#include <functional>
#include <string>

#include "mlab/assist/service.h"
#include "mlab/names.pb.h"
#include "mlab/project/project_renaming.h"
#include "mlab/project/project_texts.h"

namespace mlab::project {

/// Why a question about a name has no answer.
struct NoAnswer {
  std::string why;   ///< a sentence, with file and line of what is in the way
  std::string path;  ///< as ProjectTexts::path_of, of what is in the way; empty: nothing in a text
  text::Span span = {0, 0};
};
template <class Value>
using Answer = std::expected<Value, NoAnswer>;

/// Where things are declared and used in a project, and other names for them: for browsers, as messages. Has
/// no thread.
class ProjectNames {
 public:
  /// @param can_show  whether the page shows a file of this path
  ProjectNames(ProjectTexts& texts, std::function<bool(const std::string& path)> can_show);

  /// Where what is named there is declared.
  Answer<text::Place> definition(const assist::Text& text, std::uint32_t cursor);
  names::TextPlace place_message(const text::Place& place) const;
  Answer<names::UseList> uses(const assist::Text& text, std::uint32_t cursor);
  /// What another name would change. Was tried.
  Answer<names::Plan> plan(const assist::Text& text, std::uint32_t cursor, const std::string& name);
  /// Does it, where `seal` is that of the plan as it would be now.
  Answer<names::Plan> rename(const assist::Text& text, std::uint32_t cursor, const std::string& name,
                             const std::string& seal, double now);
  /// As ProjectRenaming.
  Answer<bool> take_back(double now);

 private:
  struct Planned {
    assist::Renaming renaming;
    names::Plan message;
  };
  Answer<Planned> planned(const assist::Text& text, std::uint32_t cursor, const std::string& name);
  std::string path_of(const text::SourcePtr& source) const;
  names::File& file_message(const text::SourcePtr& source,
                            google::protobuf::RepeatedPtrField<names::File>& files);
  NoAnswer refused(const assist::Refusal& refusal) const;
  void add_notes(assist::Renaming& renaming, names::Plan& plan) const;

  ProjectTexts& texts_;
  ProjectRenaming renaming_;
  const std::function<bool(const std::string& path)> can_show_;
};

}  // namespace mlab::project
