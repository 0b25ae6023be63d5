#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "mlab/language/cdl_scan.h"

namespace mlab::language {

/// Reads one configuration into a `CdlScan`. The functions that read expressions stand in cdl_expression.cc.
class CdlReader {
 public:
  explicit CdlReader(const text::SourcePtr& source);
  CdlScan run();

 private:
  using Kind = CdlWant::Kind;
  using TokenKind = cdl::Token::Kind;

  // The token, and what is taken.
  const cdl::Token& token(std::size_t ahead = 0) const {
    return tokens_[at_ + ahead < tokens_.size() ? at_ + ahead : tokens_.size() - 1];
  }
  std::string_view text(std::size_t ahead = 0) const { return out_.source->text(token(ahead).span); }
  bool at_end() const { return token().kind == TokenKind::kEnd; }
  bool is(std::string_view word) const;
  bool is_any(std::initializer_list<std::string_view> words) const;
  bool is_name() const { return token().kind == TokenKind::kName; }
  bool is_next(std::string_view word) const { return text(1) == word; }
  bool starts_line(std::size_t ahead = 0) const;
  bool at_declaration() const;
  bool at_close() const { return at_end() || is("}") || at_declaration(); }
  void advance();
  bool take(std::string_view punctuation);
  /// The same for a word of the language, which is noted.
  bool take_word(std::string_view word);
  void note_word() { out_.words.push_back(token().span); }
  void skip_statement();
  std::uint32_t last_end() const { return at_ == 0 ? 0 : tokens_[at_ - 1].span.end; }

  // Where the text ends.
  void want(CdlWant one);
  void want_words(std::initializer_list<std::string_view> words);
  /// Where nothing else can follow: what is read further out does not count any more.
  void need(CdlWant one);
  void need_words(std::initializer_list<std::string_view> words);
  void need_kind(Kind kind) { need({.kind = kind}); }
  /// Whether a statement may begin here.
  bool at_statement() const;
  void close(std::string_view bracket);

  // Names.
  int add_name(NameKind kind, bool is_declaration = false);
  /// A name that is declared here, or empty where none stands.
  std::pair<std::string, text::Span> declared(NameKind kind);
  bool use(NameKind kind, Kind wanted);
  CdlDeclaration& current() { return out_.declarations.back(); }
  std::string help_above() const;
  std::string help_behind() const;

  // Declarations.
  void item();
  void declaration(NameKind kind, void (CdlReader::*body)());
  void assemblage();
  void binding();
  void robot_class();
  void robot();
  void society_operator();
  void society();
  void group();
  void layout();
  void layout_entry(int owner);
  bool at_note() const;
  int layout_path(int owner, Kind wanted);
  void use_file();
  void architecture();
  void parameters();
  void parameter();
  std::string bracketed_unit();
  std::string value_text(std::uint32_t begin) const;
  void assemblage_body();
  void let();
  void device();
  void body_settings();
  void drive();
  void choice();

  // Expressions.
  CdlGuess expression(const CdlWanted& wanted);
  CdlGuess conjunction(const CdlWanted& wanted);
  CdlGuess negation(const CdlWanted& wanted);
  CdlGuess suffixed(const CdlWanted& wanted);
  CdlGuess primary(const CdlWanted& wanted);
  bool at_next_statement() const;
  CdlGuess number(const CdlWanted& wanted);
  CdlGuess named(const CdlWanted& wanted);
  CdlGuess call(const CdlWanted& wanted);
  void arguments(int callee);
  CdlGuess list(const CdlWanted& wanted);
  CdlGuess delay(const CdlWanted& wanted);
  bool at_block() const;
  CdlGuess block(const CdlWanted& wanted);
  void members(const ValueType& type);
  void member(const ValueType& type);
  CdlGuess by_operator(const CdlWanted& wanted);
  CdlGuess sequence(const CdlWanted& wanted);
  void state(int sequence, CdlGuess& first, const CdlWanted& wanted);
  void transition(int sequence);
  CdlGuess select(const CdlWanted& wanted);
  CdlGuess one_case(const CdlGuess& selector, const CdlWanted& wanted);
  bool open_block();

  CdlScan out_;
  std::vector<cdl::Token> tokens_;
  std::size_t at_ = 0;
  int depth_ = 0;
  int sequences_ = 0;
  bool stops_at_brace_ = false;
  bool is_done_ = false;  ///< all that could come is known
};

}  // namespace mlab::language
