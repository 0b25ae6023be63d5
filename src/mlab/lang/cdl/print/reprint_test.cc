#include "mlab/lang/cdl/print/reprint.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <random>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/lang/cdl/print/changes.h"
#include "mlab/lang/cdl/print/format.h"
#include "mlab/lang/cdl/print/print.h"
#include "mlab/lang/cdl/syntax/lexer.h"
#include "mlab/lang/cdl/syntax/parser.h"

namespace mlab::cdl {
namespace {

namespace fs = std::filesystem;

Tree parsed(const std::string& text) {
  text::Diagnostics sink;
  Tree tree = parse(std::make_shared<const text::Source>("a.cdl", text), sink);
  EXPECT_FALSE(sink.has_errors()) << text::render(sink) << text;
  return tree;
}

ExpressionPtr value(const std::string& text) {
  return std::get<Assemblage>(parsed("assemblage A() { " + text + "; }").items.front()).body;
}

// The text after changes that are noted with its tree.
std::string changed(const std::string& text, const std::function<void(const Tree&, Changes&)>& note) {
  const Tree tree = parsed(text);
  Changes changes(tree);
  note(tree, changes);
  return changes.done().text;
}

// All configurations that the repository has.
std::vector<std::string> all_files() {
  std::vector<std::string> out;
  for (const char* folder : {"library", "missions", "examples", "tests", "bench", "src/mlab/lang/cdl"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(base::source_folder()) / folder)) {
      if (entry.path().extension() != ".cdl") continue;
      std::ifstream in(entry.path());
      std::stringstream text;
      text << in.rdbuf();
      text::Diagnostics sink;
      const auto source = std::make_shared<const text::Source>(entry.path().string(), text.str());
      if (!looks_like_cdl(source->text())) continue;
      parse(source, sink);
      if (!sink.has_errors()) out.push_back(text.str());
    }
  }
  return out;
}

const std::vector<std::string>& files() {
  static const std::vector<std::string> kAll = all_files();
  return kAll;
}

TEST(Reprint, GivesTheTextOfATreeThatNobodyChanged) {
  EXPECT_GT(files().size(), 20U);
  for (const std::string& text : files()) {
    const Tree tree = parsed(text);
    EXPECT_EQ(reprint(tree, tree).text, text);
  }
}

TEST(Reprint, GivesTheTextAgainWhereEverythingIsTakenApart) {
  for (const std::string& text : files()) {
    const Tree tree = parsed(text);
    Changes changes(tree);
    for (const Item& item : tree.items) {
      for_each_construct(item, [&]<class X>(const X& one) {
        // What has no parts has only its numbers to be known by.
        constexpr bool kIsNumber =
            std::same_as<X, Number> || std::same_as<X, LayoutEntry> || std::same_as<X, LayoutNote>;
        if constexpr (!kIsNumber && requires { parts(one); }) changes.change<X>(one, [](X&) {});
      });
    }
    EXPECT_EQ(changes.done().text, text);
  }
}

// ---- single changes

const Let& let_of(const Tree& tree, std::size_t at) {
  return std::get<Assemblage>(tree.items.front()).lets.at(at);
}
const std::vector<Member>& members_of(const Tree& tree) {
  return std::get<Cooperate>(std::get<Assemblage>(tree.items.front()).body->what).members;
}

constexpr const char* kWritten = R"(// A file.

/// Drifts about,
/// as the wind goes.
assemblage A( curious : gain=.8 ) // by the author
{
    let  near = sense_obstacles(range=2m); // how far

    // what it is made of
    cooperate { curious : (Noise( ));
    /// Keeps away.
    1e0: AvoidStaticObstacles(near,   sphere = 1 m) /* not far */;
      // the end
    }
}
)";

TEST(Reprint, KeepsWhatWasNotChangedAsItIsWritten) {
  const std::string text = changed(kWritten, [](const Tree& tree, Changes& changes) {
    changes.replace(*members_of(tree)[1].weight, value("0.5"));
    changes.change<Assemblage>(std::get<Assemblage>(tree.items.front()), [](Assemblage& now) {
      now.lets.push_back({{"far", {}}, value("3"), "Away."});
    });
  });
  EXPECT_EQ(text, R"(// A file.

/// Drifts about,
/// as the wind goes.
assemblage A( curious : gain=.8 ) // by the author
{
    let  near = sense_obstacles(range=2m); // how far
  /// Away.
  let far = 3;

  // what it is made of
    cooperate { curious : (Noise( ));
    /// Keeps away.
    0.5: AvoidStaticObstacles(near,   sphere = 1 m) /* not far */;
      // the end
    }
}
)");
}

TEST(Reprint, LeavesCommentsOfWhatIsGoneAtTheNextWord) {
  const std::string text = changed(kWritten, [](const Tree& tree, Changes& changes) {
    changes.remove(let_of(tree, 0));
    changes.remove(members_of(tree)[1]);
  });
  EXPECT_EQ(text, R"(// A file.

/// Drifts about,
/// as the wind goes.
assemblage A( curious : gain=.8 ) // by the author
{
  // how far

    // what it is made of
    cooperate { curious : (Noise( ));
    /* not far */
    // the end
    }
}
)");
}

