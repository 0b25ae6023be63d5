#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mlab/lang/cdl_historic/build.h"
#include "mlab/lang/cdl_historic/tree.h"

namespace mlab::cdl_historic {

/// What the historic system had and nothing here answers to: each becomes an empty assemblage that is
/// declared with the parameters it was used with, so that the rest of the configuration can be used.
class Holes {
 public:
  /// One argument at one use.
  struct HoleArgument {
    std::string name;
    Word constant;    ///< text of a constant; or else
    TypedDraft made;  ///< a value of its own
  };

  /// A call of the hole.
  /// @param declared_as  a free name for its declaration; used where this is its first use
  TypedDraft use(const std::string& historic, const std::string& result, std::vector<HoleArgument> given,
                 const text::Place& place, const std::string& declared_as);
  /// Whether `use` would find it declared.
  bool knows(const std::string& historic, const std::string& result,
             const std::vector<HoleArgument>& given) const;
  /// Why it is empty, for its documentation.
  void explain(const std::string& historic, std::string why) { reasons_[historic] = std::move(why); }

  /// The declarations, in the order of first use. Settles the types of all parameters: a constant that does
  /// not look the same at all uses becomes a text.
  std::vector<cdl::Assemblage> declarations();

 private:
  struct Parameter {
    std::string name;
    std::string type;                            ///< empty: by its constants
    std::vector<std::pair<Word, Draft>> values;  ///< constants, and the arguments that stand for them
  };
  struct Hole {
    std::string historic;
    std::string name;
    std::string result;
    std::vector<Parameter> parameters;
  };
  static std::string key(const std::string& historic, const std::string& result,
                         const std::vector<HoleArgument>& given);
  static void settle(Parameter& parameter, cdl::Assemblage& into);

  std::vector<Hole> holes_;
  std::map<std::string, std::size_t> by_key_;
  std::map<std::string, std::string> reasons_;
};

}  // namespace mlab::cdl_historic
