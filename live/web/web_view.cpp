#include "live/web/web_view.hpp"

namespace autoref::live {

WebView::WebView(const WebOptions& options, const view::PageContent& content)
    : page_(content, clock_, [this](const WebMessage& message) { server_.send(message); }),
      server_(thread_, options, {view::live_page(), [this] { return page_.backlog(); }}) {}

}  // namespace autoref::live
