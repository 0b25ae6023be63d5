#include "mlab/lsp/server.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <nlohmann/json.hpp>

#include "mlab/base/testing/processor_time.h"
#include "mlab/base/testing/source_folder.h"

namespace mlab::lsp {
namespace {

using Json = nlohmann::json;

class ServerTest : public ::testing::Test {
 protected:
  ServerTest()
      : server_({"1", {}, base::source_folder() + "/library"},
                [this](const std::string& m) { got_.push_back(Json::parse(m)); }) {}

  Json ask(const std::string& method, const Json& params) {
    const int id = ++last_id_;
    server_.receive(Json{{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", params}}.dump());
    for (const Json& one : got_) {
      if (one.contains("id") && one["id"] == id) return one;
    }
    return nullptr;
  }
  Json result(const std::string& method, const Json& params) { return ask(method, params)["result"]; }
  void tell(const std::string& method, const Json& params) {
    server_.receive(Json{{"jsonrpc", "2.0"}, {"method", method}, {"params", params}}.dump());
  }
  void initialize(const Json& more = Json::object()) {
    Json params = {{"processId", nullptr}, {"rootUri", nullptr}, {"capabilities", Json::object()}};
    params.update(more);
    result("initialize", params);
    tell("initialized", Json::object());
  }
  void open(const std::string& uri, const std::string& text, const std::string& id = "") {
    tell("textDocument/didOpen",
         {{"textDocument", {{"uri", uri}, {"languageId", id}, {"version", 1}, {"text", text}}}});
  }
  static Json at(const std::string& uri, int line, int character) {
    return {{"textDocument", {{"uri", uri}}}, {"position", {{"line", line}, {"character", character}}}};
  }
  /// The diagnostics that were published last for a text.
  Json diagnostics(const std::string& uri) {
    while (auto check = server_.next_check())
      server_.tell(*check, assist::problems(check->text, check->around));
    Json out;
    for (const Json& one : got_) {
      if (one.value("method", "") == "textDocument/publishDiagnostics" && one["params"]["uri"] == uri)
        out = one["params"]["diagnostics"];
    }
    return out;
  }

  std::vector<Json> got_;
  Server server_;
  int last_id_ = 0;
};

constexpr const char* kUri = "file:///nowhere/x.cdl";
constexpr const char* kText = "assemblage A(gain: gain = 1) {\n  cooperate {\n    gain: Noise();\n  }\n}\n";

TEST_F(ServerTest, AnswersInTheOrderOfTheProtocol) {
  EXPECT_EQ(ask("textDocument/hover", at(kUri, 0, 0))["error"]["code"], -32002);
  initialize();
  EXPECT_EQ(ask("initialize", Json::object())["error"]["code"], -32600);
  EXPECT_EQ(ask("textDocument/madeUp", Json::object())["error"]["code"], -32601);
  EXPECT_EQ(ask("textDocument/hover", at(kUri, 0, 0))["error"]["code"], -32602) << "not open";
  EXPECT_EQ(ask("textDocument/hover", 7)["error"]["code"], -32602);
  const std::size_t before = got_.size();
  tell("$/cancelRequest", {{"id", 1}});
  tell("made/up", Json::object());
  EXPECT_EQ(got_.size(), before);
  EXPECT_TRUE(result("shutdown", nullptr).is_null());
  EXPECT_EQ(ask("textDocument/hover", at(kUri, 0, 0))["error"]["code"], -32600);
  EXPECT_EQ(server_.exit_status(), 0);
  tell("exit", nullptr);
  EXPECT_TRUE(server_.is_over());
}

// What was found until then may be a part of the whole.
TEST(ServerThatIsAsked, DoesNotAnswerWhatIsCancelledWhileItIsAtIt) {
  std::vector<Json> got;
  int looks = 0;
  Options options{"1", {}, base::source_folder() + "/library"};
  options.is_cancelled = [&](const std::string& id) { return id == "2" && ++looks > 1; };
  Server server(std::move(options), [&](const std::string& m) { got.push_back(Json::parse(m)); });
  const auto say = [&](const Json& message) { server.receive(message.dump()); };
  say({{"jsonrpc", "2.0"}, {"id", 1}, {"method", "initialize"}, {"params", Json::object()}});
  say({{"jsonrpc", "2.0"},
       {"method", "textDocument/didOpen"},
       {"params",
        {{"textDocument", {{"uri", kUri}, {"languageId", "cdl"}, {"version", 1}, {"text", kText}}}}}});
  say({{"jsonrpc", "2.0"},
       {"id", 2},
       {"method", "textDocument/references"},
       {"params",
        {{"textDocument", {{"uri", kUri}}},
         {"position", {{"line", 0}, {"character", 13}}},
         {"context", {{"includeDeclaration", true}}}}}});
  EXPECT_GT(looks, 1);
  EXPECT_EQ(got.back()["id"], 2);
  EXPECT_EQ(got.back()["error"]["code"], -32800) << got.back();
}

TEST_F(ServerTest, AnExitWithoutShutdownIsAFailure) {
  initialize();
  tell("exit", nullptr);
  EXPECT_TRUE(server_.is_over());
  EXPECT_EQ(server_.exit_status(), 1);
}

TEST_F(ServerTest, RefusesWhatIsNoMessage) {
  server_.receive("{ nothing");
  EXPECT_EQ(got_.back()["error"]["code"], -32700);
  EXPECT_TRUE(got_.back()["id"].is_null());
  for (const char* text :
       {"[]", "7", "{}", R"({"id":1})", R"({"jsonrpc":"2.0","id":{},"method":"initialize"})"}) {
    server_.receive(text);
    EXPECT_EQ(got_.back()["error"]["code"], -32600) << text;
  }
  const std::size_t before = got_.size();
  server_.receive(R"({"jsonrpc":"2.0","id":3,"result":null})");
  EXPECT_EQ(got_.size(), before) << "an answer to nothing";
}

TEST_F(ServerTest, TellsWhatIsWrongAndHowToMendIt) {
  initialize();
  open(kUri, "assemblage A() {\n  Noisee()\n}\n");
  const Json wrong = diagnostics(kUri);
  ASSERT_EQ(wrong.size(), 1U) << wrong;
  EXPECT_EQ(wrong[0]["code"], "unknown-call");
  EXPECT_EQ(wrong[0]["range"]["start"], (Json{{"line", 1}, {"character", 2}}));
  const Json fixes = result("textDocument/codeAction", {{"textDocument", {{"uri", kUri}}},
                                                        {"range", wrong[0]["range"]},
                                                        {"context", {{"diagnostics", wrong}}}});
  ASSERT_EQ(fixes.size(), 1U) << fixes;
  EXPECT_EQ(fixes[0]["title"], "write `Noise`");
  const Json edit = fixes[0]["edit"]["changes"][kUri][0];
  EXPECT_EQ(edit["newText"], "Noise");
  tell("textDocument/didChange",
       {{"textDocument", {{"uri", kUri}, {"version", 2}}},
        {"contentChanges", {{{"range", edit["range"]}, {"text", edit["newText"]}}}}});
  EXPECT_TRUE(diagnostics(kUri).empty());
  tell("textDocument/didClose", {{"textDocument", {{"uri", kUri}}}});
  EXPECT_TRUE(got_.back()["params"]["diagnostics"].empty());
}

TEST_F(ServerTest, MakesChangesOneAfterTheOther) {
  initialize();
  open(kUri, "// \xf0\x9f\x98\x80 \xc3\xa9\n");
  const auto change = [](int line, int from, int to, const char* text) {
    return Json{
        {"range",
         {{"start", {{"line", line}, {"character", from}}}, {"end", {{"line", line}, {"character", to}}}}},
        {"text", text}};
  };
  tell("textDocument/didChange",
       {{"textDocument", {{"uri", kUri}, {"version", 2}}},
        {"contentChanges",
         {change(0, 6, 7, "e\nassemblage A() {"), change(1, 16, 16, " Noise() }"), change(0, 3, 5, "x")}}});
  const Json symbols = result("textDocument/documentSymbol", {{"textDocument", {{"uri", kUri}}}});
  ASSERT_EQ(symbols.size(), 1U);
  EXPECT_EQ(symbols[0]["name"], "A");
  EXPECT_EQ(symbols[0]["range"]["end"], (Json{{"line", 1}, {"character", 26}}));
  EXPECT_TRUE(diagnostics(kUri).empty()) << diagnostics(kUri);
}

TEST_F(ServerTest, MakesAllChangesOfAMessageOrNone) {
  initialize();
  open(kUri, "assemblage A() { Noise() }\n");
  tell("textDocument/didChange", {{"textDocument", {{"uri", kUri}, {"version", 2}}},
                                  {"contentChanges", {{{"text", "assemblage B() {"}}, {{"text", 7}}}}});
  ASSERT_EQ(got_.back()["method"], "window/logMessage");
  const Json symbols = result("textDocument/documentSymbol", {{"textDocument", {{"uri", kUri}}}});
  ASSERT_EQ(symbols.size(), 1U);
  EXPECT_EQ(symbols[0]["name"], "A");
  EXPECT_TRUE(diagnostics(kUri).empty());
  EXPECT_EQ(got_.back()["params"]["version"], 1) << "that is the version it still has";
}

TEST_F(ServerTest, CompletesHoversAndHelpsWithCalls) {
  initialize({{"capabilities",
               {{"textDocument", {{"completion", {{"completionItem", {{"snippetSupport", true}}}}}}}}}});
  open(kUri, kText);
  const Json list = result("textDocument/completion", at(kUri, 2, 15));
  const Json& first = list["items"][0];
  EXPECT_EQ(first["label"], "Noise");
  EXPECT_EQ(first["textEdit"]["newText"], "Noise") << "the parentheses are there";
  EXPECT_EQ(first["textEdit"]["range"]["start"]["character"], 10);
  const Json inputs = result("textDocument/completion", at(kUri, 2, 16));
  EXPECT_EQ(inputs["items"][0]["label"], "persistence");
  const Json hover = result("textDocument/hover", at(kUri, 2, 12));
  EXPECT_NE(hover["contents"]["value"].get<std::string>().find("procedure Noise("), std::string::npos);
  const Json help = result("textDocument/signatureHelp", at(kUri, 2, 16));
  EXPECT_EQ(help["activeParameter"], 0);
  EXPECT_EQ(help["signatures"][0]["parameters"].size(), 1U);
}

TEST_F(ServerTest, SaysInTheLogWhichNotificationItIgnored) {
  initialize();
  tell("textDocument/didOpen", {{"textDocument", 7}});
  ASSERT_EQ(got_.back()["method"], "window/logMessage");
  EXPECT_TRUE(
      got_.back()["params"]["message"].get<std::string>().starts_with("textDocument/didOpen was ignored"));
}

TEST_F(ServerTest, FindsAndRenames) {
  initialize();
  open(kUri, kText);
  const Json place = result("textDocument/definition", at(kUri, 2, 5));
  EXPECT_EQ(place["range"]["start"], (Json{{"line", 0}, {"character", 13}}));
  EXPECT_EQ(result("textDocument/references", at(kUri, 2, 5)).size(), 2U);
  Json params = at(kUri, 2, 5);
  params["context"] = {{"includeDeclaration", false}};
  EXPECT_EQ(result("textDocument/references", params).size(), 1U);
  EXPECT_EQ(result("textDocument/prepareRename", at(kUri, 2, 5))["placeholder"], "gain");
  EXPECT_TRUE(result("textDocument/prepareRename", at(kUri, 2, 12)).is_null()) << "of the library";
  params["newName"] = "weight";
  const Json edits = result("textDocument/rename", params)["changes"][kUri];
  ASSERT_EQ(edits.size(), 2U);
  EXPECT_EQ(edits[0]["newText"], "weight");
  params["newName"] = "2x";
  EXPECT_EQ(ask("textDocument/rename", params)["error"]["code"], -32803);
}

TEST_F(ServerTest, FindsManyUsesInTimeThatGrowsWithThem) {
  initialize();
  constexpr std::size_t kFew = base::kIsSlowBuild ? 125 : 2000;
  const auto uri_of = [](std::size_t count) { return fmt::format("file:///nowhere/{}.cdl", count); };
  for (const std::size_t count : {kFew, 8 * kFew}) {
    std::string text = "assemblage A(gain: gain = 1) {\n  cooperate {\n";
    for (std::size_t i = 0; i < count; ++i) text += "    gain: Noise();\n";
    open(uri_of(count), text + "  }\n}\n");
  }
  const auto ask = [&](std::size_t count) {
    EXPECT_EQ(result("textDocument/references", at(uri_of(count), 2, 5)).size(), count + 1);
  };
  EXPECT_LT(base::growth(ask, kFew), base::kGrowthOfLine);
}

TEST_F(ServerTest, LeadsIntoTheLibrary) {
  initialize();
  open(kUri, "assemblage A() {\n  AvoidDynamicObstacles()\n}\n");
  const Json place = result("textDocument/definition", at(kUri, 1, 5));
  EXPECT_TRUE(place["uri"].get<std::string>().ends_with("library/assemblages/avoid_dynamic_obstacles.cdl"))
      << place;
}

TEST_F(ServerTest, UsesTextsThatAreNotSaved) {
  initialize();
  open("file:///nowhere/skills.cdl", "assemblage Mine() {\n  Noise()\n}\n");
  open(kUri, "use \"skills.cdl\";\nassemblage A() {\n  Mine()\n}\n");
  EXPECT_TRUE(diagnostics(kUri).empty()) << diagnostics(kUri);
  const Json place = result("textDocument/definition", at(kUri, 2, 3));
  EXPECT_EQ(place["uri"], "file:///nowhere/skills.cdl");
  Json params = at(kUri, 2, 3);
  params["newName"] = "Ours";
  EXPECT_EQ(result("textDocument/rename", params)["changes"].size(), 2U);
  open("file:///nowhere/map.odl", "CONTROL MEASURES:\nPP Charlie 10 10\n");
  const char* mission = "file:///nowhere/m.mdl";
  open(mission, "OVERLAY map.odl\nUNIT <a> ROBOT\nCOMMAND LIST:\n1. UNIT a START PP-Charlie\n");
  EXPECT_TRUE(diagnostics(mission).empty()) << diagnostics(mission);
  EXPECT_EQ(result("textDocument/definition", at(mission, 3, 22))["uri"], "file:///nowhere/map.odl");
  Json place_name = at(mission, 3, 22);
  place_name["newName"] = "Delta";
  const Json changes = result("textDocument/rename", place_name)["changes"];
  EXPECT_EQ(changes.size(), 2U) << changes;
  EXPECT_EQ(changes[mission][0]["range"]["start"]["character"], 19) << "behind `PP-`";
}

/// A folder with files on disk that are not open.
class FolderTest : public ServerTest {
 protected:
  FolderTest() : folder_(::testing::TempDir() + "mlab_lsp_folder_" + std::to_string(::getpid())) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_ + "/inner");
    put("skills.cdl",
        "/// Goes about.\nassemblage Roam(urge: gain = 1) {\n  cooperate { urge: Noise(); }\n}\n");
    put("robots.cdl",
        "use \"skills.cdl\";\nrobot Scout(urge: gain = 0.5) {\n  movement = Roam(urge = urge);\n}\n");
    put("map.odl", "CONTROL MEASURES:\nPP Charlie 10 10\n");
    put("inner/m.mdl",
        "OVERLAY ../map.odl\nNEW-ROBOT scout \"../robots.cdl\" (urge = 0.7)\nUNIT <a> scout\n"
        "COMMAND LIST:\n 1. UNIT a START PP-Charlie\n");
  }
  ~FolderTest() override { std::filesystem::remove_all(folder_); }
  void put(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ + "/" + name) << text;
  }
  std::string uri(const std::string& name) const { return "file://" + folder_ + "/" + name; }
  void start(const Json& capabilities = Json::object()) {
    initialize({{"workspaceFolders", Json::array({{{"uri", "file://" + folder_}, {"name", "x"}}})},
                {"capabilities", capabilities}});
  }
  void open_file(const std::string& name) {
    std::ifstream in(folder_ + "/" + name);
    open(uri(name), std::string(std::istreambuf_iterator<char>(in), {}));
  }

