#include "mlab/assist/cnl_scan.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "mlab/lang/cnl/cursor.h"
#include "mlab/percept/sensors.h"

namespace mlab::assist {
namespace {

class CnlReader {
 public:
  explicit CnlReader(const text::SourcePtr& source) : lexer_(source->text()) {
    out_.source = source;
    token_ = lexer_.next(0, &out_.comments);
  }

  CnlScan run() {
    while (!at_end()) {
      const std::uint32_t before = token_.span.begin;
      declaration();
      if (token_.span.begin == before && !at_end()) advance();
    }
    if (!is_done_ && out_.wants.empty()) {
      for (const std::string_view word : cnl::kDeclarationWords) want_words({word});
      want_words({"#include"});
      out_.open = -1;
    }
    return std::move(out_);
  }

 private:
  std::string_view text() const { return out_.source->text(token_.span); }
  bool at_end() const { return token_.kind == cnl::Token::Kind::kEnd; }
  bool is_name() const { return token_.kind == cnl::Token::Kind::kName; }
  bool is(std::string_view word) const {
    return (is_name() || token_.kind == cnl::Token::Kind::kPunctuation) && text() == word;
  }
  bool is_any(std::initializer_list<std::string_view> words) const {
    return std::ranges::any_of(words, [&](std::string_view word) { return is(word); });
  }
  void advance() {
    if (at_end()) return;
    if (!is_name()) out_.tokens.push_back(token_);
    last_end_ = token_.span.end;
    token_ = lexer_.next(token_.span.end, &out_.comments);
  }
  bool take(std::string_view punctuation) {
    if (!is(punctuation)) return false;
    advance();
    return true;
  }
  bool take_word(std::string_view word) {
    if (!is(word)) return false;
    out_.words.push_back(token_.span);
    advance();
    return true;
  }
  void want(CnlWant one) {
    if (!is_done_) out_.wants.push_back(std::move(one));
  }
  void want_words(std::initializer_list<std::string_view> words) {
    CnlWant one;
    for (const std::string_view word : words) one.words.emplace_back(word);
    want(std::move(one));
  }
  void need(CnlWant one) {
    want(std::move(one));
    is_done_ = true;
  }
  void need_kind(CnlWant::Kind kind) {
    CnlWant one;
    one.kind = kind;
    need(std::move(one));
  }
  void need_nothing() { need({}); }

  CnlDeclaration& current() { return out_.declarations.back(); }
  CnlName& add_name(NameKind kind, bool is_declaration = false) {
    CnlName name;
    name.span = token_.span;
    name.kind = kind;
    name.is_declaration = is_declaration;
    name.text = text();
    name.declaration = static_cast<int>(out_.declarations.size()) - 1;
    advance();
    return out_.names.emplace_back(std::move(name));
  }
  void declared(NameKind kind) {
    if (at_end()) need_nothing();
    if (!is_name()) return;
    const CnlName& name = add_name(kind, true);
    current().name = name.text;
    current().span = name.span;
  }
  void type() {
    if (at_end()) need_kind(CnlWant::Kind::kType);
    if (!is_name()) return;
    current().of = text();
    add_name(NameKind::kType);
    current().unit = unit();
  }
  std::string unit() {
    if (!is("[")) return "";
    const std::uint32_t begin = token_.span.end;
    advance();
    if (at_end()) need_kind(CnlWant::Kind::kUnit);
    while (!at_end() && !is_any({"]", ";", "=", "with"})) advance();
    std::string out;
    if (is("]")) out = out_.source->text({begin, token_.span.begin});
    take("]");
    return out;
  }
  // Past the next `;`, unless a word before it begins something else.
  void skip(std::initializer_list<std::string_view> words) {
    while (!at_end() && !is_any(words)) {
      if (take(";")) return;
      advance();
    }
  }

  void begin_declaration(NameKind kind) {
    CnlDeclaration& one = out_.declarations.emplace_back();
    one.kind = kind;
    one.word = text();
    one.whole.begin = token_.span.begin;
    out_.open = static_cast<int>(out_.declarations.size()) - 1;
    out_.words.push_back(token_.span);
    advance();
  }
  void end_declaration(bool is_closed) {
    current().whole.end = last_end_;
    if (is_closed) out_.open = -1;
    if (!is_closed && at_end()) is_done_ = true;
  }

