// SPDX-License-Identifier: Apache-2.0
// An image generator (IG) that follows the visibility and the layers of fog of a CIGI host, version 3.3 or 4.0, by UDP
// on loopback:
//
//     cigi_ig PORT DATAGRAMS    takes that many datagrams and ends; port 0 is any free one, which it prints
//     cigi_ig --demo            is its own host: 120 datagrams at 60 Hz, half of each version
//
// It prints what each datagram changes and, at the end, the latency: from the kernel's receipt of a datagram until the
// ranges to upload are known. Ends with 1 where nothing arrives for ten seconds.
//
// The layouts are those of two sources, in each of which every id, size, offset and bit below was looked up: Boeing's
// CIGI Class Library 4.0 (cigi-ccl; classes CigiIGCtrlV3_3, CigiAtmosCtrlV3, CigiWeatherCtrlV3, CigiIGCtrlV4,
// CigiAtmosCtrlV4, CigiWeatherCtrlV4, CigiIncomingMsg), and Wireshark 4.4.18 (epan/dissectors/packet-cigi.c,
// cigi3_add_* and cigi4_add_*). Those of 3.3 also agree with github.com/Dnarok/cigi, which quotes sections 4.1.1 and
// 4.1.12 of the interface control document. The standard of 4.0 itself, SISO-STD-013, was not at hand. Offsets are in
// bytes; `@` is "at":
//
//                          3.3                                     4.0
//   every packet           u8 id, u8 size                          u16 size, u16 id
//   IG Control (first)     id 1, size 24, u8 major version @2,     id 0, size 24, u8 major version @4,
//                          u16 0x8000 @6: the byte order,          the byte order is that of the size,
//                          u32 host frame number @8                u32 host frame number @8
//   Atmosphere Control     id 10, size 32, f32 visibility @8       id 9, size 32, f32 visibility @12
//   Weather Control        id 12, size 56, u8 layer @4,            id 11, size 72, u8 layer @4,
//     layer 0: ground fog  bit 0 of @6: enabled,                   bit 0 of @6: enabled,
//     layers 1 to 3: cloud bits 0, 1 of @7: scope, 0 is global,    bits 0, 1 of @7: scope, 0 is global,
//                          f32 visibility @12,                     f32 visibility @16,
//                          f32 base @24, thickness @28,            f32 base @28, thickness @32,
//                          transition band @32                     lower transition band @36, upper @64
//
// A layer's visibility is taken as that within it alone, so that densities add up; ground fog as fog without a base. A
// layer has one width for both of its transition bands, the lower one's, or of ground fog the upper one's. Upper bands
// of other widths and layers that a profile has no knots for are ignored, and the frame's line names them.
#include <arpa/inet.h>
#include <litfog/atmosphere.h>
#include <litfog/updater.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace {

using Bytes = std::span<const std::uint8_t>;

struct Packet {
  std::uint16_t id;
  std::size_t size;
  std::size_t visibility;  // its offset
};

/// Offsets of Weather Control.
struct LayerOffsets {
  std::size_t base, thickness, transition, top_transition;
};

struct Version {
  int major;
  Packet ig_control, atmosphere, weather;
  LayerOffsets layer;
};

constexpr Version kVersion3{3, {1, 24, 0}, {10, 32, 8}, {12, 56, 12}, {24, 28, 32, 32}};
constexpr Version kVersion4{4, {0, 24, 0}, {9, 32, 12}, {11, 72, 16}, {28, 32, 36, 64}};
constexpr double kEyeHeight = 3;  // metres; a renderer has its camera's

/// Numbers in a byte order.
struct Order {
  std::endian order;

  template <typename T>
  T read(Bytes bytes, std::size_t offset) const {
    std::array<std::uint8_t, sizeof(T)> number;
    std::ranges::copy(bytes.subspan(offset, sizeof(T)), number.begin());
    if (order != std::endian::native) std::ranges::reverse(number);
    return std::bit_cast<T>(number);
  }
};

