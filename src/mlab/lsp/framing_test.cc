#include "mlab/lsp/framing.h"

#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace mlab::lsp {
namespace {

TEST(MessageReader, CutsMessagesWhereverTheBytesAreCut) {
  const std::string stream =
      framed("{\"a\":1}") + "content-length: 2\r\nContent-Type: x\r\n\r\n{}" + framed("");
  for (std::size_t cut = 1; cut < stream.size(); ++cut) {
    MessageReader reader;
    std::string got;
    for (std::size_t at = 0; at < stream.size(); at += cut) {
      reader.add(std::string_view(stream).substr(at, cut));
      while (const auto message = reader.next()) got += message->error + message->body + ";";
    }
    EXPECT_EQ(got, "{\"a\":1};{};;");
  }
}

TEST(MessageReader, SaysWhatIsWrongAndGoesOn) {
  MessageReader reader;
  reader.add("Content-Length: many\r\n\r\n" + framed("{}"));
  EXPECT_FALSE(reader.next()->error.empty());
  EXPECT_EQ(reader.next()->body, "{}");
  reader.add("Hello\r\n\r\n" + framed("[]"));
  EXPECT_FALSE(reader.next()->error.empty());
  EXPECT_EQ(reader.next()->body, "[]");
  reader.add("Content-Length: -5\r\n\r\n" + framed("1"));
  EXPECT_FALSE(reader.next()->error.empty());
  EXPECT_EQ(reader.next()->body, "1");
}

TEST(MessageReader, KeepsNothingOfMessagesThatAreTooLong) {
  MessageReader reader;
  reader.add("Content-Length: 300000000\r\n\r\n");
  EXPECT_NE(reader.next()->error.find("300000000 bytes"), std::string::npos);
  const std::string piece(1000000, 'x');
  for (int i = 0; i < 300; ++i) {
    reader.add(piece);
    EXPECT_FALSE(reader.next());
  }
  reader.add(framed("{}"));
  EXPECT_EQ(reader.next()->body, "{}");
  reader.add("Content-Length: 99999999999999999999999\r\n\r\n");
  EXPECT_FALSE(reader.next()->error.empty());
  reader.add(std::string(MessageReader::kMostHeaderBytes + 1, 'a'));
  EXPECT_FALSE(reader.next()->error.empty());
}

RC_GTEST_PROP(MessageReader, SurvivesAnyBytes, (const std::string& bytes)) {
  MessageReader reader;
  reader.add(bytes);
  int messages = 0;
  while (reader.next()) RC_ASSERT(++messages <= 10000);
}

}  // namespace
}  // namespace mlab::lsp
