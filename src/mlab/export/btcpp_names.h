#pragma once

#include <string>
#include <string_view>

namespace mlab::exports {

// What BehaviorTree.CPP 4 makes of names and texts. Its parser turns names that it keeps for itself down, or
// reads something else out of them.

/// A skill or trigger as the name of an element. One that is called as a node of the library itself gets a
/// `_` more, and so does one that would then be called alike.
std::string btcpp_skill(std::string_view name);

/// An input as the name of a port: `name` and `ID` are the element's own, and get a `_` more; names that
/// start with a `_` are the library's, and get `port` in front.
std::string btcpp_port(std::string_view name);

/// A name for the blackboard. Scripts read whatever starts with `true` or `false` as that.
std::string btcpp_key(std::string_view name);

/// Whether the value of a port is taken for a name on the blackboard.
bool btcpp_is_pointer(std::string_view text);

/// Whether a text can stand between single quotes in a script.
bool btcpp_fits_script(std::string_view text);

}  // namespace mlab::exports