[[noreturn]] void refuse(const std::string& reason) { throw std::invalid_argument(reason); }

/// The fogs of a host. CIGI does not say by which contrast it means its visibility; litfog's default is that of the
/// meteorological optical range.
struct Weather {
  litfog::Fog atmosphere;
  std::array<litfog::FogLayer, 4> layers;  // ground fog, then clouds; the default is no fog
  std::array<double, 4> upper_bands{};     // metres

  /// The air that it makes. Layers nearer to the eye take their knots first.
  ///
  /// ignored  what of the weather the air lacks; empty: nothing
  litfog::Atmosphere air(std::string& ignored) const {
    ignored.clear();
    const auto ignore = [&](const std::string& what) { ignored += (ignored.empty() ? "" : ", ") + what; };
    std::array<std::size_t, 4> nearest{0, 1, 2, 3};
    std::ranges::stable_sort(nearest, {}, [&](std::size_t i) {
      return std::max({layers[i].base - kEyeHeight, kEyeHeight - layers[i].top, 0.});
    });
    litfog::Atmosphere air{.fog = atmosphere};
    std::vector<litfog::FogLayer> taken;
    for (const std::size_t i : nearest) {
      const std::string name = "layer " + std::to_string(i);
      taken.push_back(layers[i]);
      try {
        air.profile = litfog::make_density_profile(taken);
        if (layers[i].transition != upper_bands[i]) ignore("the width of the upper band of " + name);
      } catch (const std::invalid_argument&) {  // too many knots, for each layer is valid
        taken.pop_back();
        ignore(name);
      }
    }
    return air;
  }
};

struct Frame {
  int version;
  std::uint32_t number;
  Weather weather;
};

/// What a datagram makes of the weather before it.
///
/// throws  std::invalid_argument where any of it is wrong, so that half a datagram never counts
Frame read_frame(Bytes datagram, Weather weather) {
  if (datagram.size() < kVersion3.ig_control.size) refuse("datagram of " + std::to_string(datagram.size()) + " bytes");
  const bool is_3 = datagram[0] == kVersion3.ig_control.id && datagram[2] == kVersion3.major;
  if (!is_3 && datagram[4] != kVersion4.major) refuse("no IG Control of CIGI 3 or 4 begins it");
  const Version& version = is_3 ? kVersion3 : kVersion4;
  const std::size_t told_by = is_3 ? 6 : 0;
  const std::uint16_t little_endian = is_3 ? 0x8000 : std::uint16_t(version.ig_control.size);
  Order order{std::endian::little};
  if (order.read<std::uint16_t>(datagram, told_by) != little_endian) order.order = std::endian::big;
  if (order.read<std::uint16_t>(datagram, told_by) != little_endian) refuse("no byte order");

  Frame frame{version.major, order.read<std::uint32_t>(datagram, 8), weather};
  bool is_first = true;
  for (Bytes rest = datagram; !rest.empty(); is_first = false) {
    if (rest.size() < 4) refuse("truncated packet");
    const std::uint16_t id = is_3 ? rest[0] : order.read<std::uint16_t>(rest, 2);
    const std::size_t size = is_3 ? rest[1] : order.read<std::uint16_t>(rest, 0);
    if (size < 4 || size > rest.size()) refuse("packet " + std::to_string(id) + " of size " + std::to_string(size));
    const auto is = [&](const Packet& packet) {
      if (id == packet.id && size != packet.size)
        refuse("packet " + std::to_string(id) + " of size " + std::to_string(size));
      return id == packet.id;
    };
    const auto fog_of = [&](const Packet& packet) {
      return litfog::Fog::from_visibility(litfog::FogMode::exp, double(order.read<float>(rest, packet.visibility)));
    };
    if (is(version.ig_control) != is_first) refuse("IG Control not first and once");
    if (is(version.atmosphere)) frame.weather.atmosphere = fog_of(version.atmosphere);
    if (is(version.weather) && rest[4] < frame.weather.layers.size() && (rest[7] & 3) == 0) {
      const bool is_ground = rest[4] == 0;
      const auto number = [&](std::size_t offset) { return double(order.read<float>(rest, offset)); };
      litfog::FogLayer layer;
      frame.weather.upper_bands[rest[4]] = 0;
      if ((rest[6] & 1) != 0) {
        const double base = number(version.layer.base);
        layer = {.base = is_ground ? layer.base : base,
                 .top = base + number(version.layer.thickness),
                 .transition = number(is_ground ? version.layer.top_transition : version.layer.transition),
                 .visibility = number(version.weather.visibility)};
        frame.weather.upper_bands[rest[4]] = number(version.layer.top_transition);
      }
      if (const auto error = find_error(layer)) refuse("layer " + std::to_string(rest[4]) + ": " + to_string(*error));
      frame.weather.layers[rest[4]] = layer;
    }
    rest = rest.subspan(size);
  }
  return frame;
}