  std::string folder_;
};

TEST_F(FolderTest, FindsUsesInFilesThatAreNotOpen) {
  start();
  open_file("skills.cdl");
  Json params = at(uri("skills.cdl"), 1, 12);
  EXPECT_EQ(result("textDocument/references", params).size(), 2U);
  params["context"] = {{"includeDeclaration", false}};
  const Json found = result("textDocument/references", params);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0]["uri"], uri("robots.cdl"));
  EXPECT_EQ(result("textDocument/references", at(uri("skills.cdl"), 2, 22)).size(), 1U) << "of the library";
  put("other.cdl", "use \"skills.cdl\";\nassemblage B() {\n  Roam()\n}\n");
  EXPECT_EQ(result("textDocument/references", params).size(), 2U) << "which has come meanwhile";
  std::filesystem::remove(folder_ + "/other.cdl");
  EXPECT_EQ(result("textDocument/references", params).size(), 1U);
}

TEST_F(FolderTest, RenamesInFilesThatAreNotOpenAndAsksForALookFirst) {
  start({{"workspace",
          {{"workspaceEdit", {{"documentChanges", true}, {"changeAnnotationSupport", Json::object()}}}}}});
  open_file("robots.cdl");
  Json params = at(uri("robots.cdl"), 1, 13);
  params["newName"] = "need";
  const Json edit = result("textDocument/rename", params);
  ASSERT_EQ(edit["documentChanges"].size(), 2U) << edit;
  EXPECT_EQ(edit["documentChanges"][0]["textDocument"], (Json{{"uri", uri("robots.cdl")}, {"version", 1}}));
  EXPECT_EQ(edit["documentChanges"][1]["textDocument"],
            (Json{{"uri", uri("inner/m.mdl")}, {"version", nullptr}}));
  const std::string annotation = edit["documentChanges"][0]["edits"][0]["annotationId"];
  EXPECT_EQ(edit["changeAnnotations"][annotation]["needsConfirmation"], true);
  params["newName"] = "two words";
  EXPECT_EQ(ask("textDocument/rename", params)["error"]["code"], -32803);
}

