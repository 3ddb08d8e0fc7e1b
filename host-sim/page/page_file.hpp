#pragma once

#include <span>
#include <string_view>

namespace sim {

/// A file of the page, compiled in.
struct PageFile {
  std::string_view path;  ///< As asked for, such as `/view.js`.
  std::string_view content;
};

/// The files of host-sim/page, as the build embeds them; `/` is index.html.
[[nodiscard]] std::span<const PageFile> page_files();

}  // namespace sim