/// A UDP socket on loopback that says when the kernel received each datagram.
class Socket {
 public:
  explicit Socket(std::uint16_t port) : descriptor_(socket(AF_INET, SOCK_DGRAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    const int on = 1;
    socklen_t size = sizeof address;
    if (descriptor_ < 0 || setsockopt(descriptor_, SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof on) != 0 ||
        bind(descriptor_, reinterpret_cast<sockaddr*>(&address), size) != 0 ||
        getsockname(descriptor_, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
      throw std::system_error(errno, std::generic_category(), "no socket");
    }
    address_ = address;
  }
  ~Socket() { close(descriptor_); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  std::uint16_t port() const { return ntohs(address_.sin_port); }

  void send_to(const Socket& other, Bytes datagram) const {
    sendto(descriptor_, datagram.data(), datagram.size(), 0, reinterpret_cast<const sockaddr*>(&other.address_),
           sizeof other.address_);
  }

  /// The next datagram and the time of its receipt; throws where none comes for ten seconds.
  Bytes receive(timespec& received) {
    pollfd waiting{descriptor_, POLLIN, 0};
    if (poll(&waiting, 1, 10'000) != 1) throw std::runtime_error("no datagram for ten seconds");
    iovec part{buffer_.data(), buffer_.size()};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(timespec))> control;
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    const ssize_t size = recvmsg(descriptor_, &message, 0);
    if (size < 0) throw std::system_error(errno, std::generic_category(), "recvmsg");
    const cmsghdr* const stamp = CMSG_FIRSTHDR(&message);
    if (stamp == nullptr) throw std::runtime_error("the kernel tells no time of receipt");
    std::memcpy(&received, CMSG_DATA(stamp), sizeof received);
    return Bytes(buffer_).first(std::size_t(size));
  }

 private:
  int descriptor_;
  sockaddr_in address_{};
  std::vector<std::uint8_t> buffer_ = std::vector<std::uint8_t>(65536);  // more than any datagram
};

double microseconds_since(const timespec& time) {
  timespec now;
  clock_gettime(CLOCK_REALTIME, &now);
  return double(now.tv_sec - time.tv_sec) * 1e6 + double(now.tv_nsec - time.tv_nsec) * 1e-3;
}

/// The lights of a runway and an aircraft.
litfog::FogUpdater lights() {
  const litfog::Light edge{.color = {1, 0.87, 0.7}, .attenuation = {1, 0, 0.0019}, .density_scale = 0.4};
  const litfog::Light landing{.attenuation = {1, 0, 9.5e-5}, .cone = litfog::Cone::smoothstep(0.09, 0.15)};
  litfog::FogUpdater updater;
  for (int i = 0; i < 120; ++i) updater.add({.light = edge, .position = {i % 2 * 60 - 30, 0, -60. * (i / 2)}});
  for (const double x : {-4., 4.}) updater.add({.light = landing, .position = {x, 3, 0}, .carried = true});
  return updater;
}

void follow(Socket& socket, int datagrams) {
  litfog::FogUpdater updater = lights();
  Weather weather;
  litfog::Atmosphere air;
  std::string ignored, ignored_before;
  std::vector<double> latencies;
  int refused = 0;
  for (int i = 0; i < datagrams; ++i) {
    timespec received;
    const Bytes datagram = socket.receive(received);
    try {
      const Frame frame = read_frame(datagram, weather);
      weather = frame.weather;
      const litfog::Atmosphere before = std::exchange(air, weather.air(ignored));
      updater.set_atmosphere(air, kEyeHeight);
      latencies.push_back(microseconds_since(received));
      // Here a renderer uploads the changed ranges and the header of the air (pack_fog_header), and draws.
      if (air != before || ignored != ignored_before) {
        std::printf("frame %u, CIGI %d: density %.6g/m at the eye, %zu knots, %zu bytes of lights to upload%s%s\n",
                    frame.number, frame.version, air.fog_at(kEyeHeight).density, air.profile.count,
                    updater.statistics().bytes_dirty, ignored.empty() ? "" : "; ignored: ", ignored.c_str());
      }
      ignored_before = ignored;
    } catch (const std::invalid_argument& error) {
      ++refused;
      std::printf("refused: %s\n", error.what());
    }
  }
  std::printf("%d datagrams, %d refused", datagrams, refused);
  if (!latencies.empty()) {
    std::ranges::sort(latencies);
    const auto quantile = [&](double q) { return latencies[std::size_t(q * double(latencies.size() - 1))]; };
    std::printf(", latency median %.0f us, p99 %.0f us", quantile(0.5), quantile(0.99));
  }
  std::printf("\n");
}

/// A datagram of a host: IG Control and Atmosphere Control, in this machine's byte order.
std::vector<std::uint8_t> host_datagram(const Version& version, std::uint32_t frame, float visibility) {
  std::vector<std::uint8_t> bytes(version.ig_control.size + version.atmosphere.size);
  const auto write = [&](std::size_t offset, auto number) { std::memcpy(&bytes[offset], &number, sizeof number); };
  const auto begin = [&](std::size_t offset, const Packet& packet) {
    if (version.major == 3) {
      write(offset, std::uint8_t(packet.id));
      write(offset + 1, std::uint8_t(packet.size));
    } else {
      write(offset, std::uint16_t(packet.size));
      write(offset + 2, packet.id);
    }
  };
  begin(0, version.ig_control);
  write(version.major == 3 ? 2 : 4, std::uint8_t(version.major));
  if (version.major == 3) write(6, std::uint16_t(0x8000));
  write(8, frame);
  begin(version.ig_control.size, version.atmosphere);
  write(version.ig_control.size + version.atmosphere.visibility, visibility);
  return bytes;
}

void demo() {
  constexpr std::uint32_t kFrames = 120;
  Socket ig(0);
  const Socket host(0);
  const std::jthread sender([&] {
    auto next = std::chrono::steady_clock::now();
    for (std::uint32_t i = 0; i < kFrames; ++i) {
      host.send_to(ig, host_datagram(2 * i < kFrames ? kVersion3 : kVersion4, i, 5000 - 40.f * float(i)));
      std::this_thread::sleep_until(next += std::chrono::microseconds(16'667));
    }
  });
  follow(ig, int(kFrames));
}

/// An argument as a whole number in [least, most].
int number_of(const std::string& text, const char* name, int least, int most) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || number < least || number > most) {
    refuse(std::string(name) + " = " + text + ": must be a whole number in [" + std::to_string(least) + ", " +
           std::to_string(most) + "]");
  }
  return number;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
    if (count == 2 && std::string(arguments[1]) == "--demo") {
      demo();
    } else if (count == 3) {
      Socket socket(std::uint16_t(number_of(arguments[1], "PORT", 0, 65535)));
      const int datagrams = number_of(arguments[2], "DATAGRAMS", 1, std::numeric_limits<int>::max());
      std::printf("port %d\n", socket.port());
      follow(socket, datagrams);
    } else {
      std::fprintf(stderr, "usage: cigi_ig PORT DATAGRAMS | --demo\n");
      return 1;
    }
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
