#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "mlab/assist/component.h"
#include "mlab/assist/name.h"
#include "mlab/lang/cnl/lexer.h"
#include "mlab/text/source.h"

/// A network file as far as it is written: as cdl_scan.h.
namespace mlab::assist {

struct CnlState {
  std::string name;
  text::Span span;
};

/// A procedure, node, operator, parameter or type.
struct CnlDeclaration {
  std::string word;  ///< `node`, `procedure`, ...
  NameKind kind = NameKind::kNode;
  std::string name;
  text::Span span;
  text::Span whole;
  std::string of;  ///< the procedure of a node; the type of anything else
  std::string unit;
  std::vector<CnlState> states;
  std::vector<CnlState> inputs;  ///< of a procedure
};

struct CnlName {
  text::Span span;
  NameKind kind = NameKind::kNode;
  bool is_declaration = false;
  bool is_source = false;  ///< a node, a parameter or a word of the input's type
  std::string text;
  int declaration = -1;
  std::string input;  ///< that a source goes to
};

struct CnlWant {
  enum class Kind : std::uint8_t {
    kKeyword,
    kProcedure,
    kInput,
    kSource,
    kType,
    kState,
    kUnit,
    kCode,
    kRange
  };
  Kind kind = Kind::kKeyword;
  std::vector<std::string> words;
  std::string input;            ///< that a source goes to
  std::set<std::string> given;  ///< inputs that are linked already
};

struct CnlScan {
  text::SourcePtr source;
  std::vector<cnl::Comment> comments;
  std::vector<cnl::Token> tokens;  ///< those outside of C++, without names
  std::vector<CnlDeclaration> declarations;
  std::vector<CnlName> names;
  std::vector<text::Span> words;
  std::vector<text::Span> code;  ///< C++
  std::vector<CnlName> includes;
  std::vector<CnlWant> wants;  ///< where the text ends
  int open = -1;               ///< the declaration that the end stands in
};

CnlScan scan_cnl(const text::SourcePtr& source);

}  // namespace mlab::assist
