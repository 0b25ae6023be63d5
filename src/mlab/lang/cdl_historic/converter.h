#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mlab/lang/cdl_historic/build.h"
#include "mlab/lang/cdl_historic/holes.h"
#include "mlab/lang/cdl_historic/layout.h"
#include "mlab/lang/cdl_historic/library_names.h"
#include "mlab/lang/cdl_historic/scope.h"
#include "mlab/lang/cdl_historic/symbols.h"
#include "mlab/lang/cdl_historic/tree.h"
#include "mlab/lang/cdl_historic/vocabulary.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cdl_historic {

/// What is being written: an assemblage or robot, with what its parts share.
struct Unit {
  /// A part that several others read, to become a `let`.
  struct Shared {
    std::string name;
    TypedDraft made;
    std::vector<Draft> readers;
  };
  std::string name;
  std::vector<cdl::Let> lets;   ///< after `finish`
  std::vector<Shared> shared;   ///< in the order in which they can be declared
  std::set<std::string> names;  ///< of its nodes
  std::map<std::pair<const Expr*, const Level*>, std::size_t> shared_at;    ///< index in `shared`
  std::map<std::pair<const Expr*, std::string>, std::size_t> shared_alike;  ///< by fingerprint
};

/// Turns the expressions of a historic file into ours: resolves references and pushed-up parameters, pairs
/// list elements by position, finds our names, and leaves a declared hole where there is none. Assemblages
/// that it makes on the way (one for each state machine) are kept in order.
///
/// Each function takes the level in whose scope an expression stands, and the type that is wanted there,
/// which decides what a name is that nothing declares.
class Converter {
 public:
  /// @param tree, vocabulary  have to outlive this
  Converter(const Tree& tree, const Vocabulary& vocabulary, text::Diagnostics& sink);

  TypedDraft make(const Expr& expr, const Level* level, std::string_view wanted);
  /// What a setting's right-hand side gives. An empty draft where it says nothing.
  TypedDraft make_value(const Setting& setting, const Level* level, const Port& port,
                        const std::string& unit);
  /// The zero of a type: standing still, false, 0.
  TypedDraft nothing(std::string_view type, const text::Place& place);

  /// Writes into a unit until the matching `finish`, which takes out what only one part reads.
  void start(Unit& unit) { units_.push_back(&unit); }
  void finish(Unit& unit);
  /// An assemblage with this body becomes part of the result. @return its name; that of an earlier one that
  /// was made of the same place and says the same, where there is one
  std::string add_assemblage(cdl::Assemblage assemblage, std::vector<Node> nodes);
  /// A name for something at the top of the file that nothing else there or in the library has.
  std::string free_name(std::string_view wanted);
  /// How the next state machine without a name of its own is called.
  void suggest(std::string name) { suggested_ = std::move(name); }
  /// Everything that was looked at, so that what nobody needs can be found.
  void mark_used(const Expr* expr) { used_.insert(expr); }
  bool was_used(const Expr* expr) const { return used_.contains(expr); }

  /// The device that occupies a binding point; null where it is not bound.
  const Expr* bound_device(const Expr& binding_point) const;
  const Level* level(const Level* outer, const std::vector<Setting>& settings);

  const Tree& tree() const { return tree_; }
  const Symbols& symbols() const { return symbols_; }
  const Vocabulary& vocabulary() const { return vocabulary_; }
  text::Diagnostics& sink() { return sink_; }
  unsigned architecture() const { return architecture_; }
  /// The constant's text with the file's named values put in.
  Word with_names(const Word& constant) const;

  std::vector<cdl::Assemblage>& assemblages() { return assemblages_; }
  std::vector<Drawing>& drawings() { return drawings_; }
  Holes& holes() { return holes_; }
  void warn_once(std::string kind, const std::string& key, text::Place place, std::string message);

 private:
  TypedDraft make_bare(const Expr& expr, const Level* level, std::string_view wanted);
  TypedDraft make_members(const std::vector<Setting>& members, const Level* outer, std::string_view wanted,
                          const text::Place& place);
  TypedDraft make_reference(const Expr& expr, const Level* level, std::string_view wanted);
  TypedDraft make_shared(const Symbol& symbol, const Level* level, std::string_view wanted,
                         const text::Place& place);
  static TypedDraft read_shared(Unit& unit, std::size_t index, const text::Place& place);
  TypedDraft make_sensor(const Symbol& symbol, const Level* level, std::string_view wanted);
  TypedDraft make_instance(const Expr& expr, const Level* level, std::string_view wanted);
  TypedDraft make_library(std::string_view name, const Level* level, std::string_view wanted,
                          const text::Place& place);
  const Signature* library_signature(std::string_view name, const LibraryName* row) const;
  TypedDraft call_library(const Signature& ours, const LibraryName& row, const Level* level,
                          const text::Place& place);
  TypedDraft call_alike(const Signature& ours, const Level* level, const text::Place& place);
  TypedDraft make_call(const Expr& expr, const HistoricSignature& historic, const Level* own);
  TypedDraft make_list(const Expr& expr, const HistoricSignature& historic, const Port& port,
                       const Level* own);
  TypedDraft make_argument(const Expr& expr, const HistoricSignature& historic, const Port& port,
                           const Level* own);
  TypedDraft make_cooperation(const Expr& expr, const Level* own);
  TypedDraft make_logic(const Expr& expr, const Level* own);
  TypedDraft make_state_machine(const Expr& expr, const Level* own, std::string_view wanted);
  TypedDraft make_console_operator(const Expr& expr, const Level* own);
  TypedDraft make_blackboard(const Expr& expr, const Level* own);
  TypedDraft make_hole(const std::string& historic, const std::string& type,
                       std::vector<Holes::HoleArgument> given, const text::Place& place);
  TypedDraft make_instance_hole(const Expr& expr, const Level* own, std::string_view wanted);
  TypedDraft make_from(const BoundValue& found, const Port& port, const std::string& unit,
                       const text::Place& place);
  TypedDraft make_constant(const Word& constant, const Port& port, const std::string& unit);
  void keep_in_range(cdl::Number& number, const Port& port, const Word& said);
  TypedDraft fitting(TypedDraft made, std::string_view type, const text::Place& place);
  void name_node(const Expr& expr, TypedDraft& made);

  std::string operator_style(std::string_view name) const;
  const Definition* definition(std::string_view name) const;

  friend class StateMachine;

  const Tree& tree_;
  const Vocabulary& vocabulary_;
  text::Diagnostics& sink_;
  Symbols symbols_;
  unsigned architecture_ = 0;
  std::map<std::string, std::string, std::less<>> named_values_;
  Holes holes_;
  std::deque<Level> levels_;
  std::map<const std::vector<Setting>*, SettingsByName> settings_;
  std::vector<Unit*> units_;
  std::vector<cdl::Assemblage> assemblages_;
  std::map<std::string, std::string> assemblage_by_fingerprint_;
  std::vector<Drawing> drawings_;
  std::set<std::string, std::less<>> top_names_;
  std::set<const Expr*> used_;
  std::set<const Expr*> open_;  ///< named ones that are being made, to see one in itself
  std::set<std::string> warned_;
  std::string suggested_;
  int depth_ = 0;
  std::uint32_t made_ = 0;
  bool is_too_large_ = false;
};

}  // namespace mlab::cdl_historic
