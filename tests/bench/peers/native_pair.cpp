/// Compares our offset with that of a peer, whose WebAssembly wasm2c has translated to C. Both are
/// native and run alternately in one process. offset_peer.mjs builds this program, passes the cases
/// to it and prints the results.
///
/// usage: native_pair PAIRS < CASES
/// A case is a line: distance, number of vertices, and x, y and bulge of each vertex. Prints a line
/// of JSON: the number of cases whose areas differ by more than 1e-6 of the area that the distance
/// sweeps, and elements per second.

#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "peer.h"

extern "C" {
int our_add(std::uint32_t vertices);
double* our_vertices(int number);
int our_offset(int number, double distance_mm);
double our_area();
}

// Functions that the peer calls while it offsets: it hands over each polyline by its address, to a
// list that it creates first. It must not call any other function.
#define FROM_PEER(name) Z_Z2EZ2Fcavalier_contours_web_ffi_bgZ2EjsZ_##name
#define HOST struct Z_Z2EZ2Fcavalier_contours_web_ffi_bgZ2Ejs_instance_t*
namespace {
std::vector<u32> handed_over;
}
extern "C" {
u32 FROM_PEER(__wbg_new_59cb74e423758ede)(HOST) { return 0; }
u32 FROM_PEER(__wbg_new_8528c110a833413f)(HOST) { return 0; }
u32 FROM_PEER(__wbg_new_d14bf16e62c6b3d5)(HOST) { return 0; }
u32 FROM_PEER(__wbg_polyline_new)(HOST, u32 address) { return address; }
u32 FROM_PEER(__wbg_push_17a514d8ab666103)(HOST, u32, u32 address) {
  handed_over.push_back(address);
  return 0;
}
void FROM_PEER(__wbindgen_object_drop_ref)(HOST, u32) {}
void FROM_PEER(__wbg_alert_d6bb738915c282ac)(HOST, u32, u32) { std::abort(); }
void FROM_PEER(__wbg_error_4bb6c2a97407129a)(HOST, u32, u32) { std::abort(); }
void FROM_PEER(__wbg_log_5e80869250f2c311)(HOST, u32, u32) { std::abort(); }
u32 FROM_PEER(__wbg_newwithlength_657cd32d6434e810)(HOST, u32) { std::abort(); }
u32 FROM_PEER(__wbg_newwithlength_e02e34b5c96ac015)(HOST, u32) { std::abort(); }
u32 FROM_PEER(__wbg_set_61642586f7156f4a)(HOST, u32, u32, u32) { std::abort(); }
void FROM_PEER(__wbg_setindex_39fb81a38486d25d)(HOST, u32, u32, f64) { std::abort(); }
void FROM_PEER(__wbg_setindex_4ff06c39074495a5)(HOST, u32, u32, u32) { std::abort(); }
void FROM_PEER(__wbg_stack_558ba5917b466edd)(HOST, u32, u32) { std::abort(); }
void FROM_PEER(__wbindgen_debug_string)(HOST, u32, u32) { std::abort(); }
u32 FROM_PEER(__wbindgen_number_new)(HOST, f64) { std::abort(); }
u32 FROM_PEER(__wbindgen_string_new)(HOST, u32, u32) { std::abort(); }
void FROM_PEER(__wbindgen_throw)(HOST, u32, u32) { std::abort(); }
}