  void declaration() {
    if (token_.kind == cnl::Token::Kind::kDirective) {
      include();
    } else if (is_any({"external", "public", "remote"})) {
      out_.words.push_back(token_.span);
      advance();
      if (at_end()) need_words_behind();
    } else if (is_any({"procedure", "nprocedure"})) {
      procedure();
    } else if (is("init")) {
      out_.words.push_back(token_.span);
      advance();
      code({"iend"});
    } else if (is("node")) {
      node();
    } else if (is("sequence")) {
      sequence();
    } else if (is("select")) {
      select();
    } else if (is("delay")) {
      begin_declaration(NameKind::kNode);
      head_of_operator();
      links();
    } else if (is("parameter")) {
      parameter();
    } else if (is("type")) {
      type_declaration();
    } else if (is_any({"module", "modulename"})) {
      begin_declaration(NameKind::kModule);
      take("=");
      declared(NameKind::kModule);
      end_declaration(take(";"));
    }
  }

  void need_words_behind() {
    want_words({"node", "procedure"});
    is_done_ = true;
  }

  void include() {
    const std::string_view line = text();
    const std::size_t open = line.find('"');
    const std::size_t close = open == std::string_view::npos ? open : line.find('"', open + 1);
    if (close != std::string_view::npos) {
      CnlName file;
      file.span = {token_.span.begin + static_cast<std::uint32_t>(open) + 1,
                   token_.span.begin + static_cast<std::uint32_t>(close)};
      file.kind = NameKind::kFile;
      file.text = out_.source->text(file.span);
      out_.includes.push_back(std::move(file));
    }
    advance();
  }

  // C++ up to a line that is only one of these words.
  void code(std::initializer_list<std::string_view> ends) {
    std::uint32_t at = last_end_;
    const std::uint32_t begin = at;
    const std::string_view all = out_.source->text();
    while (at < all.size()) {
      const std::uint32_t next = lexer_.next_line(at);
      const std::uint32_t line_end = lexer_.line_end(at);
      std::string_view line = all.substr(at, line_end - at);
      const std::size_t first = line.find_first_not_of(" \t\r");
      line = first == std::string_view::npos ? ""
                                             : line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
      if (at > begin && std::ranges::find(ends, line) != ends.end()) break;
      at = next;
      if (next >= all.size()) break;
    }
    const bool is_open = at >= all.size();
    out_.code.push_back({begin, at});
    token_ = lexer_.next(at, &out_.comments);
    last_end_ = at;
    if (!is_open && is_any(ends)) {
      out_.words.push_back(token_.span);
      return;
    }
    if (at_end()) need_kind(CnlWant::Kind::kCode);
  }

  void procedure() {
    begin_declaration(NameKind::kProcedure);
    type();
    declared(NameKind::kProcedure);
    attributes();
    inputs();
    bool is_closed = false;
    while (is_any({"once", "header", "body"})) {
      out_.words.push_back(token_.span);
      advance();
      code({"header", "body", "pend"});
    }
    if (is("pend")) {
      advance();
      is_closed = true;
    }
    end_declaration(is_closed);
  }

  void attributes() {
    while (!at_end() && !is("with") && !is_any({"procedure", "node"})) {
      if (is("senses")) {
        take_word("senses");
        if (at_end()) need_senses();
        const percept::SensorInfo* const sensor = percept::sensor_named(text());
        if (is_name()) add_name(NameKind::kWord);
        if (sensor != nullptr && sensor->has_own_reach) continue;
        if (at_end()) want_words({"within"});
        take_word("within");
      } else if (!take_word("pure") && !take_word("latency") && !take_word("alias")) {
        advance();
      }
    }
    if (at_end()) want_words({"pure", "latency", "senses", "alias", "with"});
    take_word("with");
  }

  void need_senses() {
    CnlWant one;
    for (const percept::SensorInfo& sensor : percept::kSensors) one.words.emplace_back(sensor.name);
    want(std::move(one));
    is_done_ = true;
  }

  void inputs() {
    while (!at_end() && !is_any({"once", "header", "body", "pend", "procedure", "node"})) {
      const std::uint32_t before = token_.span.begin;
      take_word("list");
      if (at_end()) need_kind(CnlWant::Kind::kType);
      if (is_name()) add_name(NameKind::kType);
      unit();
      if (at_end()) need_nothing();
      if (is_name()) {
        const CnlName& name = add_name(NameKind::kParameter, true);
        current().inputs.push_back({name.text, name.span});
      }
      while (!at_end() && !is_any({";", "once", "header", "body", "pend"})) {
        if (!take_word("in")) advance();
      }
      take(";");
      if (token_.span.begin == before) advance();
    }
    if (at_end()) {
      want_words({"list", "once", "header", "body"});
      need_kind(CnlWant::Kind::kType);
    }
  }

  void parameter() {
    begin_declaration(NameKind::kParameter);
    type();
    declared(NameKind::kParameter);
    while (!at_end() && !is(";") && !is_any({"node", "parameter", "sequence", "select", "delay"})) {
      if (!take_word("in")) advance();
    }
    end_declaration(take(";"));
  }

