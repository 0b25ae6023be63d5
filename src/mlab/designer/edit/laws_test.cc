#include <fstream>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/designer/testing/drawn_text.h"
#include "mlab/designer/testing/random_edit.h"
#include "mlab/documents/store.h"
#include "mlab/lang/cdl/print/format.h"
#include "mlab/lang/cdl/syntax/lexer.h"
#include "mlab/robot/program/configuration_file.h"

namespace mlab::designer {
namespace {

constexpr int kEdits = 12;

std::string file(const std::string& path) {
  std::ifstream in(base::source_folder() + path);
  std::stringstream out;
  out << in.rdbuf();
  return out.str();
}

// A configuration of the repository, or a file of the library.
std::string some_text() {
  const auto& library = robot::library_environment().built_in;
  const auto which = *rc::gen::inRange<std::size_t>(0, library.size() * 2);
  const char* const kOwn[] = {"/missions/forage/forager.cdl",
                              "/src/mlab/lang/cdl/testdata/examples/formulas.cdl",
                              "/src/mlab/lang/cdl/testdata/examples/robots.cdl"};
  const char* own = kOwn[which % 3];
  return cdl::laid_out(which < library.size() ? library[which]->source->text() : file(own));
}

// Comments that are no help: they belong to nobody.
std::multiset<std::string> comments_of(const std::string& text) {
  std::multiset<std::string> out;
  for (const cdl::Comment& comment : cdl::lex(text).comments) {
    const std::string words = text.substr(comment.span.begin, comment.span.end - comment.span.begin);
    if (!words.starts_with("///")) out.insert(words);
  }
  return out;
}

RC_GTEST_PROP(EditLaws, WhateverIsEditedCanBeReadIsLaidOutAndKeepsItsComments, ()) {
  testing::DrawnText text(some_text());
  const auto comments = comments_of(text.text());
  base::Random random(*rc::gen::arbitrary<std::uint64_t>());
  for (int i = 0; i < kEdits; ++i) {
    const Edit edit = testing::RandomEdit(text.model(), random).make();
    const text::Result<Edited> done = text.try_edit(edit);
    RC_ASSERT((done.has_value() || !done.error().message.empty()));  // its || is no short circuit
    if (!done) continue;
    RC_LOG() << edit.DebugString() << done->text << "\n";
    text.set(done->text);
    RC_ASSERT(text.model().is_readable());
    RC_ASSERT(cdl::laid_out(text.text()) == text.text());
    const auto now = comments_of(text.text());
    for (const std::string& comment : comments) RC_ASSERT(now.contains(comment));
  }
}

RC_GTEST_PROP(EditLaws, UndoGivesEveryByteBack, ()) {
  const std::string first = some_text();
  testing::DrawnText text(first);
  documents::ProjectFolder nowhere({});
  documents::Store store(nowhere, "");
  documents::Document& open = store.add(std::make_shared<documents::Document>(
      "a.cdl", std::make_shared<const mlab::text::Source>("a.cdl", first)));
  base::Random random(*rc::gen::arbitrary<std::uint64_t>());
  std::vector<std::string> texts{first};
  for (int i = 0; i < kEdits; ++i) {
    const text::Result<Edited> done = text.try_edit(testing::RandomEdit(text.model(), random).make());
    if (!done || done->text == text.text()) continue;
    text.set(done->text);
    store.change(open, done->text, done->name, i * 10.0);
    texts.push_back(done->text);
  }
  for (std::size_t i = texts.size() - 1; i > 0; --i) {
    RC_ASSERT(open.log->undo());
    RC_ASSERT(open.text.text() == texts[i - 1]);
  }
  RC_ASSERT(!open.log->undo());
  for (std::size_t i = 1; i < texts.size(); ++i) {
    RC_ASSERT(open.log->redo());
    RC_ASSERT(open.text.text() == texts[i]);
  }
}

RC_GTEST_PROP(EditLaws, AConnectedWireIsDrawn, ()) {
  testing::DrawnText text(some_text());
  base::Random random(*rc::gen::arbitrary<std::uint64_t>());
  for (int i = 0; i < kEdits * 3; ++i) {
    const Edit edit = testing::RandomEdit(text.model(), random).make();
    if (!edit.changes(0).has_place() || edit.changes(0).place().page().find('.') != std::string::npos)
      continue;
    const text::Result<Edited> done = text.try_edit(edit);
    if (!done) continue;
    const auto page = edit.changes(0).place().page();
    const auto nodes = [&] {
      return draw(text.model(), page, {"a.cdl", 1, false, [](std::string_view) { return std::string(); }})
          .nodes_size();
    };
    const int before = nodes();
    text.set(done->text);
    RC_ASSERT(nodes() > before);
  }
}

}  // namespace
}  // namespace mlab::designer
