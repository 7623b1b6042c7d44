// The Asio context of a NetworkThread, and sockets for multicast groups and ports, for the few
// files that use Asio.
#pragma once

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <csignal>
#include <thread>
#include <utility>  // needed before Asio in Boost 1.74

#include "live/network/network.hpp"

namespace autoref::live {

class NetworkThread::Context {
 public:
  Context() : thread_([this] { run(); }) {}
  ~Context() {
    io.stop();
    thread_.join();
  }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  boost::asio::io_context io{1};

 private:
  // Runs the context with signals blocked, so that the main thread gets them.
  void run() {
    sigset_t all{};
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    io.run();
  }

  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> work_{io.get_executor()};
  std::thread thread_;
};

// Opens and binds the socket, and joins the group unless it is a broadcast address. Throws
// InputError if the port is in use or an address is invalid.
void open_for_group(boost::asio::ip::udp::socket& socket, const DatagramReceiver::Place& place,
                    int receive_buffer_bytes);

}  // namespace autoref::live
