#pragma once

#include <cstdint>

#include "mlab/text/source.h"

namespace mlab::cdl_historic {

/// A word of the historic configuration language. Keywords are names: only where a statement may start does a
/// word count as one.
struct Token {
  enum class Kind : std::uint8_t {
    kName,         ///< `GoTo`, `Standby*`, `AuRA.urban`, and the file-local `$AN_12`
    kInline,       ///< a name with a colon right behind it: `brain:`
    kPushed,       ///< `%Goal_Location`
    kNumber,       ///< `-12.5`
    kDescription,  ///< `|The Wheels|`
    kInitializer,  ///< `{0.5}`: raw up to the first `}`
    kUp,           ///< `{^`
    kAdvancedUp,   ///< `{@^`
    kPair,         ///< `{&`
    kPunctuation,  ///< one of `( ) [ ] < > , ; = ^ }`
    kEnd
  };
  Kind kind = Kind::kEnd;
  text::Span span;      ///< all of it, brackets and bars too
  text::Span inner;     ///< what it says: without the colon, `%`, bars or braces
  bool spaced = false;  ///< white space or a comment stands before it
};

}  // namespace mlab::cdl_historic