namespace {

// Long enough that the resolution of the clock does not matter.
constexpr double kBlockSeconds = 0.6;

struct Case {
  double distance_mm = 0.0;
  double chords_mm = 0.0;
  int ours = 0;
  u32 peers = 0;
};

Z_peer_instance_t peer;

u32 add_to_peer(const std::vector<double>& vertices) {
  const auto count = static_cast<u32>(vertices.size());
  const u32 place = Z_peerZ___wbindgen_malloc(&peer, 8 * count);
  std::memcpy(Z_peerZ_memory(&peer)->data + place, vertices.data(), 8 * vertices.size());
  return Z_peerZ_polyline_new(&peer, place, count, 1);
}

bool read_case(std::vector<Case>& cases, std::size_t& elements) {
  Case one;
  std::uint32_t count = 0;
  if (std::scanf("%lf %u", &one.distance_mm, &count) != 2) return false;
  std::vector<double> vertices(3 * std::size_t{count});
  for (double& number : vertices) {
    if (std::scanf("%lf", &number) != 1) return false;
  }
  for (std::size_t i = 0; i < vertices.size(); i += 3) {
    const std::size_t next = (i + 3) % vertices.size();
    one.chords_mm += std::hypot(vertices[next] - vertices[i], vertices[next + 1] - vertices[i + 1]);
  }
  one.ours = our_add(count);
  std::memcpy(our_vertices(one.ours), vertices.data(), 8 * vertices.size());
  one.peers = add_to_peer(vertices);
  cases.push_back(one);
  elements += count;
  return true;
}

/// The peer's positive distance is to the left.
void offset_by_peer(const Case& one) {
  handed_over.clear();
  Z_peerZ_polyline_parallelOffset(&peer, one.peers, -one.distance_mm, 0);
}

bool differs(const Case& one) {
  our_offset(one.ours, one.distance_mm);
  offset_by_peer(one);
  double area = 0.0;
  for (const u32 polyline : handed_over) {
    area += Z_peerZ_polyline_area(&peer, polyline);
    Z_peerZ___wbg_polyline_free(&peer, polyline);
  }
  const double swept = one.chords_mm * std::abs(one.distance_mm);
  return !(std::abs(area - our_area()) <= 1.0e-6 * swept);
}

void run_ours(const std::vector<Case>& cases) {
  for (const Case& one : cases) our_offset(one.ours, one.distance_mm);
}

/// The peer's results are freed immediately.
void run_peer(const std::vector<Case>& cases) {
  for (const Case& one : cases) {
    offset_by_peer(one);
    for (const u32 polyline : handed_over) Z_peerZ___wbg_polyline_free(&peer, polyline);
  }
}

template <typename Run>
double seconds(const Run& run, const std::vector<Case>& cases, int rounds) {
  const auto now = [] {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1.0e-9 * static_cast<double>(time.tv_nsec);
  };
  const double begun = now();
  for (int i = 0; i < rounds; ++i) run(cases);
  return now() - begun;
}

template <typename Run>
int rounds_of(const Run& run, const std::vector<Case>& cases) {
  seconds(run, cases, 1);
  return std::max(1, static_cast<int>(kBlockSeconds / seconds(run, cases, 1)));
}

void print(const char* name, const std::vector<double>& rates) {
  std::printf(", \"%s\": [", name);
  for (std::size_t i = 0; i < rates.size(); ++i) std::printf("%s%.0f", i > 0 ? ", " : "", rates[i]);
  std::printf("]");
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  const int pairs = std::atoi(arguments[1]);
  wasm_rt_init();
  Z_peer_init_module();
  Z_peer_instantiate(&peer, nullptr);
  std::vector<Case> cases;
  std::size_t elements = 0;
  while (read_case(cases, elements)) {
  }
  const auto differ = std::count_if(cases.begin(), cases.end(), differs);
  const int our_rounds = rounds_of(run_ours, cases);
  const int peer_rounds = rounds_of(run_peer, cases);
  std::vector<double> ours;
  std::vector<double> peers;
  const auto total = static_cast<double>(elements);
  for (int i = 0; i < pairs; ++i) {
    ours.push_back(total * our_rounds / seconds(run_ours, cases, our_rounds));
    peers.push_back(total * peer_rounds / seconds(run_peer, cases, peer_rounds));
  }
  std::printf("{\"differ\": %ld", static_cast<long>(differ));
  print("ours", ours);
  print("peer", peers);
  std::printf("}\n");
}
