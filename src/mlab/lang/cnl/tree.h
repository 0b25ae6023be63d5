#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "mlab/flow/network.h"
#include "mlab/text/source.h"

namespace mlab::cnl {

/// A word as its author wrote it, and where. Empty text: it was not said.
struct Word {
  std::string text;
  text::Place place;
};

/// Lines of C++ that reach the compiler as they stand.
struct Code {
  text::Place place;

  std::string_view text() const { return place.source ? place.source->text(place.span) : std::string_view(); }
};

/// `[list] TYPE [unit] name [= constant] [in LOW .. HIGH];  ///< help`
struct InputDecl {
  bool is_list = false;
  Word type;
  Word unit;
  Word name;
  std::optional<flow::Source> initial;  ///< a constant; without one the input has to be linked
  std::optional<double> low;
  std::optional<double> high;
  text::Place range_place;
  std::string help;
};

/// One entry in the parentheses of an alias: `HIST [unit] = input`, or `HIST = none`.
struct AliasPort {
  Word name;
  Word unit;
  Word input;  ///< `none`: accepted and ignored
};

struct AliasDecl {
  Word name;
  Word output_unit;
  std::vector<AliasPort> ports;
};

/// `senses DEVICE within WHAT`
struct NeedDecl {
  Word sensor;
  Word range;  ///< number or input; empty where the sensor has its own
};

struct Procedure {
  bool is_external = false;   ///< only its signature; it is compiled elsewhere
  bool is_new_style = false;  ///< `nprocedure`
  Word output_type;           ///< `void`: a sink
  Word output_unit;
  Word name;
  std::string help;
  std::string source;  ///< of the formula
  bool is_pure = false;
  Word pure;  ///< the word, for messages
  std::optional<int> latency;
  std::vector<NeedDecl> needs;
  std::vector<AliasDecl> aliases;
  std::vector<InputDecl> inputs;
  std::optional<Code> once;
  std::optional<Code> header;
  std::optional<Code> body;

  bool is_sink() const { return output_type.text == "void"; }
};

/// `init ... iend`: C++ at file scope.
struct Init {
  Code code;
};

/// `type <NAME, "format">;`
struct TypeDecl {
  Word name;
  std::string format;  ///< historic; means nothing here
};

/// `modulename = NAME;` or `module NAME;`
struct ModuleDecl {
  Word name;
  bool is_own = false;
};

struct Tree;

/// `#include "file"`
struct Include {
  Word path;
  std::shared_ptr<const Tree> tree;  ///< null: not read (yet), could not be read, or had been read before
};

struct ParameterDecl {
  flow::Parameter parameter;
};

/// `node`, `sequence`, `select` and `delay`.
struct NodeDecl {
  flow::Node node;
  bool is_public = false;
  Word remote_module;  ///< of a `remote node`
  std::string description;
};

using Item = std::variant<Include, Init, TypeDecl, ModuleDecl, Procedure, ParameterDecl, NodeDecl>;

/// One file, as it was written. After errors it has holes, never wrong parts.
struct Tree {
  text::SourcePtr source;
  std::vector<Item> items;
};

/// All items in the order in which they hold: those of an included file stand in the place of the `#include`.
template <class Visit>
void visit_items(const Tree& tree, const Visit& visit) {
  for (const Item& item : tree.items) {
    if (const auto* include = std::get_if<Include>(&item)) {
      if (include->tree) visit_items(*include->tree, visit);
    } else {
      visit(item);
    }
  }
}

/// The items of one kind, in order.
template <class Kind>
std::vector<const Kind*> items_of(const Tree& tree) {
  std::vector<const Kind*> out;
  visit_items(tree, [&](const Item& item) {
    if (const auto* one = std::get_if<Kind>(&item)) out.push_back(one);
  });
  return out;
}

}  // namespace mlab::cnl
