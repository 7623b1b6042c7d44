#include "runner/live/web_view.hpp"

#include "soccer/published.hpp"

namespace autoref::runner {

WebView::WebView(const WebOptions& options, const PageContent& content)
    : page_(content, clock_, [this](const WebMessage& message) { server_.send(message); }),
      server_(thread_, options, {live_page(), [this] { return page_.backlog(); }}) {}

void WebObserver::on_frame(const Frame& frame, const RefereeSignal& signal,
                           const sim::World& /*world*/) {
  view_->add(published(frame, signal.blue_on_positive_half), published(signal));
}

}  // namespace autoref::runner
