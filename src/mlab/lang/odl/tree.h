#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mlab/lang/odl/token.h"
#include "mlab/overlay/overlay.h"
#include "mlab/text/source.h"

namespace mlab::odl {

struct NumberSyntax {
  double value = 0.0;  ///< may be infinite: the range is checked when the tree is applied
  text::Span span;
};

/// How a point is written.
enum class PointForm : std::uint8_t {
  kMetres,  ///< `x y`
  kUtm,     ///< `UTM LAT y LON x`, in degrees
  kGeo,     ///< `GEO "place"`
};
/// How many tokens that takes.
constexpr std::uint32_t token_count(PointForm form) {
  return form == PointForm::kUtm ? 5 : 2;
}

struct PointSyntax {
  NumberSyntax x;  ///< of GEO, only the span is meant, in x and y: the quoted place's
  NumberSyntax y;
  PointForm form = PointForm::kMetres;
  std::uint32_t first_token = 0;  ///< index into Tree::tokens
};

struct NameSyntax {
  std::string text;  ///< without quotes and final `*`
  bool has_star = false;
  text::Span span;
};

/// One statement, whatever its keyword: the parts that the keyword does not have are empty.
struct Statement {
  Keyword keyword = Keyword::kNone;  ///< kNone: a broken statement, of which only the tokens are kept
  text::Span span;
  std::uint32_t first_token = 0;  ///< half-open range of Tree::tokens
  std::uint32_t end_token = 0;
  NameSyntax name;  ///< also the file of LOAD-MAP, HEIGHTMAP, WAYPOINT-FILE; the color of OBJECT
  std::vector<PointSyntax> points;  ///< of HALLWAY: its extents; of ORIGIN: the one point
  std::vector<PointSyntax> centerline;
  std::vector<PointSyntax> route;     ///< of what can move; empty: it stands
  std::optional<NumberSyntax> speed;  ///< where it has a route
  std::vector<NumberSyntax> numbers;  ///< those that are not coordinates, in file order
  overlay::ObjectStyle style = overlay::ObjectStyle::kFixed;
};

/// One overlay file: everything that stands in it but white space and stray characters.
struct Tree {
  text::SourcePtr source;
  std::vector<Token> tokens;  ///< ends with kEnd, which holds the comments at the end of the file
  std::vector<Comment> comments;
  std::vector<Statement> statements;  ///< in file order; the header is one of them
};

}  // namespace mlab::odl
