#pragma once

#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/designer.pb.h"
#include "mlab/lang/cdl/syntax/tree.h"
#include "mlab/lang/cdl/types/types.h"

// What edits put into a tree, and names for it.

namespace mlab::designer {

/// The name of a `let`, a parameter, a constant.
cdl::ExpressionPtr named(const std::string& name);
/// A component without arguments.
cdl::ExpressionPtr called(const std::string& component);
/// What words stand for that nobody typed: they are an expression.
cdl::ExpressionPtr value_of(const std::string& words);
/// What somebody typed; null where it can't stand as a value: it is not one expression and nothing behind it.
cdl::ExpressionPtr typed_value(const std::string& text);

/// Of a transition that waits for one: it is never made, which the checker marks.
cdl::ExpressionPtr no_trigger();

/// The same without a name, and without parentheses around it.
cdl::ExpressionPtr bare(const cdl::Expression& expression);
/// The same with a name, where it needs one to be called so.
cdl::ExpressionPtr bare_as(const cdl::Expression& expression, const std::string& name);
/// Whether a node of this name would be called so by itself: `Noise`, `Noise_2`.
bool is_own_name(std::string_view name, std::string_view base);

bool is_logic(const cdl::Expression& expression);
bool is_block(const cdl::Expression& expression);
/// Whether a node stands in it: it is more than a constant or a name.
bool has_node(const cdl::Expression& expression);
/// The call of a component, or of an operator; null: it is none.
const cdl::Call* call_of(const cdl::Expression& expression);
/// Null: it has none.
const std::vector<cdl::Member>* members_of(const cdl::Expression& expression);

/// Declarations written by a program.
std::vector<cdl::Item> items_of(const std::string& words);
/// A parameter's type as it is written: `length`, `double [kg]`.
std::string type_words(const cdl::PortType& type);
void set_type(cdl::Parameter& parameter, const cdl::PortType& type);

/// What means nothing where something has to stand: `false`, `Stand`, 0.
cdl::ExpressionPtr neutral_for(const cdl::PortType& type);
/// What a formula has in the place of what it read: 0 in its unit.
cdl::ExpressionPtr zero_for(const cdl::PortType& type);

bool is_cdl_name(std::string_view text);
/// `Noise`, `Noise_2`: one that is not taken.
std::string unique(const std::string& wanted, const std::set<std::string>& taken);

using Places = google::protobuf::RepeatedPtrField<Arrange::At>;
/// Where a node stands; null: nobody said so.
const Arrange::At* place_of(const Places& places, std::string_view node);
/// A path below another one, without that.
std::string below(std::string_view path, std::string_view whole);

}  // namespace mlab::designer
