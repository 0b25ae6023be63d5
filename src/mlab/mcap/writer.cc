#include "mlab/mcap/writer.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "mlab/mcap/writer_state.h"
#include "mlab/text/shown.h"

namespace mlab::mcap {

Writer::Writer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Writer::Writer(Writer&& from) noexcept = default;
Writer& Writer::operator=(Writer&& from) noexcept {
  if (this == &from) return *this;
  if (state_ != nullptr) {
    [[maybe_unused]] const Written ignored = state_->close();
  }
  state_ = std::move(from.state_);
  return *this;
}
Writer::~Writer() {
  if (state_ != nullptr) {
    [[maybe_unused]] const Written ignored = state_->close();
  }
}

std::expected<Writer, WriteError> Writer::create(const std::string& path, const WriterOptions& options) {
  FileSink::Opened opened = FileSink::create(path);
  if (opened.sink == nullptr) {
    const std::string why = opened.error == EWOULDBLOCK ? "another process is writing it"
                            : opened.error == EINVAL    ? "it is no ordinary file"
                                                        : std::generic_category().message(opened.error);
    return std::unexpected(WriteError{
        opened.error, fmt::format("`{}` can't be written: {}", text::shown(path, 200), why), 0, 0, 0});
  }
  auto state = std::make_unique<State>(std::move(opened.sink), path, options);
  if (auto written = state->begin(options.header); !written) return std::unexpected(written.error());
  return Writer(std::move(state));
}

std::expected<Writer, WriteError> Writer::onto(std::unique_ptr<Sink> sink, const WriterOptions& options) {
  auto state = std::make_unique<State>(std::move(sink), "recording", options);
  if (auto written = state->begin(options.header); !written) return std::unexpected(written.error());
  return Writer(std::move(state));
}

std::expected<SchemaId, WriteError> Writer::add_schema(const Schema& schema) {
  return state_->add_schema(schema);
}
std::expected<ChannelId, WriteError> Writer::add_channel(const Channel& channel) {
  return state_->add_channel(channel);
}
Written Writer::write(const Message& message) {
  return state_->write(message);
}
Written Writer::attach(const Attachment& attachment) {
  return state_->attach(attachment);
}
Written Writer::add(const Metadata& metadata) {
  return state_->add(metadata);
}
Written Writer::flush() {
  return state_->flush();
}
Written Writer::sync() {
  return state_->sync();
}
Written Writer::close() {
  return state_->close();
}
const Summary& Writer::summary() const {
  return state_->summary();
}
const WriteError* Writer::failure() const {
  return state_->failure();
}

}  // namespace mlab::mcap
