#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "mlab/lang/mdl/token.h"
#include "mlab/lang/mdl/tree.h"
#include "mlab/mission/maneuver.h"
#include "mlab/text/diagnostic.h"

namespace mlab::mdl {

/// Where a statement stands decides which statements there are.
enum class Section : std::uint8_t { kPreamble, kStep, kTyped };

/// Recursive descent over the tokens of one source.
///
/// The first error inside a statement is reported and makes the parser `stuck`: from then on it takes no
/// tokens and reports nothing, so that the functions need not look at each other's success. `recover_*` end
/// that state.
class Parser {
 public:
  Parser(text::SourcePtr source, text::Diagnostics& diagnostics);

  Tree file();
  /// A typed line, with the words IMMEDIATE COMMAND: before it or without.
  Tree typed_line();

 private:
  // parser.cc: tokens, errors, comments
  const Token& token(std::size_t ahead = 0) const;
  std::string_view written(const Token& t) const { return source_->text(t.span); }
  bool at(TokenKind kind) const { return token().kind == kind; }
  /// The word ROBOTS, which is reserved only where a command may begin.
  bool is_robots(const Token& t) const;
  /// Begins a command of a step.
  bool starts_command(const Token& t) const;
  bool at(Word word) const { return token().kind == TokenKind::kWord && token().word == word; }
  bool at_end() const { return at(TokenKind::kEnd); }
  void advance();
  bool take(TokenKind kind);
  bool take(Word word);
  bool is_reserved(const Token& t) const;
  text::Place place(text::Span span) const { return {source_, span}; }
  std::string describe(const Token& t) const;
  /// Reports and gets stuck; says nothing where it is stuck already.
  text::Diagnostic& fail(std::string kind, text::Span span, std::string message);
  text::Diagnostic& fail_expected(std::string_view what);
  /// The same, with the words that would be understood as a hint.
  void fail_unknown(std::string kind, std::string_view what, std::span<const std::string> known);
  /// Reports and goes on.
  text::Diagnostic& complain(std::string kind, text::Span span, std::string message);
  /// Hands the comments before the next token to the construct that begins there; one that stands behind the
  /// construct before it goes to that one.
  void collect_comments(Comments* before, Comments& mine);

  // parser.cc: what all statements are made of
  Name name(std::string_view what);
  Number number(std::string_view what);
  bool at_misread_number() const;
  Number number_of(const Token& t);
  Name take_name();

  // parser.cc: the file
  void preamble(Tree& tree);
  bool command_list_header(Tree& tree);
  void steps(Tree& tree);
  void step(Tree& tree);
  void step_label(LabelledStep& step);
  void step_commands(LabelledStep& step);
  void typed(Tree& tree);
  void remaining_comments(Tree& tree);
  bool starts_statement(const Token& t) const;
  bool resembles_statement();
  bool looks_like_header() const;
  void recover_in_preamble(std::size_t first);
  bool begins_step() const;
  void recover_in_steps();
  void leave_broken_step();
  void recover_in_typed();
  Comments* last_comments(Tree& tree);

  // parse_statement.cc
  std::optional<Statement> parsed_statement(Section section, Damage& damage);
  void statement_by_word(Section section, Statement& out, Damage& damage);
  void refuse_statement(Section section, Damage& damage);
  bool is_known_elsewhere(const Token& t) const;
  static std::string near_statement(std::string_view word);
  statement::OverlayFile overlay_file();
  statement::NewRobot new_robot();
  std::optional<Name> color_or_host();
  void parameter_list(statement::NewRobot& robot);
  Parameter parameter();
  statement::UnitDefinition unit_definition();
  void group_content(statement::UnitDefinition& unit, std::uint32_t group, std::uint32_t depth);
  std::uint32_t parenthesized_group(statement::UnitDefinition& unit, std::uint32_t depth);
  bool at_robot() const;
  Name group_name();
  statement::Set set(Section section);
  statement::Set set_maneuver(const mission::ManeuverInfo& maneuver, Section section);
  statement::Print print();
  statement::Failsafe failsafe();
  mission::FailsafeCondition failsafe_condition();
  mission::FailsafeAction failsafe_action();
  Name fence_name(const mission::FailsafeConditionInfo& condition);
  Number battery_share();
  bool at_written(std::string_view word) const;
  statement::InjectTrack inject_track();

  // parse_command.cc
  statement::UnitAction unit_action();
  statement::UnitAction robots_action(bool says_robots);
  void robot_numbers(statement::UnitAction& action);
  void action(statement::UnitAction& action, const std::string& whom);
  void more_places(statement::UnitAction& action);
  void start_step(statement::UnitAction& action);
  Location location(std::string_view command);
  void clauses(statement::UnitAction& action);
  std::optional<Clause> parsed_clause(mission::Task task);
  void refuse_clause(mission::Task task, text::Span span, std::string_view said);
  clause::PhaseLine phase_line();
  Moment until();
  std::optional<Moment> time_and_date();

  text::SourcePtr source_;
  text::Diagnostics& diagnostics_;
  Tokens tokens_;
  std::size_t next_ = 0;
  std::size_t next_comment_ = 0;
  bool stuck_ = false;
  int comparisons_left_ = 2000;  // of words with those of the language, while looking for a place to go on
  text::Diagnostic unsaid_;      // takes what is said of an error that follows from one before
};

}  // namespace mlab::mdl
