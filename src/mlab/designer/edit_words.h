#pragma once

#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "mlab/designer.pb.h"
#include "mlab/designer/workspace.h"
#include "mlab/lang/cdl/walk.h"

namespace mlab::designer {

/// Other words in place of some of the words of a text.
struct Swap {
  text::Span span;
  std::string by;
};

/// An expression's words, with some of them swapped.
Fragment swapped(const Workspace& work, text::Span span, std::vector<Swap> swaps);
std::string swapped(std::string_view text, text::Span span, std::vector<Swap> swaps);

/// @param visit  a Name and the expression that it is
void for_each_name(const cdl::Expression& expression, const auto& visit) {
  cdl::for_each_expression(expression, [&](const cdl::Expression& one) {
    if (const auto* name = std::get_if<cdl::Name>(&one.what)) visit(*name, one);
  });
}

/// `Noise`, `Noise_2`: one that is not taken.
std::string unique(const std::string& wanted, const std::set<std::string>& taken);

using Places = google::protobuf::RepeatedPtrField<Arrange::At>;

/// Where a node stands; null: nobody said so.
const Arrange::At* place_of(const Places& places, std::string_view node);

/// A path below another one, without that.
std::string below(std::string_view path, std::string_view whole);

}  // namespace mlab::designer
