#include <algorithm>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "mlab/lang/mdl/parser.h"
#include "mlab/lang/mdl/quoted.h"
#include "mlab/mission/failsafe.h"

namespace mlab::mdl {
namespace {

constexpr std::string_view kReverse = "REVERSE";
constexpr std::string_view kInside = "INSIDE";
constexpr std::string_view kBelow = "BELOW";

template <class Rows>
std::vector<std::string> words_in(const Rows& rows) {
  std::vector<std::string> out;
  for (const auto& row : rows) out.emplace_back(row.word);
  return out;
}

}  // namespace

// The words of a failsafe are no reserved ones: they are told by where they stand.
bool Parser::at_written(std::string_view word) const {
  return !stuck_ && token().kind != TokenKind::kString && equal_without_case(written(token()), word);
}

mission::FailsafeCondition Parser::failsafe_condition() {
  for (const mission::FailsafeConditionInfo& one : mission::kFailsafeConditions) {
    if (!at_written(one.word)) continue;
    advance();
    return one.condition;
  }
  fail_unknown("unknown-failsafe", "what a failsafe looks for", words_in(mission::kFailsafeConditions));
  return {};
}

mission::FailsafeAction Parser::failsafe_action() {
  for (const mission::FailsafeActionInfo& one : mission::kFailsafeActions) {
    if (!at_written(one.word)) continue;
    advance();
    return one.action;
  }
  if (at_written(kReverse)) {
    advance();
    if (!at_written(kInside)) fail_expected(fmt::format("`{}`", kInside));
    advance();
    return mission::FailsafeAction::kReverseInside;
  }
  fail_unknown("unknown-failsafe", "what the robot does then", words_in(mission::kFailsafeActions));
  return {};
}

// `FAILSAFE OUTSIDE HOLD`: the line is missing, unless one has such a name and the action stands behind it.
Name Parser::fence_name(const mission::FailsafeConditionInfo& condition) {
  const bool is_reverse = at_written(kReverse) && equal_without_case(written(token(1)), kInside);
  const bool is_action = is_reverse || std::ranges::any_of(mission::kFailsafeActions, [&](const auto& one) {
                           return at_written(one.word);
                         });
  const Token& behind = token(is_reverse ? 2 : 1);
  const bool is_last = behind.first_on_line || behind.kind == TokenKind::kEnd;
  if (is_action && is_last && !token().first_on_line) {
    fail("unexpected-token", token().span,
         fmt::format("expected the name of a closed BOUNDARY between `{}` and {}", condition.word,
                     in_backticks(written(token()))));
  }
  return name("the name of a closed BOUNDARY");
}

Number Parser::battery_share() {
  if (!at_written(kBelow)) fail_expected(fmt::format("`{}`", kBelow));
  advance();
  Number out = number("a share in per cent");
  if (!take(TokenKind::kPercent)) fail_expected("`%`");
  return out;
}

statement::Failsafe Parser::failsafe() {
  statement::Failsafe out;
  if (at_written("FOR")) {
    advance();
    out.type = at_robot() ? take_name() : name("the name of a robot type");
  }
  out.condition = failsafe_condition();
  const mission::FailsafeConditionInfo& condition = mission::info(out.condition);
  if (!stuck_ && condition.has_fence) out.fence = fence_name(condition);
  if (!stuck_ && condition.has_share) out.share = battery_share();
  if (at_written("AFTER")) {
    if (!condition.may_last) {
      fail("clause-not-allowed", token().span,
           fmt::format("{} has no AFTER: the robot must not get there", condition.word));
    }
    advance();
    out.seconds = number("seconds");
  }
  const std::uint32_t begin = token().span.begin;
  out.action = failsafe_action();
  out.action_span = {begin, stuck_ || next_ == 0 ? begin : tokens_.tokens[next_ - 1].span.end};
  return out;
}

}  // namespace mlab::mdl
