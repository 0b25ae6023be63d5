#pragma once

#include <string>
#include <string_view>

namespace mlab::overlay {

/// A background picture as browsers show it.
struct ShownPicture {
  std::string content_type;  ///< empty: it can't be shown
  std::string bytes;
};

/// The bytes of PNG, JPEG, GIF, WebP and BMP files as they are. PGM and PPM (`P2`, `P3`, `P5`, `P6`), which
/// browsers don't know, become BMP; pixels that are missing at the end of a file are black.
ShownPicture shown_picture(std::string bytes);

/// Why `shown_picture` could not show it, from the first bytes of the file (64 are enough for those without
/// comments).
///
/// @return  the end of a sentence that begins with the file's name; empty: it can
std::string why_not_shown(std::string_view first_bytes);

}  // namespace mlab::overlay
