/* The smallest team on the network: for each packet of vision it sends one RobotControl, with the
   same command for six robots, and reads the response. It ends when vision has been silent for
   a minute.
     answering_client VISION_PORT COMMAND_PORT */
#include <arpa/inet.h>
#include <netinet/in.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

enum { kRobots = 6, kLongest = 8192 };

static int vision_socket(int port) {
  const int fd = socket(AF_INET, SOCK_DGRAM, 0);
  const int on = 1;
  setsockopt(fd, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  struct sockaddr_in address = {0};
  address.sin_family = AF_INET;
  address.sin_port = htons((unsigned short)port);
  inet_pton(AF_INET, "224.5.23.2", &address.sin_addr);
  if (bind(fd, (struct sockaddr*)&address, sizeof address) != 0) return -1;
  struct ip_mreq group;
  group.imr_multiaddr = address.sin_addr;
  inet_pton(AF_INET, "127.0.0.1", &group.imr_interface);
  if (setsockopt(fd, IPPROTO_IP, IP_ADD_MEMBERSHIP, &group, sizeof group) != 0) return -1;
  const struct timeval silence = {60, 0};
  setsockopt(fd, SOL_SOCKET, SO_RCVTIMEO, &silence, sizeof silence);
  return fd;
}

static int command_socket(int port) {
  const int fd = socket(AF_INET, SOCK_DGRAM, 0);
  struct sockaddr_in address = {0};
  address.sin_family = AF_INET;
  address.sin_port = htons((unsigned short)port);
  inet_pton(AF_INET, "127.0.0.1", &address.sin_addr);
  return connect(fd, (struct sockaddr*)&address, sizeof address) == 0 ? fd : -1;
}

static size_t put_float(unsigned char* bytes, int field, float value) {
  bytes[0] = (unsigned char)(field << 3 | 5);
  memcpy(bytes + 1, &value, sizeof value);
  return 5;
}

/* RobotControl: robot_commands = 1 { id = 1, move_command = 2 { local_velocity = 2 { 1, 2, 3 } } } */
static size_t commands(unsigned char* bytes) {
  size_t size = 0;
  for (int robot = 0; robot < kRobots; ++robot) {
    unsigned char* one = bytes + size;
    size_t at = 0;
    one[at++] = 1 << 3 | 2;
    one[at++] = 21;
    one[at++] = 1 << 3;
    one[at++] = (unsigned char)robot;
    one[at++] = 2 << 3 | 2;
    one[at++] = 17;
    one[at++] = 2 << 3 | 2;
    one[at++] = 15;
    at += put_float(one + at, 1, 0.3F);
    at += put_float(one + at, 2, 0.0F);
    at += put_float(one + at, 3, 1.0F);
    size += at;
  }
  return size;
}

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const int vision = vision_socket(atoi(argv[1]));
  const int team = command_socket(atoi(argv[2]));
  if (vision < 0 || team < 0) return 1;
  unsigned char control[kLongest];
  unsigned char packet[kLongest];
  const size_t size = commands(control);
  long frames = 0;
  long responses = 0;
  for (;;) {
    const ssize_t got = recv(vision, packet, sizeof packet, 0);
    if (got < 0) break;
    if (got == 0 || packet[0] != (1 << 3 | 2)) continue; /* geometry */
    ++frames;
    if (send(team, control, size, 0) != (ssize_t)size) continue;
    responses += recv(team, packet, sizeof packet, MSG_DONTWAIT) > 0;
  }
  printf("%ld frames, %ld responses\n", frames, responses);
  return 0;
}
