#include "mlab/mcap/reader.h"

#include <algorithm>
#include <expected>
#include <utility>

#include <fmt/core.h>

#include "mlab/mcap/contents.h"
#include "mlab/mcap/decode.h"
#include "mlab/mcap/scan.h"
#include "mlab/text/shown.h"

namespace mlab::mcap {
namespace {

constexpr std::size_t kLongestName = 200;

std::unexpected<text::Diagnostic> refused(const char* kind, const std::string& file,
                                          const std::string& what) {
  return std::unexpected(text::Diagnostic{text::Severity::kError,
                                          kind,
                                          fmt::format("`{}`: {}", text::shown(file, kLongestName), what),
                                          {},
                                          {},
                                          {},
                                          {}});
}

std::expected<Contents, std::string> contents_of(const Source& source, const Limits& limits) {
  auto header = read_header(source);
  if (!header) return std::unexpected(header.error());
  auto contents = contents_by_summary(source, limits);
  if (!contents) {
    auto found = scan(source, limits, contents.error());
    if (!found) return std::unexpected(found.error());
    return std::move(found->contents);
  }
  contents->header = *std::move(header);
  return contents;
}

/// The content of a record that an index names.
std::expected<Buffer, std::string> content_at(const Source& source, std::uint64_t most, Opcode wanted,
                                              std::uint64_t offset, std::uint64_t length) {
  if (length > most)
    return std::unexpected(fmt::format("{} bytes, where {} are the most that is read", length, most));
  if (length < kRecordHead || offset > source.size() || length > source.size() - offset)
    return std::unexpected("it does not lie in the file");
  Buffer bytes(static_cast<std::size_t>(length));
  if (const int error = source.read(offset, bytes); error != 0) return std::unexpected(read_problem(error));
  Cursor head(bytes);
  const auto opcode = static_cast<Opcode>(head.number<std::uint8_t>());
  if (opcode != wanted || head.number<std::uint64_t>() != length - kRecordHead)
    return std::unexpected(fmt::format("another record stands at byte {}", offset));
  bytes.erase(bytes.begin(), bytes.begin() + kRecordHead);
  return bytes;
}

template <class Index>
const Index* last_named(const std::vector<Index>& all, std::string_view name) {
  const auto found =
      std::find_if(all.rbegin(), all.rend(), [&](const Index& one) { return one.name == name; });
  return found == all.rend() ? nullptr : &*found;
}

std::expected<Attachment, std::string> attachment_of(std::span<const std::byte> content) {
  auto head = decode_attachment_head(content, content.size());
  if (!head) return std::unexpected("it is not whole");
  Cursor cursor(content.subspan(static_cast<std::size_t>(head->data_at)));
  const std::span<const std::byte> data = cursor.take(head->index.data_size);
  const auto crc = cursor.number<std::uint32_t>();
  const std::uint32_t is = crc32(content.first(static_cast<std::size_t>(head->data_at) + data.size()));
  if (crc != 0 && crc != is) return std::unexpected("its checksum differs: it was changed");
  Attachment out;
  out.name = std::move(head->index.name);
  out.media_type = std::move(head->index.media_type);
  out.log_time = head->index.log_time;
  out.create_time = head->index.create_time;
  out.data.assign(reinterpret_cast<const char*>(data.data()), data.size());
  return out;
}

}  // namespace

Reader::Reader(std::shared_ptr<const Source> source, std::shared_ptr<const Contents> contents,
               std::string name, const Limits& limits)
    : source_(std::move(source)), contents_(std::move(contents)), name_(std::move(name)), limits_(limits) {}

text::Result<Reader> Reader::open(const std::string& path, const Limits& limits) {
  auto source = open_source(path);
  if (!source) return std::unexpected(std::move(source.error()));
  return over(*std::move(source), path, limits);
}

text::Result<Reader> Reader::over(std::shared_ptr<const Source> source, std::string name,
                                  const Limits& limits) {
  auto contents = contents_of(*source, limits);
  if (!contents) return refused("no-mcap", name, contents.error());
  return Reader(std::move(source), std::make_shared<const Contents>(*std::move(contents)), std::move(name),
                limits);
}

const Header& Reader::header() const {
  return contents_->header;
}
const Summary& Reader::summary() const {
  return contents_->summary;
}
const Ending& Reader::ending() const {
  return contents_->ending;
}

Messages Reader::messages(const Selection& selection) const {
  return {source_, contents_, limits_, selection};
}

text::Result<Attachment> Reader::attachment(std::string_view name) const {
  if (const AttachmentIndex* const index = last_named(summary().attachments, name)) return attachment(*index);
  return refused("no-attachment", name_, fmt::format("it has no attachment `{}`", text::shown(name)));
}

text::Result<Attachment> Reader::attachment(const AttachmentIndex& index) const {
  const auto problem = [&](const std::string& what) {
    return refused("no-attachment", name_,
                   fmt::format("the attachment `{}`: {}", text::shown(index.name), what));
  };
  const auto content =
      content_at(*source_, limits_.attachment_bytes, Opcode::kAttachment, index.offset, index.length);
  if (!content) return problem(content.error());
  auto out = attachment_of(*content);
  if (!out) return problem(out.error());
  return *std::move(out);
}

text::Result<Metadata> Reader::metadata(std::string_view name) const {
  if (const MetadataIndex* const index = last_named(summary().metadata, name)) return metadata(*index);
  return refused("no-metadata", name_, fmt::format("it has no metadata `{}`", text::shown(name)));
}

text::Result<Metadata> Reader::metadata(const MetadataIndex& index) const {
  const auto problem = [&](const std::string& what) {
    return refused("no-metadata", name_, fmt::format("the metadata `{}`: {}", text::shown(index.name), what));
  };
  const auto content =
      content_at(*source_, limits_.definition_bytes, Opcode::kMetadata, index.offset, index.length);
  if (!content) return problem(content.error());
  auto out = decode_metadata(*content);
  if (!out) return problem("they are not whole");
  return *std::move(out);
}

}  // namespace mlab::mcap
