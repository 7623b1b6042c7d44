#include "live/web/web_request.hpp"

#include <gtest/gtest.h>

#include "io/errors.hpp"

namespace autoref::live {
namespace {

namespace http = boost::beast::http;
using http::status;

WebRequest request_for(const char* path, const char* host) {
  WebRequest request(http::verb::get, path, 11);
  request.set(http::field::host, host);
  return request;
}

WebRequest request_from(const char* origin) {
  WebRequest request = request_for("/live", "localhost:8090");
  request.set(http::field::origin, origin);
  request.set(http::field::connection, "keep-alive, Upgrade");
  request.set(http::field::upgrade, "websocket");
  return request;
}

status answer_on_loopback(const WebRequest& request) {
  return answer_to(request, hosts_of({"127.0.0.1", 8090}));
}

TEST(WebRequest, ThePageIsAtTheRoot) {
  EXPECT_EQ(answer_on_loopback(request_for("/", "127.0.0.1:8090")), status::ok);
  EXPECT_EQ(answer_on_loopback(request_for("/?t=3", "localhost")), status::ok);
  EXPECT_EQ(answer_on_loopback(request_for("/index.html", "localhost")), status::not_found);
}

TEST(WebRequest, AGameIsNamedAfterTheQuestionMark) {
  EXPECT_EQ(game_in(request_for("/", "localhost")), std::nullopt);
  EXPECT_EQ(game_in(request_for("/?p0001-2", "localhost")), std::nullopt);
  EXPECT_EQ(game_in(request_for("/game", "localhost")), "");
  EXPECT_EQ(game_in(request_for("/game?", "localhost")), "");
  EXPECT_EQ(game_in(request_for("/game?zone~basic-p0001-2", "localhost")), "zone~basic-p0001-2");
  EXPECT_EQ(game_in(request_for("/game?a%3Db", "localhost")), "a=b");
  EXPECT_EQ(game_in(request_for("/game?a%zz%3", "localhost")), "a%zz%3");
  EXPECT_EQ(answer_on_loopback(request_for("/game?x", "localhost")), status::ok);
}

TEST(WebRequest, OnlyGetIsAllowed) {
  WebRequest request = request_for("/", "localhost");
  for (const http::verb verb : {http::verb::post, http::verb::head, http::verb::delete_}) {
    request.method(verb);
    EXPECT_EQ(answer_on_loopback(request), status::method_not_allowed);
  }
}

TEST(WebRequest, OnlyThisServersPageMayOpenTheWebSocket) {
  EXPECT_EQ(answer_on_loopback(request_from("http://localhost:8090")), status::switching_protocols);
  EXPECT_EQ(answer_on_loopback(request_from("http://LOCALHOST:8090")), status::switching_protocols);
  for (const char* origin : {"http://example.com", "http://localhost:80", "null", "",
                             "http://localhost:8090.example.com", "ftp://localhost:8090"})
    EXPECT_EQ(answer_on_loopback(request_from(origin)), status::forbidden) << origin;
}

TEST(WebRequest, OnTheLoopbackOnlyItsOwnNamesAreAnswered) {
  for (const char* host : {"localhost", "LocalHost:1", "127.0.0.1", "[::1]:8090"})
    EXPECT_EQ(answer_on_loopback(request_for("/", host)), status::ok) << host;
  for (const char* host : {"example.com", "example.com:8090", "127.0.0.1.example.com", "::1"})
    EXPECT_EQ(answer_on_loopback(request_for("/", host)), status::misdirected_request) << host;
  EXPECT_EQ(answer_on_loopback(request_for("/", "")), status::bad_request);
}

TEST(WebRequest, OnAnotherAddressOnlyThatOneIsAnswered) {
  const WebHosts hosts = hosts_of({"192.0.2.1", 8090});
  EXPECT_EQ(answer_to(request_for("/", "192.0.2.1:8090"), hosts), status::ok);
  EXPECT_EQ(answer_to(request_for("/", "192.0.2.1:80"), hosts), status::ok);
  for (const char* host : {"laptop:8090", "rebound.example.com:8090", "192.0.2.2", "localhost"})
    EXPECT_EQ(answer_to(request_for("/", host), hosts), status::misdirected_request) << host;
}

TEST(WebRequest, OnAllAddressesEveryOneInNumbersIsAnsweredButNoName) {
  for (const char* any : {"0.0.0.0", "::"}) {
    const WebHosts hosts = hosts_of({any, 8090});
    for (const char* host : {"192.0.2.1:8090", "127.0.0.1", "[2001:db8::1]:8090", "localhost:8090"})
      EXPECT_EQ(answer_to(request_for("/", host), hosts), status::ok) << host;
    for (const char* host : {"laptop:8090", "192.0.2.1.example.com", "[192.0.2.1]", "2001:db8::1",
                             "192.0.2.1:8090:1", "[]", "0x7f000001"})
      EXPECT_EQ(answer_to(request_for("/", host), hosts), status::misdirected_request) << host;
  }
}

TEST(WebRequest, AnAddressMayBeSpeltInAnyWay) {
  EXPECT_TRUE(hosts_of({"fe80::1%lo", 8090}).has("[fe80::1]:8090"));
  EXPECT_TRUE(hosts_of({"2001:db8::1", 8090}).has("[2001:db8:0:0:0:0:0:1]:8090"));
  EXPECT_TRUE(hosts_of({"::ffff:192.0.2.5", 8090}).has("[::ffff:c000:205]"));
  EXPECT_FALSE(hosts_of({"2001:db8::1", 8090}).has("[2001:db8::2]:8090"));
}

TEST(WebRequest, NamesThatTheUserListsAreAnswered) {
  const WebHosts hosts =
      hosts_of({"192.0.2.1", 8090}, {"Laptop.local", "2001:DB8::1", "203.0.113.5"});
  for (const char* host :
       {"laptop.LOCAL:8090", "laptop.local", "[2001:db8::1]:8090", "203.0.113.5"})
    EXPECT_EQ(answer_to(request_for("/", host), hosts), status::ok) << host;
  EXPECT_EQ(answer_to(request_for("/", "local"), hosts), status::misdirected_request);
  for (const char* name : {"", "laptop:8090", "http://laptop", "lap top", "*"})
    EXPECT_THROW(hosts_of({"192.0.2.1", 8090}, {name}), io::InputError) << name;
}

TEST(WebAddress, ReadsAPortWithOrWithoutAnAddress) {
  EXPECT_EQ(url_of(web_address("8090", "--web")), "http://127.0.0.1:8090/");
  EXPECT_EQ(url_of(web_address("0.0.0.0:80", "--web")), "http://0.0.0.0:80/");
  EXPECT_EQ(url_of(web_address("[::1]:8090", "--web")), "http://[::1]:8090/");
}

TEST(WebAddress, RefusesWhatIsNone) {
  for (const char* text : {"", ":", "localhost:8090", "127.0.0.1", "127.0.0.1:", "8090x", "70000",
                           "-1", "127.0.0.1:8090:1"})
    EXPECT_THROW(web_address(text, "--web"), std::runtime_error) << text;
}

}  // namespace
}  // namespace autoref::live
