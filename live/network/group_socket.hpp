// Opens sockets for multicast groups and ports, for the few files that use Asio.
#pragma once

#include <utility>  // Boost 1.74 needs it before Asio

#include <boost/asio/ip/udp.hpp>

#include "live/network/network.hpp"

namespace autoref::live {

// Opens and binds the socket, and joins the group, unless that is an address for all hosts of a
// network. Throws InputError if the port is in use or an
// address is wrong.
void open_for_group(boost::asio::ip::udp::socket& socket, const DatagramReceiver::Place& place,
                    int receive_buffer_bytes);

}  // namespace autoref::live
