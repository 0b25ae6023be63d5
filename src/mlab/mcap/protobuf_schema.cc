#include "mlab/mcap/protobuf_schema.h"

#include <set>

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>

namespace mlab::mcap {
namespace {

namespace pb = google::protobuf;

// Each file once, behind all that it imports, as readers that go from front to back need it.
void append_file(const pb::FileDescriptor& file, std::set<const pb::FileDescriptor*>& done,
                 pb::FileDescriptorSet& out) {
  if (!done.insert(&file).second) return;
  for (int i = 0; i < file.dependency_count(); ++i) append_file(*file.dependency(i), done, out);
  file.CopyTo(out.add_file());
}

}  // namespace

Schema protobuf_schema(const pb::Descriptor& type) {
  pb::FileDescriptorSet files;
  std::set<const pb::FileDescriptor*> done;
  append_file(*type.file(), done, files);
  return {{}, type.full_name(), "protobuf", files.SerializeAsString()};
}

}  // namespace mlab::mcap
