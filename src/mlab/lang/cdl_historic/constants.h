#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "mlab/lang/cdl_historic/build.h"
#include "mlab/lang/cdl_historic/tree.h"

namespace mlab::cdl_historic {

/// How many bytes a value of the type Text holds.
inline constexpr std::size_t kMaxTextBytes = 63;

/// What a constant of the historic language said in C++: `0.5`, `2 * (3.0)`, `M_PI / 2`. Nothing where it is
/// no arithmetic with numbers.
std::optional<double> evaluate(std::string_view text);

/// The text of a constant with the file's named values put in.
std::string with_named_values(std::string_view text,
                              const std::map<std::string, std::string, std::less<>>& named);

/// Text between the outermost quotes, escapes resolved. Nothing where there are no quotes.
std::optional<std::string> unquoted(std::string_view text);

/// What we call a class of objects that historic files name (`Mines`, `EOD_Areas`); empty: unknown.
std::string_view object_class(std::string_view historic);

/// A constant as an expression of a flow type.
///
/// @param unit  of numbers; empty: none
/// @return  null where the text means no value of that type
Draft constant(const Word& text, std::string_view type, const std::string& unit);

/// The flow type that a constant looks like: `double`, `Point`, `bool` or `Text`.
std::string_view type_of_constant(std::string_view text);

}  // namespace mlab::cdl_historic
