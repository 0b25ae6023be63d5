// What the C++ of procedures says of their inputs.

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include "mlab/assist/cnl_scan.h"
#include "mlab/assist/languages.h"

namespace mlab::assist {
namespace {

bool is_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Goes through C++ from word to word, past comments, texts and numbers.
class CodeWords {
 public:
  CodeWords(std::string_view all, text::Span code) : all_(all.substr(0, code.end)), at_(code.begin) {}

  /// @return  false behind the last one
  bool next() {
    while (at_ < all_.size()) {
      const char c = all_[at_];
      if (is_at("//")) {
        leave("\n");
      } else if (is_at("/*")) {
        leave("*/");
      } else if (c == '"' || c == '\'') {
        leave_quoted(c);
      } else if (is_of_word(c)) {
        const auto begin = static_cast<std::uint32_t>(at_);
        while (at_ < all_.size() && is_of_word(all_[at_])) ++at_;
        word_ = {begin, static_cast<std::uint32_t>(at_)};
        is_member_ = std::exchange(follows_access_, false);
        return true;
      } else {
        if (c != ' ' && c != '\t' && c != '\n') follows_access_ = c == '.' || is_at("->") || is_at("::");
        at_ += is_at("->") || is_at("::") ? 2 : 1;
      }
    }
    return false;
  }

  text::Span word() const { return word_; }
  /// Behind a point, `->` or `::`.
  bool is_member() const { return is_member_; }

 private:
  bool is_at(std::string_view sign) const { return all_.substr(at_).starts_with(sign); }
  void leave(std::string_view end) {
    const std::size_t found = all_.find(end, at_ + 2);
    at_ = found == std::string_view::npos ? all_.size() : found + end.size();
  }
  void leave_quoted(char quote) {
    for (++at_; at_ < all_.size() && all_[at_] != quote && all_[at_] != '\n'; ++at_) {
      if (all_[at_] == '\\') ++at_;
    }
    at_ = std::min(at_ + 1, all_.size());
  }

  std::string_view all_;
  std::size_t at_ = 0;
  text::Span word_;
  bool follows_access_ = false;
  bool is_member_ = false;
};

}  // namespace

std::vector<Name> code_names(const CnlScan& scan) {
  std::vector<Name> out;
  for (const CnlDeclaration& one : scan.declarations) {
    if (one.kind != NameKind::kProcedure || one.inputs.empty()) continue;
    for (const text::Span code : scan.code) {
      if (code.begin < one.whole.begin || code.end > one.whole.end) continue;
      for (CodeWords words(scan.source->text(), code); words.next();) {
        const std::string_view word = scan.source->text(words.word());
        const auto input = std::ranges::find(one.inputs, word, &CnlState::name);
        if (words.is_member() || input == one.inputs.end()) continue;
        out.push_back(
            {words.word(), NameKind::kParameter, false, std::string(word), {scan.source, input->span}});
      }
    }
  }
  return out;
}

}  // namespace mlab::assist