TEST_F(FolderTest, SaysWhatIsReadOnlyAndWhatElseFollows) {
  if (::geteuid() == 0) GTEST_SKIP() << "who may do everything can write everywhere";
  std::filesystem::permissions(folder_ + "/inner/m.mdl", std::filesystem::perms::owner_read);
  start();
  open_file("robots.cdl");
  Json params = at(uri("robots.cdl"), 1, 13);
  params["newName"] = "need";
  EXPECT_EQ(result("textDocument/rename", params)["changes"].size(), 1U);
  const auto shown = std::ranges::find_if(
      got_, [](const Json& one) { return one.value("method", "") == "window/showMessage"; });
  ASSERT_NE(shown, got_.end());
  EXPECT_TRUE((*shown)["params"]["message"].get<std::string>().contains("is read only")) << *shown;
}

TEST_F(FolderTest, SaysThatItDidNotLookEverywhere) {
  start();
  open_file("skills.cdl");
  Json params = at(uri("skills.cdl"), 1, 17);  // a parameter: nothing else follows
  params["newName"] = "need";
  const auto shown = [&] {
    got_.clear();
    result("textDocument/rename", params);
    return std::ranges::any_of(got_, [](const Json& one) {
      return one.value("method", "") == "window/showMessage" &&
             one["params"]["message"].get<std::string>().find("8 folders deep") != std::string::npos;
    });
  };
  EXPECT_FALSE(shown());
  std::filesystem::create_directories(folder_ + "/1/2/3/4/5/6/7/8/9");
  EXPECT_TRUE(shown());
}

