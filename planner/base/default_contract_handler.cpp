#include <cstdio>
#include <cstdlib>

#include "planner/base/contract.hpp"

void cnc::contract_failed(const char* condition, const char* file, int line) {
  const bool has_text = condition != nullptr;
  std::fprintf(stderr,
               "%s:%d: contract failed: %s\n",
               has_text ? file : "kerfline",
               line,
               has_text ? condition : "build with KERFLINE_CONTRACT_TEXT=ON for its condition");
  std::abort();
}
