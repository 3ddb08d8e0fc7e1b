#pragma once

#include <string_view>

struct mg_connection;

namespace sim {

/// Answers a request with 200 and a document. @returns the status
int send_document(mg_connection* connection, std::string_view type, std::string_view content);

/// Answers with another status and a sentence for people. @returns the status
int send_refusal(mg_connection* connection, int status, std::string_view reason);

}  // namespace sim
