#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mlab::project {

/// Texts of the component library, by the names that people open them by: `library:assemblages/wander.cdl`.
inline constexpr std::string_view kLibrary = "library:";

/// Nothing where there is none of that name.
std::optional<std::string_view> library_text(std::string_view path);
/// The name of the text that a source is, by how messages name it (`library/assemblages/wander.cdl`); empty
/// where it is none.
std::string library_path(std::string_view source_name);
/// The other way around. @param path  of a text of the library
std::string library_source_name(std::string_view path);

}  // namespace mlab::project
