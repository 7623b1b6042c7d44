#include "live/web/watcher.hpp"

#include <algorithm>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <utility>

namespace autoref::live {
namespace {

namespace watcher_beast = boost::beast;
namespace websocket = watcher_beast::websocket;
using boost::asio::ip::tcp;

constexpr std::size_t kLongestFromWatcher = 16;
constexpr int kMostFromWatcher = 100;  // number of messages
// Kept small because frames already in the system's buffer cannot be dropped in favour of newer
// ones.
constexpr int kWatcherSendBuffer = 64 * 1024;
constexpr std::chrono::seconds kMostIdle{20};  // with a ping after half this time

class Watcher final : public WebConnection, public std::enable_shared_from_this<Watcher> {
 public:
  Watcher(watcher_beast::tcp_stream stream, const std::string& computer,
          std::shared_ptr<WebHub> hub)
      : WebConnection(computer),
        socket_(std::move(stream)),
        hub_(std::move(hub)),
        write_timer_(socket_.get_executor()) {
    watcher_beast::error_code ignored;
    tcp::socket& tcp_socket = socket_.next_layer().socket();
    tcp_socket.set_option(tcp::no_delay(true), ignored);
    tcp_socket.set_option(tcp::socket::send_buffer_size(kWatcherSendBuffer), ignored);
    socket_.next_layer().expires_never();  // the WebSocket has its own timeouts
    websocket::stream_base::timeout timeout{};
    timeout.handshake_timeout = hub_->options().header_time;
    timeout.idle_timeout = kMostIdle;
    timeout.keep_alive_pings = true;
    socket_.set_option(timeout);
    socket_.read_message_max(kLongestFromWatcher);
    socket_.text(true);
    socket_.auto_fragment(false);
  }

  WebState state() const override { return WebState::kWatching; }

  void accept(const WebRequest& request) {
    socket_.async_accept(request,
                         [self = shared_from_this()](const watcher_beast::error_code& error) {
                           if (error || self->hub_->is_closed()) return self->close();
                           self->queue_.begin_with(self->hub_->backlog());
                           self->is_accepted_ = true;
                           self->read();
                           self->write();
                         });
  }

  void push(const WebMessage& message) override {
    if (!is_accepted_) return;  // the backlog will contain it
    if (!queue_.push(message)) return close();
    if (!writing_) write();
  }

  void close() override {
    write_timer_.cancel();
    watcher_beast::get_lowest_layer(socket_).close();
    hub_->remove(shared_from_this());
  }

 private:
  // Watchers have nothing to say, but reading detects when they are gone.
  void read() {
    socket_.async_read(received_, [self = shared_from_this()](
                                      const watcher_beast::error_code& error, std::size_t) {
      self->received_.clear();
      if (error || ++self->from_watcher_ > kMostFromWatcher) return self->close();
      self->read();
    });
  }

  void write() {
    writing_ = queue_.pop();
    if (!writing_) return;
    write_timer_.expires_after(hub_->options().write_time);
    write_timer_.async_wait([self = shared_from_this()](const watcher_beast::error_code& error) {
      if (!error) self->close();
    });
    socket_.async_write(
        boost::asio::buffer(*writing_),
        [self = shared_from_this()](const watcher_beast::error_code& error, std::size_t) {
          self->write_timer_.cancel();
          if (error) return self->close();
          self->write();
        });
  }

  websocket::stream<watcher_beast::tcp_stream> socket_;
  std::shared_ptr<WebHub> hub_;
  boost::asio::steady_timer write_timer_;
  watcher_beast::flat_buffer received_;
  WatcherQueue queue_;
  WebText writing_;  // null: nothing is being sent
  bool is_accepted_ = false;
  int from_watcher_ = 0;
};

}  // namespace

void WatcherQueue::begin_with(const WebBacklog& backlog) {
  backlog_.assign(backlog.texts.begin(), backlog.texts.end());
  last_number_ = backlog.last_number;
}

bool WatcherQueue::push(const WebMessage& message) {
  if (message.number <= last_number_) return true;
  const bool is_long = bytes_ + message.text->size() > kMostWaiting_bytes;
  if (!message.is_frame && (is_long || waiting_.size() - frames_ >= kMostOthers)) return false;
  waiting_.push_back(message);
  bytes_ += message.text->size();
  frames_ += message.is_frame ? 1 : 0;
  if (frames_ > kMostFrames) leave_out_oldest_frame();
  return true;
}

void WatcherQueue::leave_out_oldest_frame() {
  const auto oldest = std::find_if(waiting_.begin(), waiting_.end(),
                                   [](const WebMessage& message) { return message.is_frame; });
  bytes_ -= oldest->text->size();
  waiting_.erase(oldest);
  --frames_;
  ++left_out_;
}

WebText WatcherQueue::pop() {
  WebText next;
  if (!backlog_.empty()) {
    next = backlog_.front();
    backlog_.pop_front();
  } else if (!waiting_.empty()) {
    next = waiting_.front().text;
    frames_ -= waiting_.front().is_frame ? 1 : 0;
    bytes_ -= next->size();
    waiting_.pop_front();
  }
  return next;
}

void start_watcher(watcher_beast::tcp_stream stream, const std::string& computer,
                   const WebRequest& request, const std::shared_ptr<WebHub>& hub) {
  const auto watcher = std::make_shared<Watcher>(std::move(stream), computer, hub);
  hub->add(watcher);
  watcher->accept(request);
}

}  // namespace autoref::live