TEST_F(FolderTest, FollowsNoLinkOutOfTheFolder) {
  const std::string outside = folder_ + "_outside.cdl";
  std::ofstream(outside) << "assemblage Outside() {\n  Noise()\n}\n";
  std::filesystem::create_symlink(outside, folder_ + "/link.cdl");
  std::filesystem::create_symlink(folder_ + "/skills.cdl", folder_ + "/inner/link.cdl");
  start();
  EXPECT_EQ(result("workspace/symbol", {{"query", "Outside"}}).size(), 0U);
  EXPECT_GE(result("workspace/symbol", {{"query", "Roam"}}).size(), 1U);
  std::filesystem::remove(outside);
}

TEST_F(FolderTest, FindsSymbolsOfTheWholeFolder) {
  start();
  const auto names = [&](const std::string& query) {
    std::vector<std::string> out;
    for (const Json& one : result("workspace/symbol", {{"query", query}})) out.push_back(one["name"]);
    return out;
  };
  EXPECT_EQ(names("roam"), (std::vector<std::string>{"Roam"}));
  EXPECT_EQ(names("urge").size(), 2U);
  EXPECT_EQ(names("char"), (std::vector<std::string>{"Charlie"}));
  EXPECT_EQ(names("").size(), 8U);
  EXPECT_TRUE(names("noise").empty()) << "what is only used";
  const Json urge = result("workspace/symbol", {{"query", "urge"}});
  EXPECT_EQ(urge[0]["containerName"], "Scout");
}

