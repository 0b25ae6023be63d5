#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/designer/testing/drawn_text.h"
#include "mlab/designer/testing/random_edit.h"
#include "mlab/difference/tell.h"
#include "mlab/lang/cdl/lower/node_names.h"
#include "mlab/lang/cdl/print/format.h"
#include "mlab/lang/cdl/syntax/lexer.h"
#include "mlab/robot/program/configuration_file.h"

namespace mlab::designer {
namespace {

using difference::Comparison;
using difference::Difference;
using difference::Thing;
using difference::What;

constexpr int kEditsInARow = 8;

std::string any_text() {
  const auto& library = robot::library_environment().built_in;
  const auto which = *rc::gen::inRange<std::size_t>(0, library.size() * 2);
  if (which < library.size()) return cdl::laid_out(library[which]->source->text());
  std::ifstream in(base::source_folder() + "/missions/forage/forager.cdl");
  std::stringstream out;
  out << in.rdbuf();
  return cdl::laid_out(out.str());
}

Comparison compared(const Model& before, const Model& after) {
  return difference::compare({before.tree(), before.components().elaboration()},
                             {after.tree(), after.components().elaboration()});
}

std::string told(const Comparison& all) {
  std::string out;
  for (const Difference& one : all.meaning)
    out += fmt::format("{} {}: {}\n", sign_of(one.what), place_of(one), sentence(one));
  return out;
}

using Names = std::multiset<std::string>;

// What is there in one of the two only.
Names alone(const Comparison& all, What what) {
  Names out;
  for (const Difference& one : all.meaning) {
    if (one.what != what) continue;
    const bool is_new = what == What::kAdded;
    out.insert(
        fmt::format("{} {} {} {}", difference::word_of(one.thing), is_new ? one.page_after : one.page_before,
                    is_new ? one.name_after : one.name_before, is_new ? one.index_after : one.index_before));
  }
  return out;
}

// Changed or renamed, with both names.
Names in_both(const Comparison& all, bool is_turned) {
  Names out;
  for (const Difference& one : all.meaning) {
    if (one.what == What::kAdded || one.what == What::kRemoved) continue;
    const std::string& was = is_turned ? one.name_after : one.name_before;
    const std::string& is = is_turned ? one.name_before : one.name_after;
    out.insert(fmt::format("{} {} -> {}", difference::word_of(one.thing), was, is));
  }
  return out;
}

/// A text before and after some random edits.
struct Two {
  testing::DrawnText before{any_text()};
  testing::DrawnText after{before.text()};
};

void edit_at_random(testing::DrawnText& text, base::Random& random, int times) {
  for (int i = 0; i < times; ++i) {
    const text::Result<Edited> done = text.try_edit(testing::RandomEdit(text.model(), random).make());
    if (done) text.set(done->text);
  }
}

RC_GTEST_PROP(DifferenceLaws, OfATextToItselfIsNothing, ()) {
  testing::DrawnText text(any_text());
  base::Random random(*rc::gen::arbitrary<std::uint64_t>());
  edit_at_random(text, random, kEditsInARow);
  const testing::DrawnText again(text.text());
  const Comparison all = compared(text.model(), again.model());
  RC_ASSERT(told(all).empty());
  RC_ASSERT(all.layout.empty());
  RC_ASSERT(difference::remarks(all).empty());
}

RC_GTEST_PROP(DifferenceLaws, WhatWasRemovedOneWayIsAddedTheOther, ()) {
  Two two;
  base::Random random(*rc::gen::arbitrary<std::uint64_t>());
  edit_at_random(two.after, random, kEditsInARow);
  const Comparison there = compared(two.before.model(), two.after.model());
  const Comparison back = compared(two.after.model(), two.before.model());
  RC_LOG() << two.after.text() << "\nthere:\n" << told(there) << "back:\n" << told(back);
  RC_ASSERT(alone(there, What::kRemoved) == alone(back, What::kAdded));
  RC_ASSERT(alone(there, What::kAdded) == alone(back, What::kRemoved));
  RC_ASSERT(in_both(there, false) == in_both(back, true));
}

// Names of `let`s that say what their values would be called without one.
std::set<std::string> needless_names(const Model& model) {
  std::set<std::string> out;
  for (const cdl::Item& item : model.tree().items) {
    const auto* assemblage = std::get_if<cdl::Assemblage>(&item);
    if (assemblage == nullptr) continue;
    for (const cdl::Let& let : assemblage->lets) {
      if (!let.value) continue;
      const std::string name = cdl::default_name(*let.value);
      if (let.name.text == name || let.name.text.starts_with(name + "_")) out.insert(let.name.text);
    }
  }
  return out;
}

// The words outside of layouts, in any order: what is said, if not how. A `let` that is used once says the
// same as its value with a name, and arguments in their order the same as by their names.
std::set<std::string> words_of(const Model& model) {
  std::set<std::string> out;
  const std::string_view text = model.text();
  std::size_t layouts = text.size();
  for (const cdl::Item& item : model.tree().items) {
    if (const auto* layout = std::get_if<cdl::Layout>(&item))
      layouts = std::min<std::size_t>(layouts, layout->whole.begin);
  }
  const std::vector<cdl::Token> tokens = cdl::lex(text.substr(0, layouts)).tokens;
  const auto word = [&](std::size_t i) {
    return text.substr(tokens[i].span.begin, tokens[i].span.end - tokens[i].span.begin);
  };
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    const bool names_argument = i > 0 && word(i + 1) == "=" && word(i - 1) != "let";
    if (tokens[i].kind != cdl::Token::Kind::kPunctuation && !names_argument) out.emplace(word(i));
  }
  out.erase("let");
  out.erase("as");
  return out;
}

bool say_the_same_words(const Model& before, const Model& after) {
  std::set<std::string> words = words_of(before);
  std::set<std::string> words_after = words_of(after);
  for (const Model* model : {&before, &after}) {
    for (const std::string& name : needless_names(*model)) {
      words.erase(name);
      words_after.erase(name);
    }
  }
  return words == words_after;
}

// What an edit did is told, and nothing besides.
void check_one(const Change& change, const Comparison& all, const Model& before, const Model& after) {
  const auto& told_of = all.meaning;
  if (told_of.empty()) RC_ASSERT(say_the_same_words(before, after));
  switch (change.change_case()) {
    case Change::kArrange:
    case Change::kSetNote:
      RC_ASSERT(told_of.empty());
      return;
    case Change::kRename:
      // Unless a formula waited for something of that name.
      if (words_of(before).contains(change.rename().name())) return;
      for (const Difference& one : told_of) RC_ASSERT(one.what == What::kRenamed);
      RC_ASSERT(told_of.size() <= 1U);
      return;
    case Change::kRemoveTransition:
      RC_ASSERT(told_of.size() == 1U);
      RC_ASSERT(told_of.front().thing == Thing::kTransition);
      RC_ASSERT(told_of.front().what == What::kRemoved);
      return;
    case Change::kAddTransition:
      RC_ASSERT(told_of.size() == 1U);
      RC_ASSERT(told_of.front().thing == Thing::kTransition);
      RC_ASSERT(told_of.front().what == What::kAdded);
      return;
    case Change::kAddState:
      RC_ASSERT(alone(all, What::kRemoved).empty());
      return;
    case Change::kSetHelp:
      RC_ASSERT(told_of.size() <= 1U);
      for (const Difference& one : told_of) RC_ASSERT(one.details.front().what == "help");
      return;
    case Change::kPlace:
      RC_ASSERT(alone(all, What::kRemoved).empty());
      return;
    case Change::kDisconnect:
      // Where something has to stand, `Stand` does.
      RC_ASSERT(alone(all, What::kAdded).size() <= 1U);
      return;
    default:
      return;
  }
}

RC_GTEST_PROP(DifferenceLaws, AnEditIsToldAndNothingBesides, ()) {
  testing::DrawnText text(any_text());
  base::Random random(*rc::gen::arbitrary<std::uint64_t>());
  for (int i = 0; i < kEditsInARow; ++i) {
    const Edit edit = testing::RandomEdit(text.model(), random).make();
    const text::Result<Edited> done = text.try_edit(edit);
    if (!done || done->text == text.text()) continue;
    const testing::DrawnText before(text.text());
    text.set(done->text);
    const Comparison all = compared(before.model(), text.model());
    RC_LOG() << edit.DebugString() << before.text() << "\n----\n" << text.text() << "\n----\n" << told(all);
    check_one(edit.changes(0), all, before.model(), text.model());
  }
}

}  // namespace
}  // namespace mlab::designer
