#include "mlab/lang/cdl_historic/parser.h"

#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "mlab/lang/cdl_historic/cursor.h"
#include "mlab/lang/cdl_historic/lexer.h"

namespace mlab::cdl_historic {
namespace {

std::optional<Instance::Kind> instance_kind(std::string_view keyword) {
  using enum Instance::Kind;
  if (keyword == "instAgent" || keyword == "instagent") return kAgent;
  if (keyword == "instOp" || keyword == "instop") return kOperator;
  if (keyword == "instBP" || keyword == "instbp") return kBindingPoint;
  if (keyword == "instSensor" || keyword == "instsensor") return kSensor;
  if (keyword == "instActuator" || keyword == "instactuator") return kActuator;
  if (keyword == "instRobot" || keyword == "instrobot") return kRobot;
  if (keyword == "instGroup" || keyword == "instgroup") return kGroup;
  return std::nullopt;
}

// `<1,2> |text| name from CLASS( ... )`
void parse_instance(Cursor& cursor, Instance::Kind kind, Tree& tree) {
  Instance instance;
  instance.kind = kind;
  instance.spot = cursor.take_spot();
  instance.name = cursor.expect_name("the name of the instance");
  if (!cursor.expect("from", "behind the name of the instance")) return;
  instance.what = parse_expression(cursor);
  if (instance.what != nullptr) tree.instances.push_back(std::move(instance));
}

void parse_statement(Cursor& cursor, Tree& tree) {
  const std::string_view keyword = cursor.text();
  if (!cursor.is(Token::Kind::kName) || !starts_statement(keyword)) {
    if (ExprPtr expr = parse_expression(cursor)) tree.expressions.push_back(std::move(expr));
    cursor.take(";");  // hand-written files put one here
    return;
  }
  cursor.advance();
  const std::optional<Instance::Kind> kind = instance_kind(keyword);
  if (kind) {
    parse_instance(cursor, *kind, tree);
  } else if (keyword == "bindArch" || keyword == "bindarch") {
    Word name = cursor.expect_name("the name of an architecture");
    if (!name.text.empty()) tree.architectures.push_back(std::move(name));
  } else {
    parse_definition(cursor, keyword, tree);
  }
  if (cursor.failed()) return;
  // `instRobot` alone takes none in the historic language.
  if (!cursor.take(";") && kind != Instance::Kind::kRobot) cursor.expect(";", "at the end of the statement");
}

}  // namespace

Tree parse(const text::SourcePtr& source, text::Diagnostics& sink) {
  Tree tree;
  tree.source = source;
  Cursor cursor(source, lex(source, sink), sink);
  while (!cursor.at_end()) {
    const std::size_t before = cursor.position();
    cursor.start_statement();
    parse_statement(cursor, tree);
    if (cursor.failed()) cursor.skip_statement();
    if (cursor.position() == before && !cursor.at_end()) cursor.advance();
  }
  return tree;
}

}  // namespace mlab::cdl_historic