TEST(Reprint, LaysOutAllOfATextThatWasLaidOut) {
  const std::string text = changed(
      "assemblage A(a: gain = 1,  ///< one\n             b: gain = 2   ///< two\n) {\n  Noise();\n}\n",
      [](const Tree& tree, Changes& changes) {
        const auto& owner = std::get<Assemblage>(tree.items.front());
        changes.rename(owner.parameters[1].name, "another");
        changes.change<Parameter>(owner.parameters[1], [](Parameter& now) { now.help = "three"; });
        changes.change<Assemblage>(owner, [](Assemblage& now) {
          Parameter more;
          more.name.text = "c";
          more.type.text = "length";
          now.parameters.push_back(more);
        });
      });
  EXPECT_EQ(text,
            "assemblage A(a: gain = 1,        ///< one\n             another: gain = 2,  ///< three\n"
            "             c: length) {\n  Noise();\n}\n");
}

TEST(Reprint, TakesOverWhatStandsInAnotherText) {
  const Tree other = parsed("// Header.\n\n/// Says\n/// what.\nassemblage  B(){ // why\nNoise( );\n}\n");
  const std::string text = changed("assemblage A() { Stand() ; }\n", [&](const Tree&, Changes& changes) {
    changes.add(other.items.front(), nullptr);
  });
  EXPECT_EQ(text,
            "assemblage A() { Stand() ; }\n\n/// Says\n/// what.\nassemblage B() {  // why\n  Noise();\n}\n");
}

TEST(Reprint, SaysWhereWordsWent) {
  const Tree tree = parsed("assemblage A() {\n  let a = Noise();\n  a;\n}\n");
  Changes changes(tree);
  changes.replace(*std::get<Assemblage>(tree.items.front()).body, let_of(tree, 0).value);
  changes.remove(let_of(tree, 0));
  const Reprinted done = changes.done();
  EXPECT_EQ(done.text, "assemblage A() {\n  Noise();\n}\n");
  EXPECT_EQ(done.now(static_cast<std::uint32_t>(tree.source->text().find("Noise"))), done.text.find("Noise"));
  EXPECT_EQ(done.now(static_cast<std::uint32_t>(tree.source->text().find("a ="))), std::nullopt);
}

// ---- any changes

std::multiset<std::string> comments_of(const std::string& text) {
  std::multiset<std::string> out;
  for (const Comment& comment : lex(text).comments) {
    std::string words = text.substr(comment.span.begin, comment.span.end - comment.span.begin);
    while (words.ends_with(' ') || words.ends_with('\r')) words.pop_back();
    if (!words.starts_with("///")) out.insert(words);
  }
  return out;
}

class AnyChange {
 public:
  AnyChange(const Tree& tree, std::uint32_t seed) : changes_(tree), random_(seed) {
    for (const Item& item : tree.items) for_each_construct(item, [&]<class X>(const X& one) { note(one); });
  }
  const Changes& changes() const { return changes_; }

 private:
  bool rarely() { return random_() % 60 == 0; }

  // Where a `{` ends the selector, no block can stand.
  void note_selector(const Select& select) {
    for_each_construct(select.by, [&]<class X>(const X& one) {
      if constexpr (std::same_as<X, Expression>) in_selectors_.insert(&one);
    });
  }

  template <class X>
  void note(const X& one) {
    if constexpr (std::same_as<X, Select>) note_selector(one);
    if constexpr (std::same_as<X, Expression>) {
      const bool takes_block = !in_selectors_.contains(&one) && random_() % 2 == 0;
      if (rarely()) changes_.replace(one, value(takes_block ? "cooperate { 1: (b); }" : "Noise(a = 2 m)"));
    } else if constexpr (std::same_as<X, Name> || std::same_as<X, Let>) {
      if (rarely()) changes_.rename(one.name, "other");
    }
    if constexpr (std::same_as<X, Let> || std::same_as<X, Transition> || std::same_as<X, LayoutEntry> ||
                  std::same_as<X, LayoutNote> || std::same_as<X, Argument> || std::same_as<X, Parameter>) {
      if (rarely()) changes_.remove(one);
    }
    if constexpr (std::same_as<X, Parameter> || std::same_as<X, Let> || std::same_as<X, State>) {
      if (rarely()) changes_.change<X>(one, [](X& now) { now.help = "Says something else."; });
    }
    if constexpr (std::same_as<X, State>) {
      if (rarely()) changes_.change<X>(one, [](X& now) { now.is_final = !now.is_final; });
    }
    if constexpr (std::same_as<X, Call>) {
      if (rarely())
        changes_.change<X>(one, [](X& now) { now.arguments.push_back({{"more", {}}, value("2")}); });
    }
    if constexpr (std::same_as<X, Assemblage>) {
      if (random_() % 4 == 0)
        changes_.change<X>(one, [](X& now) { now.lets.push_back({{"more", {}}, value("a and not b"), ""}); });
    }
  }

  Changes changes_;
  std::set<const Expression*> in_selectors_;
  std::minstd_rand random_;
};

RC_GTEST_PROP(Reprint, AChangedTreeIsReadAgainAndNoCommentIsLost, ()) {
  const std::string& text = files()[*rc::gen::inRange<std::size_t>(0, files().size())];
  const Tree tree = parsed(text);
  const AnyChange any(tree, *rc::gen::inRange<std::uint32_t>(1, 1'000'000));
  const Reprinted done = any.changes().done();
  RC_LOG() << done.text;
  text::Diagnostics sink;
  const Tree again = parse(std::make_shared<const text::Source>("a.cdl", done.text), sink);
  RC_ASSERT(!sink.has_errors());
  RC_ASSERT(print(again) == print(any.changes().tree_after()));
  RC_ASSERT(laid_out(text) != text || laid_out(done.text) == done.text);
  RC_ASSERT(comments_of(done.text) == comments_of(text));
  for (const Token& token : lex(text).tokens) {
    if (const auto now = done.now(token.span.begin)) RC_ASSERT(*now <= done.text.size());
  }
}

}  // namespace
}  // namespace mlab::cdl
