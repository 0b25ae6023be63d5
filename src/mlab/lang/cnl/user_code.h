#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/lang/cnl/tree.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cnl {

/// A token of C++. Comments, preprocessor lines and white space are none.
struct CppToken {
  enum class Kind : std::uint8_t { kWord, kNumber, kText, kPunctuation };
  Kind kind = Kind::kWord;
  std::string_view text;
  std::uint32_t offset = 0;  ///< in the source
};

/// Just enough of C++ to know which words stand in user code and which variables it declares.
class UserCode {
 public:
  explicit UserCode(const Code& code);

  const std::vector<CppToken>& tokens() const { return tokens_; }
  /// True where nothing but comments stands there.
  bool is_blank() const { return tokens_.empty() && !has_directives_; }
  /// True where the word stands there as a name of its own: not behind `.`, `->` or `::`.
  bool mentions(std::string_view word) const;
  text::Place place(const CppToken& token) const;

  /// A variable declared outside of any braces or parentheses: what a header or `once` section keeps.
  struct Variable {
    std::string name;
    text::Place place;
    bool is_pointer = false;        ///< pointer or reference, or something that is one inside (`std::span`)
    bool is_constant = false;       ///< `static constexpr`: no state
    bool holds_references = false;  ///< starts as a lambda that captures by reference
  };
  const std::vector<Variable>& variables() const { return variables_; }
  /// A type, alias or function declared outside of any braces; it ends with the section.
  struct LocalType {
    std::string word;  ///< `struct`, `using`, ...
    text::Place place;
  };
  const std::vector<LocalType>& local_types() const { return local_types_; }

  /// Says what does not balance, and which `static` variables it found.
  void check(text::Diagnostics& diagnostics) const;

 private:
  void cut();
  std::uint32_t skip_text(std::uint32_t at) const;
  std::uint32_t directive_end(std::uint32_t at) const;
  void check_balance(text::Diagnostics& diagnostics) const;
  void check_static(text::Diagnostics& diagnostics) const;
  std::size_t close_of(std::size_t open) const;
  void find_variables();
  void read_statement(std::size_t begin, std::size_t end);
  std::size_t read_type(std::size_t at, std::size_t end, bool& is_pointer) const;
  void read_declarators(std::size_t at, std::size_t end, const Variable& common);

  Code code_;
  std::string_view text_;
  std::vector<CppToken> tokens_;
  std::vector<std::size_t> closes_;  ///< per token: where the bracket that it opens closes, or its own index
  std::vector<Variable> variables_;
  std::vector<LocalType> local_types_;
  bool has_directives_ = false;
};

/// Words that C++ keeps for itself; no input can have them as its name.
bool is_cpp_keyword(std::string_view word);

}  // namespace mlab::cnl
