#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "mlab/lang/cnl/tree.h"

namespace mlab::cnl {

/// C++ text in the making, which knows its own line numbers: so that compilers speak of the author's file
/// within the author's code, and of this text everywhere else.
class CppWriter {
 public:
  explicit CppWriter(std::string name) : name_(std::move(name)) {}

  void line(std::string_view text);
  /// Lines of a user's code as they stand, at their lines and columns.
  void user_code(const Code& code);
  /// A piece of text that compilers see at this place of the author's file, on lines of its own.
  void at(const text::Place& place, std::string_view text);

  std::string text() && { return std::move(text_); }

 private:
  void append(std::string_view text);
  void here();

  std::string name_;
  std::string text_;
  std::uint32_t next_line_ = 1;
};

/// The text as a string literal of C++.
std::string cpp_string(std::string_view text);
/// The last part of a path.
std::string_view base_name(std::string_view path);

}  // namespace mlab::cnl
