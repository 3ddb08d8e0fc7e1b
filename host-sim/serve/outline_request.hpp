#pragma once

#include "host-sim/serve/page_service.hpp"

struct mg_connection;

namespace sim {

/// Answers a POST whose body is a program with its outline; more than 64 MiB,
/// and anything else, is refused before it is read. @returns the status
int answer_outline(mg_connection* connection, PageService& service);

}  // namespace sim