TEST_F(ServerTest, FoldsAndHints) {
  initialize();
  open(kUri, "assemblage A() {\n  cooperate {\n    1: Noise(6);\n  }\n}\n");
  const Json document = {{"textDocument", {{"uri", kUri}}}};
  EXPECT_EQ(result("textDocument/foldingRange", document),
            (Json{{{"startLine", 0}, {"endLine", 3}}, {{"startLine", 1}, {"endLine", 2}}}));
  Json params = document;
  params["range"] = {{"start", {{"line", 0}, {"character", 0}}}, {"end", {{"line", 4}, {"character", 0}}}};
  const Json hints = result("textDocument/inlayHint", params);
  ASSERT_EQ(hints.size(), 2U) << hints;
  EXPECT_EQ(hints[0]["label"], "persistence:");
  EXPECT_EQ(hints[1]["label"], "s");
  EXPECT_EQ(hints[1]["position"], (Json{{"line", 2}, {"character", 14}}));
  params["range"]["start"]["line"] = 3;
  EXPECT_TRUE(result("textDocument/inlayHint", params).empty());
}

TEST_F(ServerTest, LaysOutAndColours) {
  initialize();
  open(kUri, "assemblage A(){\nNoise()\n}\n");
  const Json edits =
      result("textDocument/formatting", {{"textDocument", {{"uri", kUri}}}, {"options", Json::object()}});
  ASSERT_EQ(edits.size(), 1U);
  EXPECT_EQ(edits[0]["newText"], "assemblage A() {\n  ") << edits;
  const Json tokens = result("textDocument/semanticTokens/full", {{"textDocument", {{"uri", kUri}}}})["data"];
  const Json first = {0, 0, 10, 1, 0, 0, 11, 1, 6, 1, 1, 0, 5, 6, 2};
  EXPECT_EQ(tokens, first);
}

RC_GTEST_PROP(Server, SurvivesAnyMessage, (const std::vector<std::string>& texts)) {
  Server server({"1", {}, ""}, [](const std::string&) {});
  server.receive(R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}})");
  for (const std::string& text : texts) {
    server.receive(text);
    server.receive(Json{{"id", 1}, {"method", "textDocument/hover"}, {"params", {{"position", text}}}}.dump(
        -1, ' ', false, Json::error_handler_t::replace));
  }
}

TEST(Trust, CodeIsCompiledWhereTheEditorTrustsTheFolderOrKnowsNoSuchQuestion) {
  const std::vector<std::pair<std::string, bool>> answers = {
      {R"({})", true}, {R"({"trusted":true})", true}, {R"({"trusted":false})", false}};
  for (const auto& [options, expected] : answers) {
    std::optional<bool> asked;
    Options ours;
    ours.permission = [&](bool is_trusted) {
      asked = is_trusted;
      return cell::Permission();
    };
    Server server(std::move(ours), [](const std::string&) {});
    server.receive(R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":{"initializationOptions":)" +
                   options + "}}");
    EXPECT_EQ(asked, expected) << options;
  }
}

}  // namespace
}  // namespace mlab::lsp