  void type_declaration() {
    begin_declaration(NameKind::kType);
    take("<");
    declared(NameKind::kType);
    while (!at_end() && !is(";") && !is("procedure")) advance();
    end_declaration(take(";"));
  }

  void node() {
    begin_declaration(NameKind::kNode);
    declared(NameKind::kNode);
    if (at_end()) want_words({"is"});
    take_word("is");
    if (at_end()) need_kind(CnlWant::Kind::kProcedure);
    if (is_name()) {
      current().of = text();
      add_name(NameKind::kProcedure);
    }
    if (token_.kind == cnl::Token::Kind::kDescription) advance();
    if (at_end()) want_words({"with"});
    links();
  }

  void links() {
    take_word("with");
    CnlWant next;
    next.kind = CnlWant::Kind::kInput;
    while (!at_end() && !is("nend") && !at_next()) {
      const std::uint32_t before = token_.span.begin;
      std::string input;
      if (is_name()) {
        const CnlName& name = add_name(NameKind::kArgument);
        input = name.text;
        next.given.insert(input);
      }
      if (take("=")) source(input);
      take(";");
      if (token_.span.begin == before) advance();
    }
    if (at_end() && behind_statement()) {
      want_words({"nend"});
      need(next);
    }
    close();
  }

  bool behind_statement() const {
    if (last_end_ == 0) return false;
    const std::string_view all = out_.source->text();
    return all[last_end_ - 1] == ';' || all.substr(0, last_end_).ends_with("with");
  }

  // A declaration begins although the one before was not closed.
  bool at_next() const {
    return lexer_.starts_line(token_.span.begin) &&
           is_any({"node", "public", "sequence", "select", "delay", "parameter", "procedure"});
  }

  void close() {
    const bool is_closed = is("nend");
    take_word("nend");
    end_declaration(is_closed || !at_end());
  }

  void source(const std::string& input) {
    if (at_end()) {
      CnlWant one;
      one.kind = CnlWant::Kind::kSource;
      one.input = input;
      need(std::move(one));
    }
    if (is_name()) {
      CnlName& name = add_name(NameKind::kWord);
      name.is_source = true;
      name.input = input;
    } else if (!is(";")) {
      advance();
    }
  }

  void head_of_operator() {
    declared(NameKind::kNode);
    if (at_end()) want_words({"of"});
    take_word("of");
    type();
  }

  void sequence() {
    begin_declaration(NameKind::kNode);
    head_of_operator();
    if (token_.kind == cnl::Token::Kind::kDescription) advance();
    if (at_end()) want_words({"with"});
    take_word("with");
    while (!at_end() && !is("nend") && !at_next()) {
      const std::uint32_t before = token_.span.begin;
      if (is("when")) {
        transition();
      } else {
        state();
      }
      if (token_.span.begin == before) advance();
    }
    if (at_end() && behind_statement()) want_words({"start", "final", "state", "when", "nend"});
    close();
  }

  void state() {
    while (take_word("start") || take_word("final")) {
    }
    if (!take_word("state")) {
      if (at_end()) want_words({"state"});
      return;
    }
    if (at_end()) need_nothing();
    if (is_name()) {
      const CnlName& name = add_name(NameKind::kState, true);
      current().states.push_back({name.text, name.span});
    }
    if (at_end()) want_words({"is"});
    if (take_word("is")) source("");
    take(";");
  }

  void transition() {
    take_word("when");
    take_word("not");
    source("trigger");
    if (at_end()) want_words({"goto"});
    if (take_word("goto")) {
      if (at_end()) need_kind(CnlWant::Kind::kState);
      if (is_name()) add_name(NameKind::kState);
      if (at_end()) want_words({"restart"});
      take_word("restart");
    }
    take(";");
  }

  void select() {
    begin_declaration(NameKind::kNode);
    head_of_operator();
    if (at_end()) want_words({"by"});
    if (take_word("by")) source("selector");
    if (token_.kind == cnl::Token::Kind::kDescription) advance();
    if (at_end()) want_words({"with"});
    take_word("with");
    while (!at_end() && !is("nend") && !at_next()) {
      const std::uint32_t before = token_.span.begin;
      if (take_word("case")) {
        while (token_.kind == cnl::Token::Kind::kNumber || is(",")) advance();
      } else {
        take_word("otherwise");
      }
      if (take(":")) source("");
      take(";");
      if (token_.span.begin == before) advance();
    }
    if (at_end() && behind_statement()) want_words({"case", "otherwise: ", "nend"});
    close();
  }

  cnl::Lexer lexer_;
  CnlScan out_;
  cnl::Token token_;
  std::uint32_t last_end_ = 0;
  bool is_done_ = false;
};

}  // namespace

CnlScan scan_cnl(const text::SourcePtr& source) {
  return CnlReader(source).run();
}

}  // namespace mlab::assist
