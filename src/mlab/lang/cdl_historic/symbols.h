#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/lang/cdl_historic/tree.h"

namespace mlab::cdl_historic {

/// Something in a file that has a name.
struct Symbol {
  Word name;
  const Expr* expr = nullptr;
  const Instance* instance = nullptr;  ///< null: named inline
  Spot spot;
  mutable int uses = 0;  ///< references to it; counted once, when the symbols are made
};

/// The names of one file. The historic language looked names up in scopes, in the order of the text; here the
/// last one of a name in front of a reference is meant, wherever it stands, so that files with slips in them
/// can be read.
class Symbols {
 public:
  /// @param tree  has to outlive this
  explicit Symbols(const Tree& tree);

  /// What a reference at this byte of the file means; null where there is nothing of that name.
  const Symbol* find(std::string_view name, std::uint32_t at) const;
  /// What a reference means.
  const Symbol* find(const Word& reference) const { return find(reference.text, reference.place.span.begin); }
  const std::map<std::string, std::vector<Symbol>, std::less<>>& all() const { return symbols_; }

 private:
  void add(Symbol symbol);
  void walk(const Expr& expr, bool is_named);
  void walk(const std::vector<Setting>& settings);
  void count(const Expr& expr);
  void count(const std::vector<Setting>& settings);

  std::map<std::string, std::vector<Symbol>, std::less<>> symbols_;
};

}  // namespace mlab::cdl_historic
