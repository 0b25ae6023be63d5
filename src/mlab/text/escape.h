#pragma once

#include <string>
#include <string_view>

namespace mlab::text {

/// A text as it stands in HTML and SVG, also between double quotes. Control characters, but for the end of a
/// line and the tab, become blanks.
std::string markup(std::string_view text);

/// A text as one field of comma-separated values (RFC 4180): as it is where that will do, else in double
/// quotes. What a spreadsheet would take for a formula, `=1+1`, has an apostrophe before it.
std::string csv_field(std::string_view text);

}  // namespace mlab::text
