#include <cstdlib>
#include <iostream>

#include "planner/base/contract.hpp"

void cnc::contract_failed(const char* condition, const char* file, int line) {
  if (condition != nullptr) {
    std::cerr << file << ':' << line << ": contract failed: " << condition << std::endl;
  } else {
    std::cerr << "kerfline: contract failed; KERFLINE_CONTRACT_TEXT=ON names it" << std::endl;
  }
  std::abort();
}
