#pragma once

#include <span>
#include <string_view>

namespace sim {

/// File of the page, which is compiled into the program.
struct PageFile {
  std::string_view path;  ///< Path of the request, such as `/view.js`.
  std::string_view content;
};

/// Returns the files of host-sim/page, which the build embeds; `/` is index.html.
[[nodiscard]] std::span<const PageFile> page_files();

}  // namespace sim
