#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mlab/designer.pb.h"
#include "mlab/designer/drawing/drawing.h"
#include "mlab/designer/drawing/graph.h"
#include "mlab/designer/drawing/model.h"

// Parts of drawings: what things look like, and the pages that are no dataflow.

namespace mlab::designer {

/// What the palette calls a formula that gives a truth value, and what it is until somebody types another.
inline constexpr const char* kComparison = "comparison";
inline constexpr const char* kComparisonWords = "0 < 1";

/// An operator as it is drawn and as Place names it.
struct OperatorShape {
  Node::Shape shape = Node::COOPERATION;
  std::string component;  ///< `compete by priority`, `coordinate by WeightedSum`, `not`
  std::string icon;
  std::string help;
};
/// Nothing where the expression is a call or a constant.
std::optional<OperatorShape> operator_of(const cdl::Expression& expression);

Node::Shape shape_of(const Callable& component);
std::string icon_of(const Callable& component);
/// The heading under which the palette has it.
std::string group_of(const Callable& component);
/// Whether it coordinates movements: a procedure with a list of vectors that gives one.
bool is_operator(const Callable& component);

/// The inputs that a node has, by name: of its component, or of the operator.
std::vector<Socket> sockets(const GraphNode& node, const Components& components, const OwnerGraph& graph);

/// An expression as its author wrote it.
std::string written(const cdl::Expression& expression);
void add_parameter(const cdl::Parameter& parameter, const Model& model, Drawing& drawing);
void draw_file(const Model& model, const DrawingContext& context, Drawing& out);
void draw_society(const Model& model, const cdl::Society& society, const DrawingContext& context,
                  Drawing& out);
void add_robot(const Model& model, const cdl::Robot& robot, const DrawingContext& context, Drawing& out);
/// The page of a class of robots, an operator of societies or a binding point of the text.
/// @return  whether something of the kind is called so
bool draw_equipment(const Model& model, const std::string& name, const DrawingContext& context, Drawing& out);

}  // namespace mlab::designer
