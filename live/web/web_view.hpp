// Shows one game to watchers on the network.
#pragma once

#include "live/network/network.hpp"
#include "live/web/live_page.hpp"
#include "live/web/web_server.hpp"

namespace autoref::live {

// Owns the game's page, its server and the server's thread.
class WebView {
 public:
  // Throws InputError naming --web if the server cannot listen, or --web-host.
  WebView(const WebOptions& options, const view::PageContent& content);

  // As those of LivePage.
  void add(const Frame& frame, const RefereeSignal& signal) { page_.add(frame, signal); }
  void add(const view::RecordedDecision& decision) { page_.add(decision); }
  void end() { page_.end(); }

  std::string url() const { return server_.url(); }

 private:
  SteadyFrameClock clock_;
  LivePage page_;
  NetworkThread thread_;
  WebServer server_;
};

}  // namespace autoref::live
