#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mlab/designer.pb.h"
#include "mlab/designer/drawing/model.h"
#include "mlab/designer/edit/name_map.h"

namespace mlab::designer {

/// The way from a robot of a program down to where a page runs in it.
struct Hop {
  std::string page;  ///< empty: of no text that is edited here, so it stays as it is
  std::string node;
  std::string path;  ///< of the node's value, below what the page belongs to
};

/// The way to where a page runs; nothing: it runs nowhere there.
std::optional<std::vector<Hop>> way_to(const Model& model, std::string_view robot, const std::string& page,
                                       const std::string& place);

/// Probes and breakpoints of one document: they stay with what they were set on, whatever it is called.
class Marks {
 public:
  static constexpr std::size_t kMost = 300;

  /// @param mark   without an id
  /// @param model  of the document's text as it stands
  /// @param way    to `mark.place`; nothing: it is not known, and the place stays as it is
  /// @return  its id
  std::uint32_t add(Mark mark, std::shared_ptr<const Model> model, std::optional<std::vector<Hop>> way);
  bool remove(std::uint32_t id);
  bool is_empty() const { return all_.empty(); }
  std::size_t size() const { return all_.size(); }
  /// Follows them to the text as it stands now. True where something is otherwise.
  bool follow(const std::shared_ptr<const Model>& model);

  struct Run {
    std::string place;
    std::optional<std::vector<Hop>> way;
  };
  /// Another run has begun: what is marked on a page is from now on where that page runs in it.
  /// @param model  that the marks are of
  /// @param find   where a page runs now, the place that it had before it if there is a choice; nothing:
  /// nowhere, and the
  ///               marks wait where they are
  /// @return  true where something is otherwise
  bool move_to(
      const Model& model,
      const std::function<std::optional<Run>(const std::string& page, const std::string& place)>& find);
  void encode(::mlab::designer::MarkList& out) const;

  /// @param out  `document` stays as it is
  void encode(KeptMarks& out) const;
  /// What `encode` kept. The ids of its breakpoints were those of a simulator that has ended.
  /// @param model  of the text that was kept with them
  static Marks restored(const KeptMarks& kept, std::shared_ptr<const Model> model);

 private:
  struct KeptMark {
    Mark told;
    std::optional<std::vector<Hop>> way;
  };
  static bool follow(KeptMark& one, const NameMap& names, const Model& model);

  std::map<std::uint32_t, KeptMark> all_;
  std::shared_ptr<const Model> model_;  ///< that the names are of
  std::uint32_t last_ = 0;
};

}  // namespace mlab::designer
