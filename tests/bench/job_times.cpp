/// Compares job times with the times that the limits allow and that other controllers need.
/// Run: build/release/tests/bench_job_times [RISE]
///
/// RISE is the time in seconds in which full acceleration is reached. With it, the jerk settings
/// are acceleration / RISE, and the optimum of motion with limited jerk is printed as well
/// (jerk_time.hpp: a motion that keeps every limit, and a lower bound of the time).

#include <cstdio>
#include <cstdlib>

#include "tests/support/jerk_time.hpp"
#include "tests/support/peer_jobs.hpp"

namespace {

void print_number(double value, int digits) {
  if (value > 0.0) {
    std::printf(" %8.*f", digits, value);
  } else {
    std::printf(" %8s", "-");
  }
}

void print_row(const proof::PeerJob& job, double rise) {
  const proof::PeerResult result = proof::run_peer_job(job, rise);
  const double bound = sim::optimal_time(result.path, result.limits);
  const double curve = sim::optimal_time(job.curve, result.limits);
  std::printf("%-24s %5.0f", job.name.c_str(), job.acceleration);
  print_number(result.seconds, 3);
  print_number(bound, 3);
  print_number(result.seconds / bound, 4);
  print_number(curve, 3);
  if (rise > 0.0) {
    const auto& path = job.curve.pieces.empty() ? result.path : job.curve;
    const sim::JerkLimitedTime time = sim::jerk_limited_time(path, result.limits);
    print_number(time.bound, 3);
    print_number(time.found, 3);
    print_number(result.seconds / time.found, 4);
  }
  print_number(job.peers.bound, 3);
  print_number(job.peers.best, 3);
  print_number(result.seconds / job.peers.best, 4);
  std::printf("  %s%s\n", job.peers.who.c_str(), result.refusals > 0 ? "  REFUSED" : "");
}

}  // namespace

int main(int count, char** arguments) {
  const double rise = count > 1 ? std::strtod(arguments[1], nullptr) : 0.0;
  std::printf("%-24s %5s %8s %8s %8s %8s%s %8s %8s %8s  %s\n",
              "job, seconds",
              "a",
              "time",
              "optimum",
              "ratio",
              "smooth",
              rise > 0.0 ? "  jerk >=  jerk <=    ratio" : "",
              "optimum*",
              "peer*",
              "ratio",
              "best honest peer");
  for (const proof::PeerJob& job : proof::peer_jobs()) print_row(job, rise);
  std::printf(
      "optimum: of acceleration on the path that is driven, its corners rounded within $11; "
      "smooth: on the curve that short\nlines stand for, which they may beat by as much as "
      "they cut it short. * measured elsewhere, where the job\nis the same; all others are of "
      "the same kind only.\n");
  return 0;
}
