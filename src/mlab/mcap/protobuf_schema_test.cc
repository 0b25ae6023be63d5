#include "mlab/mcap/protobuf_schema.h"

#include <google/protobuf/api.pb.h>
#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/dynamic_message.h>

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace mlab::mcap {
namespace {

namespace pb = google::protobuf;

// `Api` is made of types of three other files, two of which import each other's.
TEST(ProtobufSchema, IsEnoughToReadAMessageWithoutItsProgram) {
  const Schema schema = protobuf_schema(*pb::Api::descriptor());
  EXPECT_EQ(schema.name, "google.protobuf.Api");
  EXPECT_EQ(schema.encoding, "protobuf");
  pb::FileDescriptorSet files;
  ASSERT_TRUE(files.ParseFromString(schema.data));
  pb::DescriptorPool pool;
  std::vector<std::string> names;
  for (const pb::FileDescriptorProto& file : files.file()) {
    ASSERT_NE(pool.BuildFile(file), nullptr) << file.name() << " needs what does not stand in front of it";
    names.push_back(file.name());
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"google/protobuf/source_context.proto", "google/protobuf/any.proto",
                                      "google/protobuf/type.proto", "google/protobuf/api.proto"}));

  pb::Api api;
  api.set_name("robots");
  api.add_options()->set_name("secret");
  pb::DynamicMessageFactory factory;
  const pb::Descriptor* const type = pool.FindMessageTypeByName(schema.name);
  ASSERT_NE(type, nullptr);
  const std::unique_ptr<pb::Message> read(factory.GetPrototype(type)->New());
  ASSERT_TRUE(read->ParseFromString(api.SerializeAsString()));
  EXPECT_EQ(read->ShortDebugString(), R"(name: "robots" options { name: "secret" })");
}

TEST(ProtobufSchema, SaysTheSameAgain) {
  EXPECT_EQ(protobuf_schema(*pb::Api::descriptor()), protobuf_schema(*pb::Api::descriptor()));
  EXPECT_EQ(protobuf_schema(*pb::Option::descriptor()).name, "google.protobuf.Option");
}

}  // namespace
}  // namespace mlab::mcap
