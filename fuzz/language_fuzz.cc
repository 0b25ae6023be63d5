// Any bytes as a text in each of the languages that somebody edits: everything is asked at a place of it, and
// an editor says it all over the protocol. The first two bytes say where.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include <nlohmann/json.hpp>

#include "mlab/assist/testing/ask_everything.h"
#include "mlab/lsp/framing.h"
#include "mlab/lsp/server.h"

namespace {

namespace assist = mlab::assist;
namespace lsp = mlab::lsp;
using Json = nlohmann::json;

void ask_over_the_protocol(const std::string& content, std::uint32_t line, std::uint32_t character) {
  lsp::Server server({"1", assist::testing::nowhere(), ""}, [](const std::string&) {});
  const auto say = [&](const Json& message) {
    server.receive(message.dump(-1, ' ', false, Json::error_handler_t::replace));
  };
  say({{"id", 1}, {"method", "initialize"}, {"params", {{"capabilities", Json::object()}}}});
  const Json text = {{"uri", "file:///x.cdl"}, {"languageId", "cdl"}, {"version", 1}, {"text", content}};
  say({{"method", "textDocument/didOpen"}, {"params", {{"textDocument", text}}}});
  const Json at = {{"line", line}, {"character", character}};
  const Json range = {{"start", at}, {"end", {{"line", line}, {"character", character + 3}}}};
  say({{"method", "textDocument/didChange"},
       {"params",
        {{"textDocument", {{"uri", "file:///x.cdl"}, {"version", 2}}},
         {"contentChanges", {{{"range", range}, {"text", "x"}}}}}}});
  for (const char* method : {"completion", "hover", "formatting", "codeAction", "semanticTokens/full"}) {
    say({{"id", 2},
         {"method", std::string("textDocument/") + method},
         {"params", {{"textDocument", {{"uri", "file:///x.cdl"}}}, {"position", at}, {"range", range}}}});
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::uint32_t cursor = size < 2 ? 0 : static_cast<std::uint32_t>(data[0]) * 256U + data[1];
  const std::string content = bytes.substr(size < 2 ? size : 2);
  for (const auto& [name, kind] :
       {std::pair{"x.cdl", assist::Language::kConfiguration}, std::pair{"x.cnl", assist::Language::kNetwork},
        std::pair{"x.mdl", assist::Language::kMission}, std::pair{"x.odl", assist::Language::kOverlay}}) {
    const assist::Text text{std::make_shared<const mlab::text::Source>(name, content), kind};
    const auto at = static_cast<std::uint32_t>(cursor % (content.size() + 1));
    const std::string wrong = assist::testing::ask_everything(text, at, assist::testing::nowhere());
    if (wrong.empty()) continue;
    std::fprintf(stderr, "%s at %u: %s\n", name, at, wrong.c_str());
    std::abort();
  }
  ask_over_the_protocol(content, cursor / 256U, cursor % 256U);
  lsp::MessageReader reader;
  reader.add(bytes);
  while (reader.next()) {
  }
  return 0;
}
