#include "runner/live/web_view.hpp"

namespace autoref::runner {

WebView::WebView(const WebOptions& options, const PageContent& content)
    : page_(content, clock_, [this](const WebMessage& message) { server_.send(message); }),
      server_(thread_, options, {live_page(), [this] { return page_.backlog(); }}) {}

}  // namespace autoref::runner
