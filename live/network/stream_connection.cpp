#include "live/network/stream_connection.hpp"

#include <boost/asio/write.hpp>
#include <optional>
#include <utility>

#include "league/team/delimited.hpp"
#include "league/team/team_fault.hpp"
#include "live/network/stream_server.hpp"

namespace autoref::live {
namespace {

using boost::asio::ip::tcp;
using boost::system::error_code;

}  // namespace

StreamConnection::StreamConnection(tcp::socket socket, OnMessage on_message, OnEnd on_end)
    : socket_(std::move(socket)), on_message_(std::move(on_message)), on_end_(std::move(on_end)) {
  error_code error;
  socket_.set_option(tcp::no_delay(true), error);
  socket_.set_option(boost::asio::socket_base::keep_alive(true), error);
  const tcp::endpoint peer = socket_.remote_endpoint(error);
  if (!error) peer_ = {peer.address().to_string(), peer.port()};
}

void StreamConnection::read() {
  socket_.async_read_some(boost::asio::buffer(chunk_),
                          [self = shared_from_this()](const error_code& error, std::size_t size) {
                            if (!self->is_open_) return;
                            if (error) return self->end(End::kClosed);
                            self->received_.append(self->chunk_.data(), size);
                            self->take_messages();
                            if (self->is_open_) self->read();
                          });
}

// What remains is less than a message, so that memory is bounded.
void StreamConnection::take_messages() {
  std::string_view rest = received_;
  try {
    while (const std::optional<league::MessageExtent> extent = league::find_delimited(rest)) {
      last_heard_ = Clock::now();
      const auto response = on_message_(rest.substr(extent->begin, extent->size), peer_);
      rest.remove_prefix(extent->end);
      if (response) send(*response);
      if (!is_open_) return;
    }
  } catch (const league::TeamFault&) {
    return end(End::kInvalid);
  }
  received_.erase(0, received_.size() - rest.size());
}

void StreamConnection::send(std::string_view message) {
  if (!is_open_) return;
  if (waiting_.size() + written_.size() + message.size() > kMostUnread) return end(End::kUnread);
  league::append_delimited(message, waiting_);
  if (!is_writing_) write();
}

void StreamConnection::write() {
  written_.swap(waiting_);
  is_writing_ = true;
  boost::asio::async_write(socket_, boost::asio::buffer(written_),
                           [self = shared_from_this()](const error_code& error, std::size_t) {
                             self->is_writing_ = false;
                             self->written_.clear();
                             if (!self->is_open_) return;
                             if (error) return self->end(End::kClosed);
                             if (!self->waiting_.empty()) self->write();
                           });
}

void StreamConnection::end(End why) {
  if (!is_open_) return;
  is_open_ = false;
  const auto self = shared_from_this();
  on_end_(*this, why);
  close();
}

void StreamConnection::close() {
  is_open_ = false;
  error_code error;
  socket_.close(error);
}

}  // namespace autoref::live
