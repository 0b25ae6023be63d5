#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "mlab/lang/cdl/lower/node_names.h"
#include "mlab/lang/cdl/types/port_type.h"
#include "mlab/lang/cdl/types/types.h"
#include "mlab/text/source.h"

namespace mlab::cdl {

/// What an expression stands for.
struct Value {
  enum class Kind {
    kNone,    ///< it was wrong, and that was said
    kWire,    ///< the output of a node, or a parameter of the network
    kNumber,  ///< with `unit`
    kWord,    ///< a word of the type that is wanted
    kText,
    kList,
    kSink  ///< a node without an output
  };
  Kind kind = Kind::kNone;
  std::string text;  ///< name of the node or parameter, word, text
  double number = 0.0;
  std::string unit;  ///< kNumber: as written
  PortType type;     ///< kWire; a constant that came through a parameter has the parameter's
  /// kWire: the unit in which the network counts it; what came through a declaration has that one's in
  /// `type`.
  std::string counted_in;
  std::string named;     ///< the name by which it was asked for; empty: none
  text::Place declared;  ///< of that name
  std::vector<Value> items;
  text::Place place;                    ///< where the author wrote it: for a constant, where it was given
  const struct Scope* scope = nullptr;  ///< kWord: where it was looked up in vain
};

Value wire(const std::string& node, const PortType& type, const text::Place& place);
/// A number with its unit, as it is quoted in messages.
std::string quoted_number(const Value& value);
/// ` [m/s]`; nothing for no unit.
std::string bracketed(const std::string& unit);

/// Where a node goes.
struct Spot {
  std::string path;
  const NamesBelow* taken;  ///< what stands right below it already
};

/// Of what is only checked: nobody asks what its nodes are called.
inline const NodeNames kUnnamed;
/// Where nothing stands yet.
inline const NamesBelow kNothingBelow;

/// The names that expressions of one instance may use, and what the nodes are called that they make.
struct Scope {
  struct Named {
    Value value;
    const Parameter* parameter = nullptr;
    const Let* let = nullptr;
    enum class State { kReady, kWaiting, kOpen } state = State::kReady;
    bool was_promised = false;  ///< somebody took its wire before it was there
  };
  std::string path;                  ///< where the instance runs
  const NodeNames* nodes = nullptr;  ///< what its nodes are called below that
  std::map<std::string, Named, std::less<>> names;
  std::map<const Expression*, std::size_t> times;  ///< how often it was evaluated what is so repeatedly

  /// Their values are not asked for yet.
  void declare(const std::vector<Let>& lets);

  /// Where the node of the name stands, below the path.
  std::string path_of(const std::string& name) const { return joined_path(path, name); }
  /// What the nodes of an expression are called that is evaluated now.
  const NodeNames::Paths& paths_of(const Expression& expression);
  /// The node between an expression that was evaluated and who reads it.
  std::string path_behind(const Expression& expression) const;
  /// The node that counts in radians what an expression computes, and what its operand is.
  std::string angle_of(const Expression& expression) const;
  std::string angle_of_operand(const Expression& expression, std::size_t operand) const;

 private:
  /// Of an expression that was asked for already.
  const NodeNames::Paths& last_paths_of(const Expression& expression) const;
};

/// All scopes of one flattening. They stay where they are.
class Scopes {
 public:
  Scope& add() { return all_.emplace_back(); }

 private:
  std::deque<Scope> all_;
};

}  // namespace mlab::cdl
