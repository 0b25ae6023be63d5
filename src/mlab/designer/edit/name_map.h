#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mlab/designer/drawing/model.h"
#include "mlab/designer/edit/spans.h"
#include "mlab/designer/edit/workspace.h"

namespace mlab::designer {

/// What pages, nodes and states of a text are called in a later one, however it came about: by changes of the
/// drawing, typing, undoing, or because the file on disk is another. What stands for something is known by
/// its words, which are found again by comparing both texts.
class NameMap {
 public:
  NameMap(std::shared_ptr<const Model> before, std::shared_ptr<const Model> after);

  /// The page's path now; nothing: it has gone.
  std::optional<std::string> page(const std::string& path) const;
  /// The name now of a node or state of a page (its path before).
  std::optional<std::string> node(const std::string& page, const std::string& name) const;

 private:
  enum class Match : std::uint8_t { kNone, kChanged, kSame };
  struct Went {
    std::uint32_t token = 0;
    Match match = Match::kNone;
  };
  void compare();
  /// @param least  how sure it has to be
  std::optional<Anchor> now(Anchor anchor, Match least) const;
  std::optional<std::string> page_by(const std::string& path, Match least) const;
  const std::map<std::string, Anchor>& anchors(const Model& model, const TokenMap& tokens,
                                               const std::string& page) const;

  std::shared_ptr<const Model> before_;
  std::shared_ptr<const Model> after_;
  TokenMap old_;
  TokenMap new_;
  std::vector<Went> went_;  ///< of each old token
  mutable std::map<std::pair<const Model*, std::string>, std::map<std::string, Anchor>> anchors_;
};

}  // namespace mlab::designer
