#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "mlab/lang/odl/token.h"

namespace mlab::odl {

/// How a statement is put together after its keyword.
enum class Form {
  kName,     ///< a name
  kFile,     ///< a file, then numbers
  kValues,   ///< points and numbers
  kMoving,   ///< a point and numbers, perhaps ROUTE points SPEED number
  kNamed,    ///< a name, then points and numbers
  kSet,      ///< ZOOM-FACTOR, then a number
  kObject,   ///< a point, a number, a style, a color, perhaps ROUTE points SPEED number
  kHallway,  ///< a name, CENTERLINE points, WIDTH number, EXTENTS points
};

/// What the grammar says of one statement.
struct Rule {
  Keyword keyword = Keyword::kNone;
  Form form = Form::kName;
  std::size_t min_points = 0;
  std::size_t max_points = 0;
  std::size_t min_numbers = 0;  ///< that are no coordinates
  std::size_t max_numbers = 0;
  std::string_view number;  ///< what the first of these numbers is, for messages
  std::string usage;        ///< the whole statement, for messages
};

/// The rule of a keyword that starts a statement; one without usage for any other.
const Rule& rule_of(Keyword keyword);

}  // namespace mlab::odl
