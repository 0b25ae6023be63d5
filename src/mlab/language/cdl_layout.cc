// Where things stand on the designer's canvas, and what is noted there.

#include "mlab/language/cdl_reader.h"

namespace mlab::language {

void CdlReader::layout() {
  note_word();
  advance();
  if (at_end()) need_kind(Kind::kOwner);
  const int owner = layout_path(-1, Kind::kNode);
  if (!take("{")) return;
  while (!at_close()) {
    const std::size_t before = at_;
    layout_entry(owner);
    if (at_ == before) advance();
  }
  if (at_end() && at_statement()) {
    want_words({"note", "frame"});
    if (owner >= 0) need({.kind = Kind::kNode, .wanted = {.call = owner}});
  }
  close("}");
}

// `note 40 200 "words"`, `frame 0 0 400 300`; `note 40 200;` is the place of a node that is called `note`.
bool CdlReader::at_note() const {
  if (!is_any({"note", "frame"}) || token(1).kind != TokenKind::kNumber ||
      token(2).kind != TokenKind::kNumber)
    return false;
  const TokenKind third = token(3).kind;
  return third == TokenKind::kNumber || third == TokenKind::kText || third == TokenKind::kUnclosed;
}

void CdlReader::layout_entry(int owner) {
  if (at_note()) {
    note_word();
    do {
      advance();
    } while (token().kind == TokenKind::kNumber || token().kind == TokenKind::kText);
    if (!take(";") && !at_close() && !starts_line()) skip_statement();
    return;
  }
  layout_path(owner, Kind::kNode);
  if (token().kind == TokenKind::kNumber) advance();
  if (token().kind == TokenKind::kNumber) advance();
  if (!take(";") && !at_close() && !starts_line()) skip_statement();
}

// @return  index of the first name; -1 where there is none
int CdlReader::layout_path(int owner, Kind wanted) {
  int first = -1;
  do {
    if (at_end() && first >= 0) need({.kind = wanted, .wanted = {.call = owner >= 0 ? owner : first}});
    if (!is_name()) break;
    const int i = add_name(NameKind::kNode);
    out_.names[static_cast<std::size_t>(i)].owner = owner >= 0 ? owner : first;
    out_.names[static_cast<std::size_t>(i)].declaration = -1;
    if (first < 0) first = i;
  } while (take("."));
  return first;
}

}  // namespace mlab::language
