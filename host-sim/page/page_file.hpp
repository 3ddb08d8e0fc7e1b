#pragma once

#include <span>
#include <string_view>

namespace sim {

/// A file of the page, compiled in.
struct PageFile {
  std::string_view path;  ///< Path of the request, such as `/view.js`.
  std::string_view content;
};

/// Files of host-sim/page, which the build embeds; `/` is index.html.
[[nodiscard]] std::span<const PageFile> page_files();

}  // namespace sim
