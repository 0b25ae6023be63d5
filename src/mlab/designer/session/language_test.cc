// What the designer answers about the text, and what the compiler says in the background.

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/designer.pb.h"
#include "mlab/designer/testing/browser.h"

namespace mlab::designer {
namespace {

using testing::Browser;

constexpr const char* kUsing =
    "use \"skills.cdl\";\n\nassemblage A() {\n  cooperate {\n    1: Roam();\n    1: Noisee();\n  }\n}\n";
constexpr const char* kSkills =
    "/// Goes about.\nassemblage Roam(urge: gain = 1) {\n  cooperate {\n    urge: Noise();\n  }\n}\n";

std::uint32_t place_of(const std::string& text, const std::string& what) {
  return static_cast<std::uint32_t>(text.find(what) + 1);
}

Answer asked(Browser& browser, const std::string& document, AskLanguage::What what, std::uint32_t cursor) {
  return browser.ask([&](ToDesigner& m) {
    m.mutable_ask_language()->set_document(document);
    m.mutable_ask_language()->set_what(what);
    m.mutable_ask_language()->set_cursor(cursor);
  });
}

bool has_component(const Palette& palette, const std::string& name) {
  return std::ranges::any_of(palette.components(), [&](const Component& one) { return one.name() == name; });
}

TEST(DesignerLanguage, CompletesWhatIsTyped) {
  Browser browser;
  browser.write("skills.cdl", kSkills);
  browser.write("a.cdl", kUsing);
  browser.open("a.cdl");
  const Answer answer = asked(browser, "a.cdl", AskLanguage::COMPLETE, place_of(kUsing, "Roam();") + 1);
  ASSERT_TRUE(answer.ok()) << answer.error();
  const auto& items = answer.completions().items();
  const auto roam = std::ranges::find_if(items, [](const auto& one) { return one.text() == "Roam"; });
  ASSERT_NE(roam, items.end());
  EXPECT_EQ(roam->kind(), "assemblage");
  EXPECT_NE(roam->help().find("Goes about."), std::string::npos) << roam->help();
  EXPECT_EQ(answer.completions().begin() + 1, place_of(kUsing, "Roam();"));
}

TEST(DesignerLanguage, OffersNamesOfFilesOfTheProject) {
  Browser browser;
  browser.write("skills.cdl", kSkills);
  const std::string text = "use \"sk\";\n";
  browser.write("a.cdl", text);
  browser.open("a.cdl");
  const Answer answer = asked(browser, "a.cdl", AskLanguage::COMPLETE, place_of(text, "\";") - 1);
  ASSERT_TRUE(answer.ok()) << answer.error();
  const auto& items = answer.completions().items();
  EXPECT_TRUE(std::ranges::any_of(items, [](const auto& one) { return one.text() == "skills.cdl"; }));
}

TEST(DesignerLanguage, SaysWhatStandsUnderThePointer) {
  Browser browser;
  browser.write("skills.cdl", kSkills);
  browser.write("a.cdl", kUsing);
  browser.open("a.cdl");
  const Answer answer = asked(browser, "a.cdl", AskLanguage::HOVER, place_of(kUsing, "Roam();"));
  ASSERT_TRUE(answer.ok()) << answer.error();
  EXPECT_NE(answer.hover().markdown().find("Goes about."), std::string::npos) << answer.hover().markdown();
  EXPECT_EQ(answer.hover().end() - answer.hover().begin(), 4U);
  EXPECT_EQ(asked(browser, "a.cdl", AskLanguage::HOVER, 0xffffffffU).hover().markdown(), "");
}

TEST(DesignerLanguage, LeadsToWhatIsDeclared) {
  Browser browser;
  browser.write("skills.cdl", kSkills);
  browser.write("a.cdl", kUsing);
  browser.open("a.cdl");
  const Answer other = asked(browser, "a.cdl", AskLanguage::DEFINITION, place_of(kUsing, "Roam();"));
  ASSERT_TRUE(other.ok()) << other.error();
  EXPECT_EQ(other.location().document(), "skills.cdl");
  EXPECT_EQ(other.location().node(), "Roam");
  EXPECT_EQ(std::string(kSkills).substr(other.location().begin(), 4), "Roam");

  const std::string wander = "assemblage A() {\n  Wander()\n}\n";
  browser.type("a.cdl", wander);
  const Answer library = asked(browser, "a.cdl", AskLanguage::DEFINITION, place_of(wander, "Wander"));
  ASSERT_TRUE(library.ok()) << library.error();
  EXPECT_EQ(library.location().document(), "library:assemblages/wander.cdl");
  EXPECT_FALSE(asked(browser, "a.cdl", AskLanguage::DEFINITION, place_of(wander, "assemblage")).ok());
}

TEST(DesignerLanguage, TellsThePageOfAPlaceOfTheText) {
  Browser browser;
  browser.write("skills.cdl", kSkills);
  browser.open("skills.cdl");
  const Answer answer = asked(browser, "skills.cdl", AskLanguage::PAGE, place_of(kSkills, "Noise"));
  ASSERT_TRUE(answer.ok()) << answer.error();
  EXPECT_EQ(answer.location().page(), "Roam");
  EXPECT_EQ(answer.location().node(), "Noise");
}

TEST(DesignerLanguage, OffersMendsThatAreOneStepOfUndo) {
  Browser browser;
  browser.write("skills.cdl", kSkills);
  browser.write("a.cdl", kUsing);
  browser.open("a.cdl");
  ASSERT_TRUE(browser.waits_for([&] {
    const Document& seen = browser.seen("a.cdl");
    return seen.problems_size() == 1 && seen.problems(0).fixes_size() == 1;
  }));
  const Document document = browser.document("a.cdl");
  const Fix& fix = document.problems(0).fixes(0);
  EXPECT_EQ(fix.title(), "write `Noise`");
  ASSERT_EQ(fix.splices_size(), 1);
  const Answer answer = browser.ask([&](ToDesigner& m) {
    EditText& edit = *m.mutable_edit_text();
    edit.set_document("a.cdl");
    edit.set_revision(document.revision());
    edit.set_begin(fix.splices(0).begin());
    edit.set_end(fix.splices(0).end());
    edit.set_text(fix.splices(0).text());
    edit.set_name(fix.title());
  });
  ASSERT_TRUE(answer.ok()) << answer.error();
  ASSERT_TRUE(browser.waits_for([&] {
    const Document& seen = browser.seen("a.cdl");
    return seen.problems_size() == 0 && seen.compile_ms() >= 0.0;
  }));
  EXPECT_EQ(browser.document("a.cdl").undo(), "write `Noise`");
  browser.ask([](ToDesigner& m) { m.mutable_undo()->set_document("a.cdl"); });
  EXPECT_EQ(browser.document("a.cdl").text(), kUsing);
}

TEST(DesignerLanguage, TellsWhatOnlyLoweringFinds) {
  Browser browser;
  browser.write("a.cdl", "robot R {\n  movement = Noise();\n}\n");
  browser.open("a.cdl");
  ASSERT_TRUE(browser.waits_for([&] { return browser.seen("a.cdl").problems_size() > 0; }));
  EXPECT_LT(browser.document("a.cdl").compile_ms(), 0.0);
  browser.type("a.cdl", "robot R is MRV2 {\n  movement = Noise();\n}\n");
  ASSERT_TRUE(browser.waits_for([&] { return browser.seen("a.cdl").compile_ms() >= 0.0; }));
}

TEST(DesignerLanguage, TheNewestTextWins) {
  Browser browser;
  browser.write("a.cdl", "assemblage A() {\n  Noise()\n}\n");
  browser.open("a.cdl");
  for (int i = 0; i < 50; ++i)
    browser.type("a.cdl", "assemblage A() {\n  Noise" + std::to_string(i) + "()\n}\n");
  browser.type("a.cdl", "assemblage A() {\n  Noisy()\n}\n");
  ASSERT_TRUE(browser.waits_for([&] {
    const Document& seen = browser.seen("a.cdl");
    return seen.problems_size() == 1 &&
           seen.problems(0).diagnostic().message().find("Noisy") != std::string::npos;
  }));
}

TEST(DesignerLanguage, TellsWhatTheCompilerSaysOfProcedures) {
  Browser browser;
  browser.set_include_root(base::source_folder() + "/src");
  browser.start();
  browser.write(
      "own.cnl",
      "procedure Vector Twirl with\n  double rate = 1;\nheader\nbody\n  output = nonsense;\npend\n");
  browser.write("a.cdl", "use \"own.cnl\";\n\nassemblage A() {\n  Twirl(rate = 2)\n}\n");
  browser.open("a.cdl");
  ASSERT_TRUE(browser.waits_for([&] { return browser.seen("a.cdl").problems_size() > 0; }));
  const console::Diagnostic said = browser.document("a.cdl").problems(0).diagnostic();
  EXPECT_EQ(said.kind(), "cpp-error");
  EXPECT_EQ(said.line(), 5U);
  EXPECT_EQ(said.document(), "own.cnl");
  // A file that it uses is mended outside.
  browser.write(
      "own.cnl",
      "procedure Vector Twirl with\n  double rate = 1;\nheader\nbody\n  output = Vector{};\npend\n");
  ASSERT_TRUE(browser.waits_for([&] { return browser.seen("a.cdl").problems_size() == 0; }));
}

TEST(DesignerLanguage, DoesNotCompileForPeopleElsewhereWhatCameLaterAndSaysWhatWouldAllowIt) {
  const std::string wrong =
      "procedure Vector Twirl with\n  double rate = 1;\nheader\nbody\n  output = nonsense;\npend\n";
  Browser browser;
  browser.set_include_root(base::source_folder() + "/src");
  browser.set_permission(cell::testing::permitted_elsewhere({wrong}));
  browser.start();
  browser.write("known.cnl", wrong);
  browser.write("new.cnl", "// new\n" + wrong);
  for (const std::string name : {"known", "new"}) {
    const std::string document = name + "_user.cdl";
    browser.write(document, "assemblage A() {\n  Noise()\n}\n");
    browser.open(document);
    browser.type(document, "use \"" + name + ".cnl\";\n\nassemblage A() {\n  Twirl(rate = 2)\n}\n");
    ASSERT_TRUE(browser.waits_for([&] { return browser.seen(document).problems_size() > 0; })) << name;
  }
  EXPECT_EQ(browser.document("known_user.cdl").problems(0).diagnostic().kind(), "cpp-error");
  const console::Diagnostic refused = browser.document("new_user.cdl").problems(0).diagnostic();
  EXPECT_EQ(refused.kind(), "code-not-allowed");
  EXPECT_NE(refused.message().find("compiled only with --allow-native"), std::string::npos)
      << refused.message();
  // Nor does it write any.
  const Answer saved = browser.ask([](ToDesigner& m) {
    m.mutable_save()->set_document("new_user.cdl");
    m.mutable_save()->set_as("typed.cnl");
  });
  EXPECT_FALSE(saved.ok());
  EXPECT_NE(saved.error().find("ends in `.cdl`"), std::string::npos) << saved.error();
}

TEST(DesignerLanguage, OffersWhatFilesBesideDeclareAndUsesThem) {
  Browser browser;
  browser.write("skills.cdl", kSkills);
  browser.write(
      "own.cnl",
      "procedure Vector Twirl with\n  double rate = 1;\nheader\nbody\n  output = Vector{};\npend\n");
  browser.write("clash.cdl", "assemblage A() {\n  Noise()\n}\nassemblage Other() {\n  Noise()\n}\n");
  browser.write("a.cdl", "/// Does nothing yet.\nassemblage A() {\n}\n");
  browser.open("a.cdl");
  const Palette palette = browser.palette("a.cdl");
  EXPECT_TRUE(has_component(palette, "Roam"));
  EXPECT_TRUE(has_component(palette, "Twirl"));
  EXPECT_FALSE(has_component(palette, "Other")) << "its file declares `A` as well";
  const Answer answer = browser.ask([](ToDesigner& m) {
    m.mutable_edit()->set_document("a.cdl");
    for (const char* component : {"Roam", "Twirl"}) {
      Place& place = *m.mutable_edit()->add_changes()->mutable_place();
      place.set_page("A");
      place.set_component(component);
    }
  });
  ASSERT_TRUE(answer.ok()) << answer.error();
  EXPECT_EQ(browser.document("a.cdl").text(),
            "use \"skills.cdl\";\nuse \"own.cnl\";\n\n/// Does nothing yet.\nassemblage A() {\n"
            "  let Roam = Roam();\n  let Twirl = Twirl();\n}\n");
  browser.ask([](ToDesigner& m) { m.mutable_undo()->set_document("a.cdl"); });
  EXPECT_EQ(browser.document("a.cdl").text(), "/// Does nothing yet.\nassemblage A() {\n}\n");
}

TEST(DesignerLanguage, NoticesThatAFileThatItUsesHasCome) {
  Browser browser;
  browser.write("a.cdl", kUsing);
  browser.open("a.cdl");
  ASSERT_TRUE(browser.waits_for([&] { return browser.seen("a.cdl").problems_size() > 0; }));
  EXPECT_EQ(browser.document("a.cdl").problems(0).diagnostic().kind(), "cannot-read");
  browser.write("skills.cdl", kSkills);
  ASSERT_TRUE(browser.waits_for([&] {
    const Document& seen = browser.seen("a.cdl");
    return seen.problems_size() == 1 && seen.problems(0).node() == "Noisee";
  }));
}

TEST(DesignerLanguage, WhatIsSavedToTheLibraryIsInThePaletteOfOthers) {
  Browser browser;
  browser.write("skills.cdl", kSkills);
  browser.write("below/a.cdl", "assemblage A() {\n}\n");
  browser.open("skills.cdl");
  browser.open("below/a.cdl");
  EXPECT_FALSE(has_component(browser.palette("below/a.cdl"), "Roam"));
  const Answer answer = browser.ask([](ToDesigner& m) {
    m.mutable_save()->set_document("skills.cdl");
    m.mutable_save()->set_library("Roam");
  });
  ASSERT_TRUE(answer.ok()) << answer.error();
  EXPECT_EQ(browser.read("library.cdl"), kSkills);
  EXPECT_TRUE(has_component(browser.palette("below/a.cdl"), "Roam"));
  browser.ask([](ToDesigner& m) {
    m.mutable_edit()->set_document("below/a.cdl");
    Place& place = *m.mutable_edit()->add_changes()->mutable_place();
    place.set_page("A");
    place.set_component("Roam");
  });
  EXPECT_EQ(browser.document("below/a.cdl").text(),
            "use \"../library.cdl\";\n\nassemblage A() {\n  let Roam = Roam();\n}\n");
}

TEST(DesignerLanguage, NothingIsSavedToALibraryThatIsNotSavedOrThatOthersChanged) {
  Browser browser;
  browser.write("skills.cdl", kSkills);
  browser.write("library.cdl", "// library\n");
  browser.open("skills.cdl");
  browser.open("library.cdl");
  const auto save = [&] {
    return browser.ask([](ToDesigner& m) {
      m.mutable_save()->set_document("skills.cdl");
      m.mutable_save()->set_library("Roam");
    });
  };
  browser.write("library.cdl", "// theirs\n");
  save();  // refused where the change has not been seen yet
  EXPECT_TRUE(browser.read("library.cdl").starts_with("// theirs\n"));
  ASSERT_TRUE(
      browser.waits_for([&] { return browser.seen("library.cdl").text().starts_with("// theirs\n"); }));
  browser.type("library.cdl", "// theirs\n// unfinished\n");
  const std::string before = browser.read("library.cdl");
  const Answer unsaved = save();
  EXPECT_FALSE(unsaved.ok());
  EXPECT_TRUE(unsaved.error().contains("save it first")) << unsaved.error();
  EXPECT_EQ(browser.read("library.cdl"), before);
  browser.ask([](ToDesigner& m) { m.mutable_close()->set_document("library.cdl"); });
  EXPECT_FALSE(save().ok()) << "what is kept of it is not saved either";
  browser.open("library.cdl");
  EXPECT_TRUE(browser.ask([](ToDesigner& m) { m.mutable_save()->set_document("library.cdl"); }).ok());
  const Answer now = save();
  EXPECT_TRUE(now.ok()) << now.error();
  EXPECT_EQ(browser.read("library.cdl"), std::string("// theirs\n// unfinished\n\n") + kSkills);
  EXPECT_FALSE(browser.document("library.cdl").is_dirty());
}

}  // namespace
}  // namespace mlab::designer
